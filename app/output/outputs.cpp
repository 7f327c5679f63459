#include "app/output/outputs.hpp"

#include <algorithm>
#include <map>

#include "app/output/dump.hpp"
#include "app/output/fine_picture.hpp"
#include "app/output/image_file.hpp"
#include "app/output/stated_error.hpp"
#include "app/output/stats.hpp"
#include "app/output/video_file.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/parser.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/settings/nearest.hpp"

namespace caustics::app {

namespace {

// A layer of an EXR file and the texture channels it is made of.
struct Layer {
  const char* name;
  const char* meaning;
  const char* texture;
  int first = 0, count = 3;
  bool in_world = false;  // scene space, written in the glTF world's coordinates
};

// Not a texture: made from the ledgers and these.
constexpr char kStatedError[] = "stated error";
constexpr const char* kForStatedError[] = {"aov_caustic", "aov_position", "view_position"};

constexpr Layer kLayers[] = {
    {"beauty", "what the camera sees, nit; the channels R, G, B, A", "beauty", 0, 4},
    {"caustic", "illuminance by caustics, lux; 0 on casters", "aov_caustic"},
    {"direct", "illuminance by the lights after shadows, lux; 0 on casters", "aov_direct"},
    {"position", "glTF world coordinates, metres", "aov_position", 0, 3, true},
    {"normal", "unit, world axes", "aov_normal"},
    {"depth", "metres along the view axis", "aov_normal", 3, 1},
    {"coverage", "1 where there is a surface, else 0", "aov_position", 3, 1},
    {"error", "stated error of caustic, lux: of means over blocks of pixels", kStatedError},
};

bool is_stated_error(const Layer& layer) { return std::string_view(layer.texture) == kStatedError; }

const Layer& find_layer(const std::string& name) {
  const auto found = std::find_if(std::begin(kLayers), std::end(kLayers),
                                  [&](const Layer& layer) { return layer.name == name; });
  if (found != std::end(kLayers)) return *found;
  std::vector<std::string> names;
  for (const Layer& layer : kLayers) names.emplace_back(layer.name);
  throw Error(ExitCode::WrongUsage, "--aov has no layer " + in_quotes(name) + suggestion(name, names));
}

enum class Encoding { Png, Jpeg, Tiff, Exr, Hdr };

// By the file's extension; those of four characters are told.
struct PictureFormat {
  std::string_view extension;
  OutputKind kind;
  Encoding encoding;
};

constexpr PictureFormat kPictureFormats[] = {
    {".png", OutputKind::Display, Encoding::Png},   {".jpg", OutputKind::Display, Encoding::Jpeg},
    {".tif", OutputKind::Display, Encoding::Tiff},  {".exr", OutputKind::Linear, Encoding::Exr},
    {".hdr", OutputKind::Linear, Encoding::Hdr},    {".jpeg", OutputKind::Display, Encoding::Jpeg},
    {".tiff", OutputKind::Display, Encoding::Tiff},
};

// Null: a film's, or no known one.
const PictureFormat* format_of(const std::filesystem::path& file) {
  const std::string extension = is_standard_output(file) ? ".png" : lower_extension(file);
  const auto found = std::find_if(std::begin(kPictureFormats), std::end(kPictureFormats),
                                  [&](const PictureFormat& format) { return format.extension == extension; });
  return found == std::end(kPictureFormats) ? nullptr : found;
}

bool is_exr(const std::filesystem::path& file) {
  const PictureFormat* format = format_of(file);
  return format && format->encoding == Encoding::Exr;
}

// Without a list the picture's light alone; a list says all that is written.
std::vector<std::string> layers_of(const OutputRequest& request) {
  return request.layers.empty() ? std::vector<std::string>{"beauty"} : request.layers;
}

void write_layers(const std::filesystem::path& path, const OutputRequest& request, const RenderedFrame& frame,
                  const std::vector<LightLedger>& ledgers) {
  std::map<std::string, Image> images;
  std::vector<ExrChannel> channels;
  for (const std::string& name : layers_of(request)) {
    const Layer& layer = find_layer(name);
    if (!images.count(layer.texture))
      images[layer.texture] =
          is_stated_error(layer) ? stated_error(frame, ledgers) : frame.read(layer.texture);
    const Image& image = images[layer.texture];
    // Beauty is what a viewer shows, so its channels carry no prefix.
    const std::string prefix = name == "beauty" ? "" : name + ".";
    for (int c = 0; c < layer.count; ++c) {
      channels.push_back({prefix + "RGBA"[c], &image, layer.first + c,
                          layer.in_world ? frame.scene().origin[c] : 0.0, layer.in_world ? 3 : -1});
    }
  }
  write_exr(path, channels);
}

void write_output(const std::filesystem::path& file, const OutputRequest& request, const RenderedFrame& frame,
                  const std::vector<LightLedger>& ledgers) {
  switch (format_of(file)->encoding) {
    case Encoding::Png:
      return write_png(file, frame.look_at("picture"));
    case Encoding::Jpeg:
      return write_picture(file, ImageFormat::Jpeg, frame.look_at("picture"));
    case Encoding::Tiff:
      return write_picture(file, ImageFormat::Tiff, fine_picture(frame));
    case Encoding::Exr:
      return write_layers(file, request, frame, ledgers);
    case Encoding::Hdr:
      return write_picture(file, ImageFormat::Hdr, frame.look_at("beauty"));
  }
}

std::vector<std::string> textures_of_layers(const OutputRequest& request) {
  std::vector<std::string> textures;
  for (const std::string& name : layers_of(request)) {
    const Layer& wanted = find_layer(name);
    if (is_stated_error(wanted)) {
      textures.insert(textures.end(), std::begin(kForStatedError), std::end(kForStatedError));
    } else {
      textures.emplace_back(wanted.texture);
    }
  }
  return textures;
}

}  // namespace

OutputKind output_kind(const std::filesystem::path& file) {
  if (is_video(file)) return OutputKind::Film;
  const PictureFormat* format = format_of(file);
  return format ? format->kind : OutputKind::Unknown;
}

std::string known_outputs() {
  std::string text;
  for (const PictureFormat& format : kPictureFormats)
    if (format.extension.size() == 4) text.append(format.extension).append(", ");
  return text + ".mp4, .mkv, .webm, .gif";
}

std::vector<std::string> parse_layers(const std::string& list) {
  std::vector<std::string> layers;
  for (std::size_t start = 0; start <= list.size();) {
    const std::size_t end = std::min(list.find(',', start), list.size());
    const std::string name = find_layer(list.substr(start, end - start)).name;
    if (std::find(layers.begin(), layers.end(), name) == layers.end()) layers.push_back(name);
    start = end + 1;
  }
  return layers;
}

void list_layers(Parser& parser) {
  for (const Layer& layer : kLayers)
    parser.list("Layers for --aov, of the first surface that is hit", layer.name, {layer.meaning});
}

void check_outputs(const OutputRequest& request) {
  bool exr = false;
  for (const std::filesystem::path& file : request.files) {
    if (output_kind(file) == OutputKind::Unknown)
      throw Error(ExitCode::WrongUsage, one_line(file.string()) +
                                            ": the name says the format, and is to end in one of " +
                                            known_outputs() + "; or - for a PNG to standard output");
    exr = exr || is_exr(file);
  }
  if (!request.layers.empty() && !exr) {
    throw Error(ExitCode::WrongUsage, "--aov needs an EXR output: add -o FILE.exr");
  }
}

bool are_for_display(const OutputRequest& request) {
  return std::none_of(request.files.begin(), request.files.end(), [](const std::filesystem::path& file) {
    return output_kind(file) == OutputKind::Linear;
  });
}

std::vector<std::string> textures_for(const OutputRequest& request) {
  std::vector<std::string> textures;
  for (const std::filesystem::path& file : request.files) {
    if (is_exr(file)) {
      for (std::string& texture : textures_of_layers(request)) textures.push_back(std::move(texture));
    } else {
      const PictureFormat* format = format_of(file);
      const bool linear = format && format->kind == OutputKind::Linear;
      textures.emplace_back(linear ? "beauty" : "picture");
      if (format && format->encoding == Encoding::Tiff) textures.emplace_back(kForFinePicture);
    }
  }
  return textures;
}

void write_outputs(const OutputRequest& request, const RenderedFrame& frame,
                   const std::vector<LightLedger>& ledgers) {
  for (const std::filesystem::path& file : request.files) {
    if (!is_video(file)) write_output(file, request, frame, ledgers);
  }
}

bool wants_ledgers(const OutputRequest& request) {
  return std::find(request.layers.begin(), request.layers.end(), "error") != request.layers.end();
}

namespace {

// An attachment of a dump is read back and encoded; its picture is painted from its values, sorted.
std::uint64_t dumping_bytes(const FramePlan& plan, bool pictures) {
  constexpr std::uint64_t kValues = 16, kPainted = 32;  // a texel
  std::uint64_t texels = 0;
  for (const PlannedTexture& texture : plan.textures)
    texels = std::max(texels,
                      static_cast<std::uint64_t>(texture.width) * static_cast<std::uint64_t>(texture.height));
  return texels * (kValues + (pictures ? kPainted : 0)) + plan.passes.size() * kBytesOfDumpedPass;
}

}  // namespace

std::uint64_t writing_bytes(const PlannedFrame& frame, const OutputRequest& request,
                            const WrittenBeside& beside) {
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(frame.settings.width) * static_cast<std::uint64_t>(frame.settings.height);
  std::uint64_t most = 0;
  bool by_library = beside.dumped;
  for (const std::filesystem::path& file : request.files) {
    const PictureFormat* format = format_of(file);
    if (!format) continue;  // a film's rows go to another program
    by_library = by_library || format->encoding != Encoding::Png;
    if (format->encoding == Encoding::Exr) {
      // Each layer as it is read back, 16 bytes a pixel; compressed, hardly anything comes to that.
      most = std::max(most, 16 * pixels * layers_of(request).size());
    } else {
      most =
          std::max(most, (format->encoding == Encoding::Png ? 6 : 32) * pixels);  // bytes, or floats, twice
    }
  }
  if (beside.dumped) most = std::max(most, dumping_bytes(frame.plan, beside.pictures));
  if (beside.stats) most = std::max<std::uint64_t>(most, frame.plan.passes.size() * kBytesOfPassInStats);
  return most + (by_library && !is_image_io_loaded() ? kImageIoBytes : 0);
}

}  // namespace caustics::app
