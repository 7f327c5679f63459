#include "pipeline/measure/seen_caustic.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pipeline/measure/surface_steps.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

constexpr int kBlocks = 64;  // along the longer side
// How far the surface that a caustic is held against may lie from it, blocks.
constexpr int kNear = kBlocks / 8;
// What lies behind a caster is told only where it is so much brighter than all that is seen directly.
constexpr double kMuchBrighter = 3.0;
// A surface seen at a flatter angle, by its cosine, has no larger pixels.
constexpr double kFlattest = 1e-3;

glm::dvec3 color_at(const ImageView& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

// Square metres of a surface in one pixel.
double pixel_area(const View& camera, const glm::dvec3& p, const glm::dvec3& n, double pixels) {
  const glm::dvec3 way = camera.perspective ? p - camera.origin : camera.forward;
  const double z = camera.perspective ? exact::dot(camera.forward, way) : 1.0;
  const double cosine = std::fabs(exact::dot(n, way)) / std::max(exact::length(way), 1e-300);
  const double along = z / std::max(exact::length(way), 1e-300);
  return camera.window_area() / pixels * z * z * along / std::max(cosine, kFlattest);
}

struct Block {
  double caustic = 0.0, direct = 0.0, pixels = 0.0;  // of what is seen directly: sums of luminance
  double behind = 0.0, behind_pixels = 0.0;
};

class Blocks {
 public:
  Blocks(int width, int height)
      : side_((std::max(width, height) + kBlocks - 1) / kBlocks),
        width_(width),
        height_(height),
        across_((width + side_ - 1) / side_),
        upward_((height + side_ - 1) / side_),
        blocks_(static_cast<std::size_t>(across_) * static_cast<std::size_t>(upward_)) {}

  Block& of_pixel(int x, int y) { return blocks_[index(x / side_, y / side_)]; }

  void tell(SeenCaustic& seen, double ambient) const {
    int best = 0, best_behind = 0;
    for (int i = 1; i < static_cast<int>(blocks_.size()); ++i) {
      if (caustic(i) > caustic(best)) best = i;
      if (behind(i) > behind(best_behind)) best_behind = i;
    }
    seen.is_through = behind(best_behind) > kMuchBrighter * caustic(best);
    const int place = seen.is_through ? best_behind : best;
    // Blocks at the edges may reach beyond the picture.
    const int column = place % across_, row = place / across_;
    seen.brightest = {std::min((column + 0.5) * side_, width_ - 0.5),
                      std::max(height_ - (row + 0.5) * side_, 0.5)};
    double lit = brightest_direct(place, kNear);
    if (!(lit > 0.0)) lit = brightest_direct(place, kBlocks);
    const double here = seen.is_through ? behind(place) : caustic(place);
    const double without = ambient + (seen.is_through ? 0.0 : direct(place));
    if (lit > 0.0) seen.times = (here + without) / (lit + ambient);
    if (without > 0.0) seen.times_without = (here + without) / without;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(across_) + static_cast<std::size_t>(x);
  }
  const Block& block(int i) const { return blocks_[static_cast<std::size_t>(i)]; }
  // Means over the whole block's pixels, so that a sliver of a surface does not count as much.
  double mean(double sum) const { return sum / (static_cast<double>(side_) * side_); }
  double caustic(int i) const { return mean(block(i).caustic); }
  double behind(int i) const { return mean(block(i).behind); }
  // And over its surface alone.
  double direct(int i) const { return block(i).pixels > 0.0 ? block(i).direct / block(i).pixels : 0.0; }

  double brightest_direct(int place, int reach) const {
    double most = 0.0;
    for (int y = std::max(0, place / across_ - reach); y <= std::min(upward_ - 1, place / across_ + reach);
         ++y)
      for (int x = std::max(0, place % across_ - reach); x <= std::min(across_ - 1, place % across_ + reach);
           ++x)
        most = std::max(most, direct(static_cast<int>(index(x, y))));
    return most;
  }

  int side_, width_, height_, across_, upward_;
  std::vector<Block> blocks_;
};

// Is it the first thing in the pixel?
bool hides(const ImageView& caster, const View& camera, const glm::dvec3& surface, int x, int y) {
  if (caster.values.empty()) return false;
  const auto here = surface_at(caster, x, y);
  return here && camera.coordinates(*here).z < camera.coordinates(surface).z;
}

}  // namespace

SeenCaustic see_caustic(const LitSurfaces& surfaces, const View& camera, double ambient) {
  const int width = surfaces.position.width(), height = surfaces.position.height();
  SeenCaustic seen;
  Blocks blocks(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto p = surface_at(surfaces.position, x, y);
      if (!p) continue;
      const glm::dvec3 light = color_at(surfaces.caustic, x, y);
      const double flux =
          (light.x + light.y + light.z) *
          pixel_area(camera, *p, color_at(surfaces.normal, x, y), static_cast<double>(width) * height);
      Block& block = blocks.of_pixel(x, y);
      if (hides(surfaces.caster, camera, *p, x, y)) {
        seen.through += flux;
        block.behind += exact::luminance(light);
        continue;
      }
      seen.beside += flux;
      block.pixels += 1.0;
      block.caustic += exact::luminance(light);
      if (!surfaces.direct.values.empty()) block.direct += exact::luminance(color_at(surfaces.direct, x, y));
    }
  if (seen.beside + seen.through > 0.0) blocks.tell(seen, ambient);
  return seen;
}

}  // namespace caustics
