#include "lab/reference/tracer/film.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/in_pieces.hpp"

namespace caustics::tracer {

Film::Film(const World& world, const View& view, int width, int height, int threads)
    : world_(world), view_(view), width_(width), height_(height) {
  pixel_size_ = (view.window_upper - view.window_lower) / glm::dvec2(width, height);
  seen_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  in_pieces(height, threads, [&](int row) { see_row(row); });
  in_pieces(height, threads, [&](int row) { measure_shares(row); });
}

glm::dvec2 Film::window_at(double x, double y) const {
  return view_.window_lower + pixel_size_ * glm::dvec2(x, y);
}

Ray Film::ray_at(const glm::dvec2& w) const {
  const glm::dvec3 across = view_.right * w.x + view_.up * w.y;
  return view_.perspective ? Ray{view_.origin, view_.forward + across}
                           : Ray{view_.origin + across, view_.forward};
}

Seen Film::look(const glm::dvec2& window) const {
  const Ray ray = ray_at(window);
  auto hit = world_.receivers().nearest(ray, view_.near, view_.far);
  // At one depth the receiver counts.
  const double reach = hit ? hit->distance * (1.0 - 1e-7) : view_.far;
  Seen seen;
  if (auto caster = world_.casters().nearest(ray, view_.near, reach); caster && caster->distance < reach) {
    hit = caster;
    seen.caster = true;
  }
  if (!hit) return seen;
  seen.mesh = hit->mesh;
  seen.position = hit->position;
  seen.plane = hit->front ? hit->plane : -hit->plane;
  seen.normal = hit->front ? hit->normal : -hit->normal;
  seen.depth = hit->distance;
  return seen;
}

void Film::see_row(int row) {
  for (int x = 0; x < width_; ++x)
    seen_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] =
        look(window_at(x + 0.5, row + 0.5));
}

// Of one mesh, not turned by more than 60 degrees, and no farther from the centre's plane than a pixel or two
// across: what else lies in the pixel is another surface, or the same behind an edge.
bool Film::same_surface(const Seen& centre, int mesh, const glm::dvec3& plane,
                        const glm::dvec3& position) const {
  if (centre.mesh != mesh || exact::dot(centre.plane, plane) < 0.5) return false;
  const double across = std::max(pixel_size_.x, pixel_size_.y) * (view_.perspective ? centre.depth : 1.0);
  return std::fabs(exact::dot(position - centre.position, centre.plane)) <= 2.0 * across;
}

// Does the pixel lie within its surface, as its neighbours and its corners tell?
bool Film::inner(int column, int row) const {
  const auto at = [&](int x, int y) -> const Seen& {
    return seen_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)];
  };
  const Seen& centre = at(column, row);
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, height_ - 1); ++y)
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, width_ - 1); ++x)
      if (!same_surface(centre, at(x, y).mesh, at(x, y).plane, at(x, y).position)) return false;
  for (int corner = 0; corner < 4; ++corner) {
    const Seen seen = look(window_at(column + (corner & 1), row + (corner >> 1)));
    if (!same_surface(centre, seen.mesh, seen.plane, seen.position)) return false;
  }
  return true;
}

void Film::measure_shares(int row) {
  for (int x = 0; x < width_; ++x) {
    Seen& centre =
        seen_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    if (centre.mesh < 0 || centre.caster || inner(x, row)) continue;
    int same = 0;
    for (int i = 0; i < kSubRays * kSubRays; ++i) {
      const int sub_column = i % kSubRays, sub_row = i / kSubRays;
      const Seen seen = look(window_at(x + (sub_column + 0.5) / kSubRays, row + (sub_row + 0.5) / kSubRays));
      same += same_surface(centre, seen.mesh, seen.plane, seen.position) ? 1 : 0;
    }
    centre.share = std::max(same, 1) / static_cast<double>(kSubRays * kSubRays);
  }
}

bool Film::visible(const glm::dvec3& position) const {
  const glm::dvec3 c = view_.coordinates(position);
  const Ray ray = ray_at(view_.window(c));
  const double until = c.z - world_.nearest();
  return !world_.receivers().blocked(ray, view_.near, until) &&
         !world_.casters().blocked(ray, view_.near, until);
}

bool Film::measure(const Landing& landing, std::uint32_t& pixel, glm::dvec3& irradiance) const {
  const SurfaceHit& hit = landing.on;
  const glm::dvec3 c = view_.coordinates(hit.position);
  if (!(c.z >= view_.near && c.z <= view_.far)) return false;
  const glm::dvec2 at = (view_.window(c) - view_.window_lower) / pixel_size_;
  if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < width_ && at.y < height_)) return false;
  pixel = static_cast<std::uint32_t>(at.y) * static_cast<std::uint32_t>(width_) +
          static_cast<std::uint32_t>(at.x);
  const Seen& centre = seen_[pixel];
  if (centre.mesh != hit.mesh || centre.caster) return false;
  // The side that the camera sees must be the one that is lit.
  const glm::dvec3 from_eye = view_.perspective ? hit.position - view_.origin : view_.forward;
  const double facing_eye = exact::dot(hit.plane, from_eye);
  const glm::dvec3 plane = facing_eye < 0.0 ? hit.plane : -hit.plane;
  const double arriving = -exact::dot(plane, landing.direction);
  if (!(arriving > 0.0) || !same_surface(centre, hit.mesh, plane, hit.position)) return false;
  if (centre.share < 1.0 && !visible(hit.position)) return false;
  // Area of the plane per area of the window: z^3 / |n.(p - o)| in perspective, 1 / |n.f| without.
  const double slope = std::fabs(facing_eye);
  const double window_per_area = slope / (view_.perspective ? c.z * c.z * c.z : 1.0);
  const glm::dvec3 shading = facing_eye < 0.0 ? hit.normal : -hit.normal;
  const double leaning = std::max(-exact::dot(shading, landing.direction), 0.0) / arriving;
  irradiance = landing.flux * (window_per_area * leaning / (pixel_size_.x * pixel_size_.y * centre.share));
  return true;
}

}  // namespace caustics::tracer
