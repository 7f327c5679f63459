// Turns glTF textures into images of the scene, each image once for each way of reading it, and decoded once.
//
// All that a file's materials use is known before the first image is decoded: the materials are read twice,
// at first in a survey that looks at the images' headers alone.
//
// A texture that cannot be had (missing file, other format than PNG or JPEG, too large, damaged) is
// left out with a note. Sources: glTF 2.0 sections 3.8 and 5.30; KHR_texture_transform.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
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
        firsts_(first_alike(root_.member("images"))) {}

  // In the survey, images are none and means unknown.
  bool is_surveying() const { return surveying_; }

  // Ends the survey: chooses which images are halved (LoadOptions::max_image_pixels) and takes the memory of
  // all of them. Throws Error as Context::take_memory does.
  void fit();

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
  static constexpr std::uint64_t kTexelBytes = 16;  // images hold four floats whatever their format

  // An image of the file.
  struct Source {
    Source(Context& context, const Cursor& image, const Model& model);
    std::uint64_t texels_kept() const;  // of all its readings

    Bytes file;                           // where it lies in no buffer
    std::span<const std::uint8_t> bytes;  // encoded
    ImageHeader header;
    std::string problem;         // why it is left out; empty: it is not
    std::set<Reading> readings;  // wanted
    int halvings = 0;
    bool is_decoded = false;
    std::array<double, 4> means{-1, -1, -1, -1};  // of each channel; -1: there is none
    std::map<Reading, Image> ready;               // decoded, not yet used
  };

  std::optional<int> image_index(const Cursor& info);
  static std::vector<int> first_alike(const Cursor& images);
  Source& source_of(int image);
  void read_sampler(const Cursor& info, TextureUse& use) const;
  bool decode(int image, Source& source);

  Context& context_;
  Cursor root_;
  const Model& model_;
  std::vector<int> firsts_;
  bool surveying_ = true;
  std::map<int, Source> sources_;  // by the file's images
  std::vector<Image> images_;
  std::map<std::pair<int, Reading>, int> loaded_;        // -> index, -1: failed
  std::map<int, std::pair<float, float>> alpha_ranges_;  // by index into images()
};

}  // namespace caustics::gltf
