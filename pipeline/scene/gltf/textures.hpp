// Turns glTF textures into images of the scene, each image once for each way of reading it.
//
// A texture that cannot be had (missing file, other format than PNG or JPEG, too large, damaged) is
// left out with a note. Sources: glTF 2.0 sections 3.8 and 5.30; KHR_texture_transform.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "pipeline/scene/gltf/image_file.hpp"
#include "pipeline/scene/gltf/model.hpp"

namespace caustics::gltf {

class Textures {
 public:
  Textures(Context& context, const Document& document, const Model& model)
      : context_(context),
        root_(document.root(context)),
        model_(model),
        pixels_left_(context.options().max_image_pixels) {}

  // A colour texture: sRGB decoded to linear RGBA16F, alpha as it is. `info` may stand on nothing.
  TextureUse color(const Cursor& info) { return use(info, false); }
  // A normal map, or other data: RGBA32F without decoding.
  TextureUse normal(const Cursor& info) { return use(info, true); }
  // The mean of one channel over the whole image, 0..1 without decoding.
  std::optional<double> mean(const Cursor& info, int channel);

  // Which TEXCOORD_n the texture is placed with.
  static int uv_set(const Cursor& info);

  std::vector<Image>& images() { return images_; }

 private:
  TextureUse use(const Cursor& info, bool is_normal);
  std::optional<int> image_index(const Cursor& info);
  bool decode(int image, Pixels& pixels);
  Bytes image_bytes(const Cursor& image);

  Context& context_;
  Cursor root_;
  const Model& model_;
  std::uint64_t pixels_left_;
  std::vector<Image> images_;
  std::map<std::pair<int, bool>, int> loaded_;  // image and is_normal -> index, -1: failed
  std::map<int, std::array<double, 4>> means_;  // image -> mean of each channel, -1: failed
};

}  // namespace caustics::gltf
