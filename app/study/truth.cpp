#include "app/study/truth.hpp"

#include <algorithm>
#include <cmath>

#include "app/output/display_pair.hpp"
#include "app/output/image_layers.hpp"
#include "app/output/image_planes.hpp"
#include "app/shell/terminal.hpp"
#include "lab/metrics/flip.hpp"
#include "lab/metrics/image_metrics.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

constexpr int kTruthColors = 3;

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw Error(ExitCode::BadInput, one_line(name) + ": " + why);
}

std::string truth_size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

// The colours of a layer as an image, rows turned; a single channel counts for all three.
Image layer_image(const ImagePlanes& planes, const std::string& layer, const std::string& name) {
  const Plane* colors[kTruthColors] = {};
  const Plane* only = nullptr;
  int found = 0;
  for (const Plane& plane : planes.planes) {
    if (layer_of(plane.name) != layer && plane.name != layer) continue;
    only = plane.name == layer || !only ? &plane : only;
    const std::size_t at = std::string("RGB").find(channel_in_layer(plane.name));
    if (at == std::string::npos || plane.name == layer) continue;
    colors[at] = &plane;
    ++found;
  }
  if (found != kTruthColors && found != 0) refuse(name, "its layer " + layer + " lacks a channel of R, G, B");
  if (found == 0 && !only) refuse(name, "has no layer '" + layer + "', as render --aov caustic writes it");
  if (found == 0) std::fill(colors, colors + kTruthColors, only);
  const ChannelView& first = colors[0]->view;
  Image image(Format::RGBA32F, first.width, first.height);
  for (int c = 0; c < kTruthColors; ++c) {
    const ChannelView& view = colors[c]->view;
    if (view.width != first.width || view.height != first.height || colors[c]->left != 0 ||
        colors[c]->top != 0)
      refuse(name, "the channels of its layer " + layer + " do not cover the picture alike");
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) image.at(x, view.height - 1 - y, c) = view.at(x, y);
  }
  return image;
}

bool has_layer(const ImagePlanes& planes, const std::string& layer) {
  return std::any_of(planes.planes.begin(), planes.planes.end(), [&](const Plane& plane) {
    return layer_of(plane.name) == layer || plane.name == layer;
  });
}

Selection selection_for(const Image& image, const std::filesystem::path& mask) {
  if (mask.empty()) return {};
  ImagePlanes planes;
  planes.planes.push_back({"R", {image.values.data(), 4, image.width(), image.height()}, 0, 0, false});
  return select(planes, mask, {});
}

template <class Use>
void for_each_selected(const Image& image, const Selection& selection, const Use& use) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (selection.has(x, image.height() - 1 - y)) use(x, y);
}

double sum_of(const Image& image, const Selection& selection) {
  double sum = 0.0;
  for_each_selected(image, selection, [&](int x, int y) {
    for (int c = 0; c < kTruthColors; ++c) sum += std::fabs(static_cast<double>(image.at(x, y, c)));
  });
  return sum;
}

double white_of(const Image& image, const Selection& selection) {
  std::vector<double> lit;
  for_each_selected(image, selection, [&](int x, int y) {
    const float most = std::max({image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)});
    if (most > 0.0f) lit.push_back(static_cast<double>(most));
  });
  if (lit.empty()) return 0.0;
  const auto at = lit.begin() + static_cast<std::ptrdiff_t>((lit.size() - 1) - (lit.size() - 1) / 100);
  std::nth_element(lit.begin(), at, lit.end());
  return *at;
}

}  // namespace

Truth make_truth(Image caustic, const std::filesystem::path& mask, const std::string& name) {
  Truth truth{.caustic = std::move(caustic)};
  truth.selection = selection_for(truth.caustic, mask);
  if (count_non_finite(truth.caustic) > 0) refuse(name, "its caustic has values that are not finite");
  truth.white = white_of(truth.caustic, truth.selection);
  if (!(truth.white > 0.0))
    refuse(
        name,
        "its caustic is black where it is looked at, so no error can be measured; 'caustics plan' says why "
        "a scene has none, --camera and --mask where to look");
  return truth;
}

Truth read_truth(const std::filesystem::path& file, int width, int height,
                 const std::filesystem::path& mask) {
  const std::string name = file.string();
  const ImagePlanes planes = read_planes(file);
  Image caustic = layer_image(planes, "caustic", name);
  const auto check_size = [&](const Image& image) {
    if (image.width() == width && image.height() == height) return;
    refuse(name, "is " + truth_size_text(image.width(), image.height()) + ", the study renders " +
                     truth_size_text(width, height) + "; use -r " +
                     truth_size_text(image.width(), image.height()));
  };
  check_size(caustic);
  Truth truth = make_truth(std::move(caustic), mask, name);
  if (!has_layer(planes, "caustic_error")) return truth;
  const Image error = layer_image(planes, "caustic_error", name);
  check_size(error);
  if (count_non_finite(error) > 0) refuse(name, "its layer caustic_error has values that are not finite");
  truth.noise = sum_of(error, truth.selection) / sum_of(truth.caustic, truth.selection);
  return truth;
}

void check_mask(int width, int height, const std::filesystem::path& mask) {
  if (!mask.empty()) selection_for(Image(Format::RGBA32F, width, height), mask);
}

Figures measure_against(const Truth& truth, const Image& caustic) {
  const std::vector<std::uint8_t> mask = truth.selection.from_bottom();
  const ImageMetrics metrics = image_metrics(caustic, truth.caustic, mask);
  Figures figures{.relative_l1 = metrics.relative_l1,
                  .rmse = metrics.rmse,
                  .flux_ratio = metrics.flux_ratio,
                  .relative_mse_1 = metrics.relative_mse[0],
                  .relative_mse_4 = metrics.relative_mse[1],
                  .relative_mse_16 = metrics.relative_mse[2]};
  const DisplayPair pair = display_pair(caustic, truth.caustic, truth.selection);
  if (pair.impossible.empty()) figures.flip_mean = flip_figures(flip_map(pair.a, pair.b), mask).mean;
  return figures;
}

}  // namespace caustics::app
