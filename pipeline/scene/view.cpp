#include "pipeline/scene/view.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"
#include "pipeline/shader/constants.hpp"

namespace caustics {

glm::dvec3 View::coordinates(const glm::dvec3& p) const {
  const glm::dvec3 d = p - origin;
  return {right.x * d.x + right.y * d.y + right.z * d.z, up.x * d.x + up.y * d.y + up.z * d.z,
          forward.x * d.x + forward.y * d.y + forward.z * d.z};
}

glm::dvec2 View::window(const glm::dvec3& c) const {
  const double w = perspective ? c.z : 1.0;
  return {c.x / w, c.y / w};
}

double View::window_area() const {
  if (cube) return cube->texel_area() * static_cast<double>(cube->side) * static_cast<double>(cube->side);
  return (window_upper.x - window_lower.x) * (window_upper.y - window_lower.y);
}

std140::View shader_view(const View& view) {
  std140::View result{.from_scene = glm::mat4(1.0f),
                      .scale = glm::vec2(0.0f),
                      .offset = glm::vec2(0.0f),
                      .near = static_cast<float>(view.near),
                      .far = static_cast<float>(view.far),
                      .kind = view.cube          ? VIEW_CUBE
                              : view.perspective ? VIEW_PERSPECTIVE
                                                 : VIEW_PARALLEL,
                      .face = view.face};
  const glm::dvec3 axes[3] = {view.right, view.up, view.forward};
  for (int row = 0; row < 3; ++row) {
    const glm::dvec3& a = axes[row];
    for (int column = 0; column < 3; ++column) result.from_scene[column][row] = static_cast<float>(a[column]);
    result.from_scene[3][row] =
        static_cast<float>(-(a.x * view.origin.x + a.y * view.origin.y + a.z * view.origin.z));
  }
  if (view.cube) {
    const CubeAtlas& atlas = *view.cube;
    const glm::dvec4 texels{atlas.face_width(), atlas.face_height(), atlas.tile_width(), atlas.tile_height()};
    const glm::vec4 window(0.5 * texels / static_cast<double>(atlas.side));
    result.scale = {window.x, window.y};
    result.offset = {window.z, window.w};
    return result;
  }
  const glm::dvec2 size = view.window_upper - view.window_lower;
  result.scale = {static_cast<float>(1.0 / size.x), static_cast<float>(1.0 / size.y)};
  result.offset = {static_cast<float>(-view.window_lower.x / size.x),
                   static_cast<float>(-view.window_lower.y / size.y)};
  return result;
}

View view_along(const glm::dvec3& origin, const glm::dvec3& forward) {
  const glm::dvec3 size{std::fabs(forward.x), std::fabs(forward.y), std::fabs(forward.z)};
  // Looking mostly down or up: map the picture's up to -z, as on a map of the floor.
  glm::dvec3 hint{0.0, 1.0, 0.0};
  if (size.y >= size.x && size.y >= size.z) hint = {0.0, 0.0, -1.0};
  View view;
  view.origin = origin;
  view.forward = forward / std::sqrt(forward.x * forward.x + forward.y * forward.y + forward.z * forward.z);
  const glm::dvec3& f = view.forward;
  glm::dvec3 right{f.y * hint.z - f.z * hint.y, f.z * hint.x - f.x * hint.z, f.x * hint.y - f.y * hint.x};
  right /= std::sqrt(right.x * right.x + right.y * right.y + right.z * right.z);
  view.right = right;
  view.up = {right.y * f.z - right.z * f.y, right.z * f.x - right.x * f.z, right.x * f.y - right.y * f.x};
  return view;
}

View view_of(const Camera& camera, int width, int height, const Bounds& bounds) {
  View view;
  view.origin = camera.position;
  view.right = camera.right;
  view.up = camera.up;
  view.forward = camera.forward;
  view.perspective = !camera.orthographic;
  const double aspect = static_cast<double>(width) / static_cast<double>(height);
  double half_height = camera.half_height;
  double half_width = camera.half_height * aspect;
  if (view.perspective) {
    double sine, cosine;
    exact::sin_cos(0.5 * camera.vertical_fov, sine, cosine);
    half_height = sine / cosine;
    half_width = half_height * aspect;
  } else if (half_width < camera.half_width) {
    half_width = camera.half_width;
    half_height = camera.half_width / aspect;
  }
  view.window_lower = {-half_width, -half_height};
  view.window_upper = {half_width, half_height};
  view.near = camera.near;
  double farthest = camera.near * 2.0;
  if (!bounds.empty()) {
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p{corner & 1 ? bounds.upper.x : bounds.lower.x,
                         corner & 2 ? bounds.upper.y : bounds.lower.y,
                         corner & 4 ? bounds.upper.z : bounds.lower.z};
      farthest = std::max(farthest, view.coordinates(p).z * 1.001);
    }
  }
  view.far = std::min(camera.far, farthest);
  if (!(view.far > view.near)) view.far = view.near * 2.0 + 1e-3;
  return view;
}

}  // namespace caustics
