#include "pipeline/scene/gltf/textures.hpp"

#include <algorithm>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/gltf/resources.hpp"

namespace caustics::gltf {

namespace {

// Texel channel c of four, whatever the file's channels: grey spreads, missing alpha is opaque.
std::size_t source_channel(int c, int channels) {
  if (c == 3) return static_cast<std::size_t>(channels) - 1;
  return channels < 3 ? 0 : static_cast<std::size_t>(c);
}
bool has_alpha(int channels) { return channels == 2 || channels == 4; }

std::vector<float> color_table(double largest) {
  std::vector<float> table(static_cast<std::size_t>(largest) + 1);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double linear = exact::srgb_to_linear(static_cast<double>(i) / largest);
    table[i] = stored_value(Format::RGBA16F, static_cast<float>(linear));
  }
  return table;
}

std::vector<float> plain_table(double largest, Format format) {
  std::vector<float> table(static_cast<std::size_t>(largest) + 1);
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = stored_value(format, static_cast<float>(static_cast<double>(i) / largest));
  }
  return table;
}

int halved(int side, int halvings) { return std::max(1, side >> halvings); }

// Fine data keep every bit of 8 and 16 bits a channel: light that normals bend shows their steps, and
// llvmpipe does not round what it reads of 8-bit textures to the nearest float.
//
// `stored`: the texels of `pixels`, of 8 or of 16 bits. Each texel of the image is the mean of 2^halvings
// texels along both sides; where these do not fill a last one, they are left out.
template <class Integer>
Image to_image(const Pixels& pixels, const std::vector<Integer>& stored, Reading reading, int halvings) {
  const Format format = reading == Reading::FineData ? Format::RGBA32F : Format::RGBA16F;
  const std::vector<float> plain = plain_table(pixels.largest, format);
  const std::vector<float> color = reading == Reading::Color ? color_table(pixels.largest) : plain;
  Image image(format, halved(pixels.width, halvings), halved(pixels.height, halvings));
  const int across = std::min(1 << halvings, pixels.width), down = std::min(1 << halvings, pixels.height);
  const auto channels = static_cast<std::size_t>(pixels.channels);
  const auto width = static_cast<std::size_t>(pixels.width);
  const auto mean = [&](const std::vector<float>& table, const Integer* texel) {
    if (halvings == 0) return table[*texel];
    double sum = 0.0;
    for (int row = 0; row < down; ++row)
      for (int column = 0; column < across; ++column)
        sum += static_cast<double>(
            table[texel[(static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)) *
                        channels]]);
    return stored_value(format, static_cast<float>(sum / (across * down)));
  };
  float* out = image.values.data();
  for (int y = image.height() - 1; y >= 0; --y) {  // row 0 is the bottom one
    const Integer* texel = stored.data() + static_cast<std::size_t>(y * down) * width * channels;
    for (int x = 0; x < image.width(); ++x, texel += static_cast<std::size_t>(across) * channels) {
      for (int c = 0; c < 3; ++c) *out++ = mean(color, texel + source_channel(c, pixels.channels));
      *out++ = has_alpha(pixels.channels) ? mean(plain, texel + source_channel(3, pixels.channels)) : 1;
    }
  }
  return image;
}

Image to_image(const Pixels& pixels, Reading reading, int halvings) {
  return pixels.bytes.empty() ? to_image(pixels, pixels.integers, reading, halvings)
                              : to_image(pixels, pixels.bytes, reading, halvings);
}

// By channel; -1 for an alpha that the image does not have.
std::array<double, 4> means_of(const Pixels& pixels) {
  const auto channels = static_cast<std::size_t>(pixels.channels);
  // Sums of integers: exact, so the order does not matter.
  std::array<std::uint64_t, 4> sums{};
  const auto add = [&](const auto& stored) {
    for (std::size_t i = 0; i < stored.size(); i += channels)
      for (std::size_t c = 0; c < channels; ++c) sums[c] += stored[i + c];
  };
  add(pixels.bytes);
  add(pixels.integers);
  std::array<double, 4> means{-1, -1, -1, -1};
  const double texels = static_cast<double>(pixels.width) * static_cast<double>(pixels.height);
  for (int c = 0; c < 3 + has_alpha(pixels.channels); ++c)
    means[static_cast<std::size_t>(c)] =
        static_cast<double>(sums[source_channel(c, pixels.channels)]) / (pixels.largest * texels);
  return means;
}

