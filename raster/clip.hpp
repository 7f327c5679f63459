// Clipping triangles to the view volume (OpenGL 4.5, 13.5), as llvmpipe does it.
#pragma once
#include <vector>

namespace caustics::raster {

// True when all of position's coordinates are finite and -w <= x, y <= w, 0 <= z <= w.
bool is_inside(const float* position);

// Clips the triangle a, b, c against the planes +x, -x, +y, -y, near, far in this order (Sutherland and
// Hodgman), without a guard band. Vertices are `stride` floats, position first; all are interpolated.
// `polygon` receives the remaining vertices, `made` which of them are new. Returns their number, 0 for
// nothing (or for coordinates that are not finite). The vertices lie in `storage`, which must stay
// alive and unmoved while they are used.
struct ClippedPolygon {
  static constexpr int kMaxVertices = 9;
  const float* vertices[kMaxVertices];
  bool made[kMaxVertices];
  int count = 0;
};
ClippedPolygon clip_triangle(const float* a, const float* b, const float* c, int stride,
                             std::vector<float>& storage);

}  // namespace caustics::raster
