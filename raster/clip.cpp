#include "raster/clip.hpp"

#include <cmath>

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

// Each plane adds at most two vertices.
constexpr int kMaxMade = 12;

// A bit for each plane that the position lies outside of. A NaN lies outside of what it touches.
unsigned outside_of(const float* p) {
  const float x = p[0], y = p[1], z = p[2], w = p[3];
  return (!(x <= w) ? 1u : 0u) | (!(x + w >= 0.0f) ? 2u : 0u) | (!(y <= w) ? 4u : 0u) |
         (!(y + w >= 0.0f) ? 8u : 0u) | (!(z >= 0.0f) ? 16u : 0u) | (!(z <= w) ? 32u : 0u);
}

bool is_finite(const float* p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) && std::isfinite(p[3]);
}

// Cuts a polygon with one plane. Its first vertex stays the first when it is inside.
class PlaneCut {
 public:
  PlaneCut(int plane, int stride, float* storage, int& used)
      : plane_(plane), stride_(stride), storage_(storage), used_(used) {}

  ClippedPolygon operator()(const ClippedPolygon& in) {
    for (int i = 0; i < in.count; ++i) {
      const float* p = in.vertices[i];
      const float* next = in.vertices[(i + 1) % in.count];
      const float d = distance_to(plane_, p), d_next = distance_to(plane_, next);
      if (d >= 0.0f) add(p, in.made[i]);
      if ((d >= 0.0f) != (d_next >= 0.0f)) add(cut(p, d, next, d_next), true);
    }
    return out_;
  }

 private:
  void add(const float* vertex, bool made) {
    out_.vertices[out_.count] = vertex;
    out_.made[out_.count++] = made;
  }

  // Measured from the vertex nearer to the plane, so that an edge shared by two triangles is cut alike; of
  // two equally near, from the one inside.
  const float* cut(const float* p, float d, const float* q, float d_q) {
    const float d_outer = d < 0.0f ? d : d_q, d_inner = d < 0.0f ? d_q : d;
    const bool from_outer = -d_outer < d_inner;
    const bool from_p = (d < 0.0f) == from_outer;
    const float* from = from_p ? p : q;
    const float* to = from_p ? q : p;
    const float t = from_p ? d / (d - d_q) : d_q / (d_q - d);
    float* made = storage_ + static_cast<std::size_t>(used_++) * static_cast<std::size_t>(stride_);
    for (int k = 0; k < stride_; ++k) made[k] = from[k] + t * (to[k] - from[k]);
    return made;
  }

  int plane_, stride_;
  float* storage_;
  int& used_;
  ClippedPolygon out_;
};

}  // namespace

bool is_inside(const float* p) { return outside_of(p) == 0; }

ClippedPolygon clip_triangle(const float* a, const float* b, const float* c, int stride,
                             std::vector<float>& storage) {
  ClippedPolygon polygon{{a, b, c}, {false, false, false}, 3};
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return {};
  storage.resize(static_cast<std::size_t>(kMaxMade) * static_cast<std::size_t>(stride));
  int used = 0;
  // Only planes that a corner lies outside of: vertices made at one may lie outside another by a rounding,
  // and stay.
  const unsigned planes = outside_of(a) | outside_of(b) | outside_of(c);
  for (int plane = 0; plane < 6 && polygon.count >= 3; ++plane)
    if (planes & (1u << plane)) polygon = PlaneCut(plane, stride, storage.data(), used)(polygon);
  return polygon;
}

}  // namespace caustics::raster