// KHR_texture_transform, then v counted from the bottom. The extension turns textures
// counter-clockwise as seen with v pointing down.
glm::mat3 uv_transform(const Cursor& info) {
  const Cursor transform = info.member("extensions").member("KHR_texture_transform");
  const std::vector<double> offset = transform.member("offset").numbers(2);
  const std::vector<double> scale = transform.member("scale").numbers(2);
  double angle = transform.member("rotation").number(0.0);
  if (!(angle > -1e5 && angle < 1e5)) angle = 0;
  double sine = 0, cosine = 1;
  exact::sin_cos(angle, sine, cosine);
  const double sx = scale.empty() ? 1 : scale[0], sy = scale.empty() ? 1 : scale[1];
  const double ox = offset.empty() ? 0 : offset[0], oy = offset.empty() ? 0 : offset[1];
  // u' = sx cos u + sy sin v + ox; v' = 1 - (-sx sin u + sy cos v + oy); columns of the matrix:
  return glm::mat3(glm::vec3(sx * cosine, sx * sine, 0), glm::vec3(sy * sine, -sy * cosine, 0),
                   glm::vec3(ox, 1 - oy, 1));
}

// OpenGL's numbers, as glTF has them (5.26.3).
Wrap wrap_of(Context& context, const Cursor& mode) {
  constexpr int kRepeat = 10497, kClampToEdge = 33071, kMirroredRepeat = 33648;
  const int number = static_cast<int>(mode.integer(0, 65535, kRepeat));
  if (number == kClampToEdge) return Wrap::Clamp;
  if (number == kMirroredRepeat) return Wrap::Mirror;
  if (number != kRepeat) context.note(mode.path() + " is no wrap mode of glTF: the texture repeats.");
  return Wrap::Repeat;
}

// The note of a failed resource: its message without the file's name and the advice.
std::string reason(const Context& context, const Error& error) {
  std::string what = error.what();
  const std::string file = printable(context.path().string(), 400) + ": ";
  if (what.compare(0, file.size(), file) == 0) what = what.substr(file.size());
  return what.substr(0, what.rfind("; "));
}

}  // namespace

int Textures::uv_set(const Cursor& info) {
  const Cursor transform = info.member("extensions").member("KHR_texture_transform");
  return static_cast<int>(
      transform.member("texCoord").integer(0, 1000, info.member("texCoord").integer(0, 1000, 0)));
}

std::optional<int> Textures::image_index(const Cursor& info) {
  const Cursor textures = root_.member("textures");
  const int index = info.member("index").index("textures", textures.size());
  const Cursor texture = textures.element(static_cast<std::size_t>(index));
  const Cursor webp = texture.member("extensions").member("EXT_texture_webp").member("source");
  const Cursor image = webp.present() ? webp : texture.member("source");
  const auto source = image.optional_index("images", root_.member("images").size());
  if (!source) {
    context_.note(texture.path() + " has no PNG, JPEG or WebP image and is left out.");
    return std::nullopt;
  }
  return firsts_[static_cast<std::size_t>(*source)];
}

// How the texture's sampler reads it; `info` stands on one that image_index has accepted.
void Textures::read_sampler(const Cursor& info, TextureUse& use) const {
  const Cursor textures = root_.member("textures"), samplers = root_.member("samplers");
  const Cursor texture =
      textures.element(static_cast<std::size_t>(info.member("index").index("textures", textures.size())));
  const auto sampler = texture.member("sampler").optional_index("samplers", samplers.size());
  if (!sampler) return;
  const Cursor how = samplers.element(static_cast<std::size_t>(*sampler));
  use.wrap_u = wrap_of(context_, how.member("wrapS"));
  use.wrap_v = wrap_of(context_, how.member("wrapT"));
  use.nearest = how.member("magFilter").integer(0, 65535, 9729) == 9728;
}

Textures::Source::Source(Context& context, const Cursor& image, const Model& model) {
  try {
    const Cursor view = image.member("bufferView");
    if (view.present()) {
      const BufferView& v =
          model.views[static_cast<std::size_t>(view.index("bufferViews", model.views.size()))];
      if (v.length == 0) view.fail("has no bytes", kExportAgain);  // used images have checked views
      bytes = {model.buffers[v.buffer].data() + v.offset, v.length};
    } else {
      file = read_uri(context, image.member("uri"));
      bytes = file;
    }
    header = sniff_image(bytes);
    problem = header.problem;
    if (header.kind == ImageKind::Hdr || header.kind == ImageKind::Exr) problem = "is no PNG, JPEG or WebP";
    if (!problem.empty()) problem = image.path() + " " + problem;
  } catch (const Error& error) {
    if (error.code() != ExitCode::BadInput) throw;
    problem = reason(context, error);
  }
}

std::uint64_t Textures::Source::texels_kept() const {
  const auto side = [&](int whole) { return static_cast<std::uint64_t>(halved(whole, halvings)); };
  return problem.empty() ? readings.size() * side(header.width) * side(header.height) : 0;
}

