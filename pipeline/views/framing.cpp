#include "pipeline/views/framing.hpp"

#include <algorithm>
#include <limits>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// Points across and along the view, of which one axis of the picture shows those with |x - cx| <= t (z - cz)
// of a camera at (cx, cz).
struct Wedge {
  double slope;                                                            // t
  double above = -std::numeric_limits<double>::infinity(), below = above;  // largest x - t z and -x - t z
  void add(double x, double z) {
    above = std::max(above, x - slope * z);
    below = std::max(below, -x - slope * z);
  }
  // The farthest forward that the camera may stand, and then where across.
  double along() const { return -(above + below) / (2.0 * slope); }
  double across() const { return 0.5 * (above - below); }
};

}  // namespace

Camera framing_camera(const std::vector<glm::dvec3>& points, const glm::dvec3& forward, double vertical_fov,
                      double aspect, double least) {
  Camera camera;
  camera.vertical_fov = vertical_fov;
  camera.forward = forward;
  camera.right = exact::normalise(exact::cross(forward, {0, 1, 0}), {1, 0, 0});
  camera.up = exact::cross(camera.right, forward);
  double sine = 0.0, cosine = 1.0;
  exact::sin_cos(0.5 * vertical_fov, sine, cosine);
  const double slope = sine / cosine * (1.0 - kFramingMargin);
  Wedge wide{.slope = slope * aspect}, high{.slope = slope};
  double nearest = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& p : points) {
    const double z = exact::dot(forward, p);
    wide.add(exact::dot(camera.right, p), z);
    high.add(exact::dot(camera.up, p), z);
    nearest = std::min(nearest, z);
  }
  if (points.empty()) {
    wide.add(0.0, 0.0);
    high.add(0.0, 0.0);
    nearest = 0.0;
  }
  const double away = 0.5 * least / std::min(wide.slope, high.slope);
  const double along = std::min({wide.along(), high.along(), nearest - away});
  camera.position = (camera.right * wide.across() + camera.up * high.across()) + forward * along;
  camera.near = 0.01 * (nearest - along);
  return camera;
}

Camera with_lens(Camera camera, std::optional<float> fov, float zoom) {
  if (fov) camera.vertical_fov = static_cast<double>(*fov) * exact::kPi / 180.0;
  if (zoom == 1.0f) return camera;
  const double factor = static_cast<double>(zoom);
  camera.half_width /= factor;
  camera.half_height /= factor;
  double sine = 0.0, cosine = 1.0;
  exact::sin_cos(0.5 * camera.vertical_fov, sine, cosine);
  camera.vertical_fov = 2.0 * exact::arctangent(sine / (cosine * factor));
  return camera;
}

}  // namespace caustics
