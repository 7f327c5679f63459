#include "pipeline/scene/gltf/textures.hpp"

#include <algorithm>

#include "pipeline/gpu/error.hpp"
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

// Fine data keep every bit of 8 and 16 bits a channel: light that normals bend shows their steps, and
// llvmpipe does not round what it reads of 8-bit textures to the nearest float.
Image to_image(const Pixels& pixels, Reading reading) {
  const Format format = reading == Reading::FineData ? Format::RGBA32F : Format::RGBA16F;
  const std::vector<float> plain = plain_table(pixels.largest, format);
  const std::vector<float> color = reading == Reading::Color ? color_table(pixels.largest) : plain;
  Image image(format, pixels.width, pixels.height);
  const auto channels = static_cast<std::size_t>(pixels.channels);
  const auto width = static_cast<std::size_t>(pixels.width);
  const std::size_t places[] = {source_channel(0, pixels.channels), source_channel(1, pixels.channels),
                                source_channel(2, pixels.channels), source_channel(3, pixels.channels)};
  float* out = image.values.data();
  for (int y = pixels.height - 1; y >= 0; --y) {  // row 0 is the bottom one
    const std::uint16_t* texel = pixels.integers.data() + static_cast<std::size_t>(y) * width * channels;
    for (std::size_t x = 0; x < width; ++x, texel += channels) {
      for (int c = 0; c < 3; ++c) *out++ = color[texel[places[c]]];
      *out++ = has_alpha(pixels.channels) ? plain[texel[places[3]]] : 1;
    }
  }
  return image;
}

// By channel; -1 for an alpha that the image does not have.
std::array<double, 4> means_of(const Pixels& pixels) {
  const auto channels = static_cast<std::size_t>(pixels.channels);
  // Sums of integers: exact, so the order does not matter.
  std::array<std::uint64_t, 4> sums{};
  for (std::size_t i = 0; i < pixels.integers.size(); i += channels)
    for (std::size_t c = 0; c < channels; ++c) sums[c] += pixels.integers[i + c];
  std::array<double, 4> means{-1, -1, -1, -1};
  const double texels = static_cast<double>(pixels.integers.size()) / static_cast<double>(channels);
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
  if (!source) context_.note(texture.path() + " has no PNG, JPEG or WebP image and is left out.");
  return source;
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

Bytes Textures::image_bytes(const Cursor& image) {
  const Cursor view = image.member("bufferView");
  if (!view.present()) return read_uri(context_, image.member("uri"));
  const BufferView& v =
      model_.views[static_cast<std::size_t>(view.index("bufferViews", model_.views.size()))];
  if (v.length == 0) view.fail("has no bytes", kExportAgain);  // used images have checked views
  const auto begin = model_.buffers[v.buffer].begin() + static_cast<std::ptrdiff_t>(v.offset);
  return Bytes(begin, begin + static_cast<std::ptrdiff_t>(v.length));
}

bool Textures::decode(int index, Pixels& pixels) {
  const Cursor image = root_.member("images").element(static_cast<std::size_t>(index));
  std::string problem;
  try {
    const Bytes bytes = image_bytes(image);
    const ImageHeader header = sniff_image(bytes);
    problem = header.problem;
    if (header.kind == ImageKind::Hdr || header.kind == ImageKind::Exr) {
      problem = "is no PNG, JPEG or WebP";
    }
    if (problem.empty() &&
        decode_image(bytes, header.kind, context_.options().max_image_side, pixels_left_, pixels, problem)) {
      pixels_left_ -= static_cast<std::uint64_t>(pixels.width) * static_cast<std::uint64_t>(pixels.height);
      return true;
    }
    problem = image.path() + " " + problem;
  } catch (const Error& error) {
    problem = reason(context_, error);
  }
  context_.note(problem + "; textures that use it are left out.");
  return false;
}

const Pixels* Textures::pixels_of(int index) {
  if (decoded_ == index) return &pixels_;
  decoded_.reset();
  if (!decode(index, pixels_)) return nullptr;
  decoded_ = index;
  return &pixels_;
}

TextureUse Textures::use(const Cursor& info, Reading reading) {
  TextureUse result;
  if (!info.present()) return result;
  const auto source = image_index(info);
  if (!source) return result;
  result.uv_transform = uv_transform(info);
  read_sampler(info, result);
  const auto key = std::make_pair(*source, reading);
  const auto known = loaded_.find(key);
  if (known != loaded_.end()) {
    result.image = known->second;
    return result;
  }
  if (const Pixels* pixels = pixels_of(*source)) {
    result.image = static_cast<int>(images_.size());
    images_.push_back(to_image(*pixels, reading));
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
  const auto source = image_index(info);
  if (!source) return std::nullopt;
  auto known = means_.find(*source);
  if (known == means_.end()) {
    std::array<double, 4> means{-1, -1, -1, -1};
    if (const Pixels* pixels = pixels_of(*source)) means = means_of(*pixels);
    known = means_.emplace(*source, means).first;
  }
  const double value = known->second[static_cast<std::size_t>(channel)];
  return value < 0 ? std::nullopt : std::optional<double>(value);
}

}  // namespace caustics::gltf
