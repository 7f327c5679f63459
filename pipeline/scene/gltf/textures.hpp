// Turns glTF textures into images of the scene, each image once for each way of reading it.
//
// A texture that cannot be had (missing file, other format than PNG or JPEG, too large, damaged) is
// left out with a note. Sources: glTF 2.0 sections 3.8 and 5.30; KHR_texture_transform.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "pipeline/scene/gltf/image_file.hpp"
#include "pipeline/scene/gltf/model.hpp"

namespace caustics::gltf {

// What an image's numbers stand for.
enum class Reading : std::uint8_t {
  Color,     // sRGB, decoded to linear RGBA16F; alpha as it is
  Data,      // not decoded: RGBA16F
  FineData,  // not decoded: RGBA32F, for normals and shares of light
};

class Textures {
 public:
  Textures(Context& context, const Document& document, const Model& model)
      : context_(context),
        root_(document.root(context)),
        model_(model),
        pixels_left_(context.options().max_image_pixels) {}

  // `info` may stand on nothing.
  TextureUse use(const Cursor& info, Reading reading);
  // The mean of one channel over the whole image, 0..1 without decoding.
  std::optional<double> mean(const Cursor& info, int channel);

  // Which TEXCOORD_n the texture is placed with.
  static int uv_set(const Cursor& info);

  std::vector<Image>& images() { return images_; }
  // The least and the greatest alpha of one of the images.
  std::pair<float, float> alpha_range(int image);

 private:
  std::optional<int> image_index(const Cursor& info);
  void read_sampler(const Cursor& info, TextureUse& use) const;
  // Null where it cannot be decoded.
  const Pixels* pixels_of(int image);
  bool decode(int image, Pixels& pixels);
  Bytes image_bytes(const Cursor& image);

  Context& context_;
  Cursor root_;
  const Model& model_;
  std::uint64_t pixels_left_;
  std::optional<int> decoded_;  // the image that `pixels_` are of: most are read twice in a row
  Pixels pixels_;
  std::vector<Image> images_;
  std::map<std::pair<int, Reading>, int> loaded_;        // -> index, -1: failed
  std::map<int, std::array<double, 4>> means_;           // image -> mean of each channel, -1: failed
  std::map<int, std::pair<float, float>> alpha_ranges_;  // by index into images()
};

}  // namespace caustics::gltf