// By image: the first one of the same bytes, which are decoded once. Those of data URIs are not compared.
std::vector<int> Textures::first_alike(const Cursor& images) {
  std::vector<int> firsts;
  std::map<std::string, int> first_of;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Cursor view = images.element(i).member("bufferView"), uri = images.element(i).member("uri");
    std::string place = "image " + std::to_string(i);
    try {
      if (view.present()) {
        place = "view " + std::to_string(view.integer(0, std::int64_t{1} << 53));
      } else if (const std::string text = uri.string(""); !text.starts_with("data:")) {
        place = "file " + text;
      }
    } catch (const Error&) {  // what is no number or no text is named when the image is read
    }
    firsts.push_back(first_of.try_emplace(place, static_cast<int>(i)).first->second);
  }
  return firsts;
}

Textures::Source& Textures::source_of(int index) {
  const auto found = sources_.find(index);
  if (found != sources_.end()) return found->second;
  const Cursor image = root_.member("images").element(static_cast<std::size_t>(index));
  return sources_.try_emplace(index, context_, image, model_).first->second;
}

void Textures::fit() {
  surveying_ = false;
  const auto& options = context_.options();
  const auto sum = [&] {
    std::uint64_t texels = 0;
    for (const auto& [index, source] : sources_) texels += source.texels_kept();
    return texels;
  };
  for (auto& [index, source] : sources_) {
    const ImageHeader& header = source.header;
    const bool refused = header.width > options.max_image_side || header.height > options.max_image_side ||
                         header.texels() > options.max_image_pixels;
    if (refused) source.readings.clear();  // decode_image says so
  }
  while (sum() > options.max_image_pixels) {
    const auto largest = std::max_element(sources_.begin(), sources_.end(), [](const auto& a, const auto& b) {
      return a.second.texels_kept() < b.second.texels_kept();
    });
    ++largest->second.halvings;
  }
  std::uint64_t decoding = 0;
  for (const auto& [index, source] : sources_)
    if (source.problem.empty()) decoding = std::max(decoding, source.header.decoding_bytes());
  // With the coarser levels, which are made when nothing is decoded any more.
  const std::uint64_t texels = sum() * kTexelBytes;
  context_.take_memory(std::max(texels + decoding, texels + texels / 8 * 3), "images");
}

bool Textures::decode(int index, Source& source) {
  const auto& options = context_.options();
  if (source.problem.empty()) {
    Pixels pixels;
    std::string problem;
    if (decode_image(source.bytes, source.header.kind, options.max_image_side, options.max_image_pixels,
                     pixels, problem)) {
      source.means = means_of(pixels);
      for (const Reading reading : source.readings)
        source.ready[reading] = to_image(pixels, reading, source.halvings);
      const auto size = [&](int halvings) {
        return std::to_string(halved(pixels.width, halvings)) + "x" +
               std::to_string(halved(pixels.height, halvings));
      };
      if (source.halvings > 0)
        context_.note("images[" + std::to_string(index) + "] is used at " + size(source.halvings) +
                      " instead of " + size(0) + ": the scene's images together have more than " +
                      grouped(options.max_image_pixels) + " texels.");
    } else {
      source.problem = root_.member("images").element(static_cast<std::size_t>(index)).path() + " " + problem;
    }
  }
  source.is_decoded = true;
  source.file = {};
  if (!source.problem.empty()) context_.note(source.problem + "; textures that use it are left out.");
  return source.problem.empty();
}

TextureUse Textures::use(const Cursor& info, Reading reading) {
  TextureUse result;
  if (!info.present()) return result;
  const auto index = image_index(info);
  if (!index) return result;
  result.uv_transform = uv_transform(info);
  read_sampler(info, result);
  Source& source = source_of(*index);
  if (surveying_) {
    source.readings.insert(reading);
    return result;
  }
  const auto key = std::make_pair(*index, reading);
  const auto known = loaded_.find(key);
  if (known != loaded_.end()) {
    result.image = known->second;
    return result;
  }
  if (!source.is_decoded) decode(*index, source);
  const auto ready = source.ready.find(reading);
  if (ready != source.ready.end()) {
    result.image = static_cast<int>(images_.size());
    images_.push_back(std::move(ready->second));
    source.ready.erase(ready);
  }
  loaded_[key] = result.image;
  return result;
}

std::pair<float, float> Textures::alpha_range(int image) {
  const auto [known, is_new] = alpha_ranges_.try_emplace(image, 1.0f, 0.0f);
  if (is_new) {
    auto& [least, most] = known->second;
    const std::vector<float>& values = images_[static_cast<std::size_t>(image)].values;
    for (std::size_t i = 3; i < values.size(); i += 4) {
      least = std::min(least, values[i]);
      most = std::max(most, values[i]);
    }
  }
  return known->second;
}

std::optional<double> Textures::mean(const Cursor& info, int channel) {
  if (!info.present()) return std::nullopt;
  const auto index = image_index(info);
  if (!index) return std::nullopt;
  Source& source = source_of(*index);
  if (surveying_) return std::nullopt;
  if (!source.is_decoded) decode(*index, source);
  const double value = source.means[static_cast<std::size_t>(channel)];
  return value < 0 ? std::nullopt : std::optional<double>(value);
}

}  // namespace caustics::gltf
