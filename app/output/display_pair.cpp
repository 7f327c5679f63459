#include "app/output/display_pair.hpp"

#include <algorithm>
#include <array>

#include "app/output/image_layers.hpp"
#include "passes/tone_map/tone_map.hpp"
#include "pipeline/gpu/owned.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

// Red, green, blue.
using Colors = std::array<const Plane*, 3>;

// False where a colour is missing.
bool find_colors(const std::vector<const ChannelDifference*>& channels, Colors& a, Colors& b) {
  int found = 0;
  for (const ChannelDifference* channel : channels) {
    const std::size_t at = std::string("RGB").find(channel_in_layer(channel->name));
    if (at == std::string::npos) continue;
    a[at] = channel->a;
    b[at] = channel->b;
    ++found;
  }
  return found == 3;
}

bool any_integers(const Colors& colors) {
  return std::any_of(colors.begin(), colors.end(), [](const Plane* each) { return each->integers; });
}

Image image_of(const Colors& colors) {
  const int width = colors[0]->view.width, height = colors[0]->view.height;
  Image image(Format::RGBA32F, width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        image.at(x, height - 1 - y, c) = colors[static_cast<std::size_t>(c)]->view.at(x, y);
      }
    }
  }
  return image;
}

double luminance_at(const Image& image, int x, int y) {
  return 0.2126 * static_cast<double>(image.at(x, y, 0)) + 0.7152 * static_cast<double>(image.at(x, y, 1)) +
         0.0722 * static_cast<double>(image.at(x, y, 2));
}

double exposure_for(const Image& truth, const std::vector<std::uint8_t>& mask) {
  std::vector<double> lit;
  std::size_t texel = 0;
  for (int y = 0; y < truth.height(); ++y) {
    for (int x = 0; x < truth.width(); ++x, ++texel) {
      if (!mask.empty() && mask[texel] == 0) continue;
      const double luminance = luminance_at(truth, x, y);
      if (luminance > 0.0) lit.push_back(luminance);
    }
  }
  if (lit.empty()) return 1.0;
  const auto nth = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() - lit.size() / 100 - 1);
  std::nth_element(lit.begin(), nth, lit.end());
  return std::clamp(0.8 / *nth, 1e-30, 1e30);
}

Image toned(Device& device, const Image& linear, double exposure) {
  const Pass pass = tone_map_pass();
  const PassDefinition definition = definition_of(pass);
  const OwnedTexture input(device, device.upload(linear));
  const OwnedTexture output(device, device.create_texture(Format::RGBA8, linear.width(), linear.height()));
  PassRun run{.definition = &definition, .colors = {output.id()}};
  run.draws.push_back({.vertex_count = 3,
                       .uniforms = pass.uniforms(PassContext{.exposure = static_cast<float>(exposure)}),
                       .textures = {input.id()}});
  device.run(run);
  return device.read_back(output.id());
}

}  // namespace

DisplayPair display_pair(const Image& a, const Image& b, const std::vector<std::uint8_t>& mask) {
  DisplayPair pair;
  const std::unique_ptr<Device> device = make_software_device();
  if (std::max(a.width(), a.height()) > device->max_texture_size()) {
    pair.impossible = "is larger than " + std::to_string(device->max_texture_size()) +
                      " texels a side, the most that the tone map takes";
    return pair;
  }
  pair.exposure = exposure_for(b, mask);
  pair.a = toned(*device, a, *pair.exposure);
  pair.b = toned(*device, b, *pair.exposure);
  return pair;
}

DisplayPair display_pair(const std::vector<const ChannelDifference*>& channels, const Selection& selection) {
  DisplayPair pair;
  Colors a{}, b{};
  if (!find_colors(channels, a, b)) {
    pair.impossible = "is no layer of colours R, G, B";
    return pair;
  }
  if (any_integers(a) != any_integers(b)) {
    pair.impossible = "holds display values in one image and linear light in the other";
    return pair;
  }
  if (!any_integers(b)) return display_pair(image_of(a), image_of(b), selection.from_bottom());
  pair.a = image_of(a);
  pair.b = image_of(b);
  return pair;
}

}  // namespace caustics::app
