#include "raster/triangle_setup.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/gpu/point_rule.hpp"
#include "raster/clip.hpp"
#include "raster/vertex_stage.hpp"

namespace caustics::raster {

namespace {

constexpr float kSubpixels = 256.0f;

// Window coordinate to 24.8 with pixel centres at whole numbers; ties to even. The value is inside the
// viewport, so it fits.
std::int32_t snapped(float coordinate) {
  return static_cast<std::int32_t>(std::nearbyintf((coordinate - 0.5f) * kSubpixels));
}

std::int32_t floor_div_256(std::int64_t value) { return static_cast<std::int32_t>(value >> 8); }
std::int32_t ceil_div_256(std::int64_t value) { return static_cast<std::int32_t>((value + 255) >> 8); }

// The plane through a value at three vertices; differences are those of the unsnapped positions.
struct PlaneSetup {
  float dx01, dy01, dx20, dy20, reciprocal_area, x0, y0;

  Plane through(float f0, float f1, float f2) const {
    const float d01 = f0 - f1, d20 = f2 - f0;
    const float per_x = d01 * (dy20 * reciprocal_area) - d20 * (dy01 * reciprocal_area);
    const float per_y = d20 * (dx01 * reciprocal_area) - d01 * (dx20 * reciprocal_area);
    return {f0 - (per_x * (x0 - 0.5f) + per_y * (y0 - 0.5f)), per_x, per_y};
  }
};

void add_planes(const WindowVertex* v, const TriangleOptions& options, std::vector<Plane>& planes) {
  PlaneSetup s{v[0].x - v[1].x, v[0].y - v[1].y, v[2].x - v[0].x, v[2].y - v[0].y, 0.0f, v[0].x, v[0].y};
  s.reciprocal_area = 1.0f / (s.dx01 * s.dy20 - s.dx20 * s.dy01);
  planes.push_back(s.through(v[0].z, v[1].z, v[2].z));
  planes.push_back(s.through(v[0].reciprocal_w, v[1].reciprocal_w, v[2].reciprocal_w));
  for (int c = 0; c < options.varying_count; ++c) {
    if (options.varying_flat[c]) {
      planes.push_back({0.0f, 0.0f, 0.0f});
      continue;
    }
    planes.push_back(s.through(v[0].varyings[c] * v[0].reciprocal_w, v[1].varyings[c] * v[1].reciprocal_w,
                               v[2].varyings[c] * v[2].reciprocal_w));
  }
}

}  // namespace

WindowVertex to_window(const float* p, bool made, const Viewport& viewport) {
  WindowVertex v;
  v.reciprocal_w = 1.0f / p[3];
  const float half_width = 0.5f * static_cast<float>(viewport.width);
  const float half_height = 0.5f * static_cast<float>(viewport.height);
  const float x = p[0] * v.reciprocal_w, y = p[1] * v.reciprocal_w, z = p[2] * v.reciprocal_w;
  if (made) {
    v.x = x * half_width + half_width;
    v.y = y * half_height + half_height;
  } else {
    v.x = std::fmaf(x, half_width, half_width);
    v.y = std::fmaf(y, half_height, half_height);
  }
  v.z = z;
  v.varyings = p + ShadedVertices::kHeader;
  return v;
}

bool set_up_triangle(const WindowVertex (&v)[3], const float* provoking, const Viewport& viewport,
                     const TriangleOptions& options, TriangleRecord& record, std::vector<Plane>& planes) {
  std::int64_t x[3], y[3];
  for (int i = 0; i < 3; ++i) {
    x[i] = snapped(v[i].x);
    y[i] = snapped(v[i].y);
  }
  const std::int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  if (area == 0) return false;
  const bool front = area > 0;
  if (options.cull == (front ? Cull::Front : Cull::Back)) return false;
  // Counter-clockwise order for coverage, llvmpipe's rotation for the planes.
  const int order[3] = {0, front ? 1 : 2, front ? 2 : 1};
  for (int i = 0; i < 3; ++i) {
    const int a = order[i], b = order[(i + 1) % 3];
    const std::int64_t dx = x[b] - x[a], dy = y[b] - y[a];
    // Left edges go down, bottom edges to the right; pixel centres on them belong to the triangle.
    const bool inclusive = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t c = dy * x[a] - dx * y[a] + (inclusive ? 0 : -1);
    record.c[i] = c >> 8;
    record.dx[i] = static_cast<std::int32_t>(dx);
    record.dy[i] = static_cast<std::int32_t>(dy);
  }
  record.x_first = std::max(0, ceil_div_256(std::min({x[0], x[1], x[2]})));
  record.x_last = std::min(viewport.width - 1, floor_div_256(std::max({x[0], x[1], x[2]})));
  record.y_first = std::max(0, ceil_div_256(std::min({y[0], y[1], y[2]})));
  record.y_last = std::min(viewport.height - 1, floor_div_256(std::max({y[0], y[1], y[2]})));
  if (record.x_first > record.x_last || record.y_first > record.y_last) return false;
  record.front_facing = front ? -1 : 0;
  record.provoking = provoking;
  record.planes = nullptr;
  const WindowVertex rotated[3] = {v[front ? 1 : 0], v[front ? 2 : 1], v[front ? 0 : 2]};
  add_planes(rotated, options, planes);
  return true;
}

bool set_up_rectangle(const float* shaded, const Viewport& viewport, PointRecord& record) {
  const auto pixels = [&](float lower, float upper, int size, std::int32_t& first, std::int32_t& last) {
    const float half = 0.5f * static_cast<float>(size);
    const auto edge = [&](float clip) {
      return snapped(std::fmaf(std::clamp(clip, -1.0f, 1.0f), half, half));
    };
    if (!(lower < upper)) return false;
    first = ceil_div_256(edge(lower));
    last = ceil_div_256(edge(upper)) - 1;
    return first <= last;
  };
  record.z = 0.5f;
  record.varyings = shaded + ShadedVertices::kHeader;
  return pixels(shaded[0], shaded[2], viewport.width, record.x_first, record.x_last) &&
         pixels(shaded[1], shaded[3], viewport.height, record.y_first, record.y_last);
}

bool set_up_point(const float* shaded, const Viewport& viewport, PointRecord& record) {
  if (!is_inside(shaded)) return false;
  const WindowVertex v = to_window(shaded, false, viewport);
  const PixelRange x = pixels_of_point(v.x, shaded[4]), y = pixels_of_point(v.y, shaded[4]);
  record.x_first = std::max(0, x.first);
  record.x_last = std::min(viewport.width - 1, x.last);
  record.y_first = std::max(0, y.first);
  record.y_last = std::min(viewport.height - 1, y.last);
  record.z = v.z;
  record.varyings = v.varyings;
  return record.x_first <= record.x_last && record.y_first <= record.y_last;
}

}  // namespace caustics::raster
