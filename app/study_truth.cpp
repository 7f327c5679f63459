#include "app/study_truth.hpp"

#include <algorithm>

#include "app/output/display_pair.hpp"
#include "app/output/image_layers.hpp"
#include "app/selection.hpp"
#include "lab/metrics/flip.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

namespace {

constexpr int kTruthColors = 3;

[[noreturn]] void refuse_truth(const std::string& name, const std::string& why) {
  throw Error(ExitCode::BadInput, one_line(name) + ": " + why);
}

std::string truth_size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

bool belongs_to(const Plane& plane, const std::string& layer) {
  return layer_of(plane.name) == layer || plane.name == layer;
}

// The colours of a layer as an image, rows turned; a single channel counts for all three.
Image layer_image(const ImagePlanes& planes, const std::string& layer, const std::string& name) {
  const Plane* colors[kTruthColors] = {};
  const Plane* only = nullptr;
  int found = 0;
  for (const Plane& plane : planes.planes) {
    if (!belongs_to(plane, layer)) continue;
    only = plane.name == layer || !only ? &plane : only;
    const std::size_t at = std::string("RGB").find(channel_in_layer(plane.name));
    if (at == std::string::npos || plane.name == layer) continue;
    colors[at] = &plane;
    ++found;
  }
  if (found != kTruthColors && found != 0)
    refuse_truth(name, "its layer " + layer + " lacks a channel of R, G, B");
  if (found == 0 && !only)
    refuse_truth(name, "has no layer '" + layer + "', as render --aov caustic writes it");
  if (found == 0) std::fill(colors, colors + kTruthColors, only);
  const ChannelView& first = colors[0]->view;
  Image image(Format::RGBA32F, first.width, first.height);
  for (int c = 0; c < kTruthColors; ++c) {
    const ChannelView& view = colors[c]->view;
    if (view.width != first.width || view.height != first.height || colors[c]->left != 0 ||
        colors[c]->top != 0)
      refuse_truth(name, "the channels of its layer " + layer + " do not cover the picture alike");
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) image.at(x, view.height - 1 - y, c) = view.at(x, y);
  }
  return image;
}

// A layer that has the picture's size.
Image sized_layer(const ImagePlanes& planes, const std::string& layer, const std::string& name, int width,
                  int height) {
  Image image = layer_image(planes, layer, name);
  const std::string size = truth_size_text(image.width(), image.height());
  if (image.width() != width || image.height() != height)
    refuse_truth(name,
                 "is " + size + ", the study renders " + truth_size_text(width, height) + "; use -r " + size);
  return image;
}

}  // namespace

study::Mask read_mask(const std::filesystem::path& mask, int width, int height) {
  if (mask.empty()) return {};
  const std::vector<float> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  ImagePlanes planes;
  planes.planes.push_back({"R", {texels.data(), 1, width, height}, 0, 0, false});
  return select(planes, mask, {}).from_bottom();
}

study::Truth read_truth(const std::filesystem::path& file, int width, int height,
                        const std::filesystem::path& mask) {
  const std::string name = file.string();
  const ImagePlanes planes = read_planes(file);
  Image caustic = sized_layer(planes, "caustic", name, width, height);
  study::Truth truth = study::make_truth(std::move(caustic), read_mask(mask, width, height), name);
  if (std::any_of(planes.planes.begin(), planes.planes.end(),
                  [](const Plane& plane) { return belongs_to(plane, "caustic_error"); }))
    study::set_noise(truth, sized_layer(planes, "caustic_error", name, width, height), name);
  return truth;
}

study::Figures figures_against(const study::Truth& truth, const Image& caustic) {
  study::Figures figures = study::measure_against(truth, caustic);
  const DisplayPair pair = display_pair(caustic, truth.caustic, truth.mask);
  if (pair.impossible.empty()) figures.flip_mean = flip_figures(flip_map(pair.a, pair.b), truth.mask).mean;
  return figures;
}

}  // namespace caustics::app
