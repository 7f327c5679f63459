#include "raster/clip.hpp"

#include <cmath>
#include <utility>

namespace caustics::raster {

namespace {

// Signed distance from a plane of the view volume, not negative inside.
float distance_to(int plane, const float* p) {
  switch (plane) {
    case 0:
      return p[3] - p[0];
    case 1:
      return p[3] + p[0];
    case 2:
      return p[3] - p[1];
    case 3:
      return p[3] + p[1];
    case 4:
      return p[2];
    default:
      return p[3] - p[2];
  }
}

bool is_finite(const float* p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) && std::isfinite(p[3]);
}

// Each plane adds at most two vertices.
constexpr int kMaxMade = 12;

}  // namespace

bool is_inside(const float* p) {
  return -p[3] <= p[0] && p[0] <= p[3] && -p[3] <= p[1] && p[1] <= p[3] && 0.0f <= p[2] &&
         p[2] <= p[3] && p[3] > 0.0f && std::isfinite(p[3]);
}

ClippedPolygon clip_triangle(const float* a, const float* b, const float* c, int stride,
                             std::vector<float>& storage) {
  ClippedPolygon in{{a, b, c}, {false, false, false}, 3};
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return {};
  storage.resize(static_cast<std::size_t>(kMaxMade) * static_cast<std::size_t>(stride));
  int used = 0;
  for (int plane = 0; plane < 6; ++plane) {
    ClippedPolygon out;
    for (int i = 0; i < in.count; ++i) {
      const int previous = (i + in.count - 1) % in.count;
      const float* p = in.vertices[previous];
      const float* v = in.vertices[i];
      const float dp_previous = distance_to(plane, p), dp = distance_to(plane, v);
      if ((dp_previous >= 0.0f) != (dp >= 0.0f)) {
        // From the outer to the inner vertex, so that an edge shared by two triangles is cut alike.
        const bool enters = dp >= 0.0f;
        const float* outer = enters ? p : v;
        const float* inner = enters ? v : p;
        const float d_outer = enters ? dp_previous : dp, d_inner = enters ? dp : dp_previous;
        const float t = d_outer / (d_outer - d_inner);
        float* made = storage.data() + static_cast<std::size_t>(used++) * static_cast<std::size_t>(stride);
        for (int k = 0; k < stride; ++k) made[k] = outer[k] + t * (inner[k] - outer[k]);
        out.vertices[out.count] = made;
        out.made[out.count++] = true;
      }
      if (dp >= 0.0f) {
        out.vertices[out.count] = v;
        out.made[out.count++] = in.made[i];
      }
    }
    in = out;
    if (in.count < 3) return {};
  }
  return in;
}

}  // namespace caustics::raster
