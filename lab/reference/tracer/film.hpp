// The picture: what its pixels see, and how light that lands there is measured.
#pragma once
#include <cstdint>
#include <vector>

#include "lab/reference/tracer/paths.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics::tracer {

// The first surface at a pixel's centre. Thin panes are looked through, as `render`'s layers do.
struct Seen {
  int mesh = -1;  // none: the sky
  bool caster = false;
  glm::dvec3 position{0.0};
  glm::dvec3 plane{0.0};   // unit normal of the triangle, on the camera's side
  glm::dvec3 normal{0.0};  // the shading normal, turned with the winding as `render` does
  double depth = 0.0;      // along the camera's axis, metres
  double share = 1.0;      // of the pixel that shows this surface, of kSubRays^2 camera rays
};

inline constexpr int kSubRays = 8;

class Film {
 public:
  Film(const World& world, const View& view, int width, int height, int threads);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t pixels() const { return seen_.size(); }
  // Rows from the bottom, as in Image.
  const Seen& seen(std::size_t pixel) const { return seen_[pixel]; }

  // Irradiance that a landing adds to its pixel, per intensity: flux / (area of the landing's plane that the
  // pixel sees, times its share). False where the camera does not see it.
  bool measure(const Landing& landing, std::uint32_t& pixel, glm::dvec3& irradiance) const;

 private:
  Ray ray_at(const glm::dvec2& window) const;  // distances along it are depths
  glm::dvec2 window_at(double x, double y) const;
  Seen look(const glm::dvec2& window) const;
  bool same_surface(const Seen& centre, int mesh, const glm::dvec3& plane, const glm::dvec3& position) const;
  void see_row(int row);
  void measure_shares(int row);
  bool inner(int column, int row) const;
  bool visible(const glm::dvec3& position) const;

  const World& world_;
  View view_;
  int width_, height_;
  glm::dvec2 pixel_size_{0.0};  // in the window
  std::vector<Seen> seen_;
};

}  // namespace caustics::tracer
