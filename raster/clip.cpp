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
    // Only planes that cut the triangle itself: vertices made at one may lie outside another by a
    // rounding, and stay.
    if (!(distance_to(plane, a) < 0.0f || distance_to(plane, b) < 0.0f ||
          distance_to(plane, c) < 0.0f))
      continue;
    ClippedPolygon out;
    for (int i = 0; i < in.count; ++i) {
      const float* p = in.vertices[i];
      const float* v = in.vertices[(i + 1) % in.count];
      const float dp_p = distance_to(plane, p), dp_v = distance_to(plane, v);
      if (dp_p >= 0.0f) {
        out.vertices[out.count] = p;
        out.made[out.count++] = in.made[i];
      }
      if ((dp_p >= 0.0f) == (dp_v >= 0.0f)) continue;
      // From the vertex nearer to the plane to the other, so that an edge shared by two triangles
      // is cut alike; of two equally near, from the one inside.
      const float outside = dp_p < 0.0f ? dp_p : dp_v, inside = dp_p < 0.0f ? dp_v : dp_p;
      const bool from_outside = -outside < inside;
      const bool from_p = (dp_p < 0.0f) == from_outside;
      const float* from = from_p ? p : v;
      const float* to = from_p ? v : p;
      const float t = from_p ? -dp_p / (dp_v - dp_p) : dp_v / (dp_v - dp_p);
      float* made =
          storage.data() + static_cast<std::size_t>(used++) * static_cast<std::size_t>(stride);
      for (int k = 0; k < stride; ++k) made[k] = from[k] + t * (to[k] - from[k]);
      out.vertices[out.count] = made;
      out.made[out.count++] = true;
    }
    in = out;
    if (in.count < 3) return {};
  }
  return in;
}

}  // namespace caustics::raster
