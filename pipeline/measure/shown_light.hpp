// Light in the texels of a light's maps that shading looks up: where the error estimate gathers what is in
// wrong places.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "pipeline/settings/settings.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

// One value a texel, in double precision.
class TexelPlane {
 public:
  explicit TexelPlane(int side)
      : side_(side), values_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {}
  int side() const { return side_; }
  double& at(int x, int y) { return values_[index(x, y)]; }
  double at(int x, int y) const { return values_[index(x, y)]; }
  double clamped(int x, int y) const { return at(std::clamp(x, 0, side_ - 1), std::clamp(y, 0, side_ - 1)); }
  // Adds to the texel that holds a point, if the plane has it.
  void add(const glm::dvec2& texel, double value);
  // Means over a box around each texel take the place of its values; boxes of these sides, texels, and not
  // below one.
  void average(const glm::dvec2& box);
  // Sum of such means' absolute values. Uses the plane up.
  double absolute_sum(const glm::dvec2& box) &&;
  const std::vector<double>& values() const { return values_; }

 private:
  void average(double side, std::size_t along, std::size_t across);
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }
  int side_;
  std::vector<double> values_;
};

// The maps of a light as shading looks them up: the cascade where it reaches, else the caustic map.
struct ShownMaps {
  int side = 0;
  bool has_cascade = false;
  glm::dvec2 scale{1.0}, offset{0.0};  // from the caustic map's texels to the cascade's
  double border = 0.0;                 // of the cascade, not looked up, texels

  ShownMaps(const LightViews& views, const Settings& settings, int map_side, bool cascade);
  glm::dvec2 in_cascade(const glm::dvec2& texel) const { return texel * scale + offset; }
  bool cascade_shows(const glm::dvec2& texel) const;
};

// Light, or differences of light, gathered where it is shown.
struct ShownLight {
  TexelPlane map, cascade;
  const ShownMaps& maps;
  explicit ShownLight(const ShownMaps& m) : map(m.side), cascade(m.has_cascade ? m.side : 0), maps(m) {}
  void add(const glm::dvec2& texel, double flux);  // `texel` of the caustic map
  // Sum of |means over pixels| of this side, texels of the caustic map.
  double sum(double pixel) && {
    return std::move(map).absolute_sum(glm::dvec2(pixel)) +
           std::move(cascade).absolute_sum(pixel * maps.scale);
  }
};

}  // namespace caustics
