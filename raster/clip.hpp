// Clipping triangles to the view volume (OpenGL 4.5, 13.5), as llvmpipe does it.
#pragma once
#include <vector>

namespace caustics::raster {

// True when -w <= x, y <= w and 0 <= z <= w; never for a NaN.
bool is_inside(const float* position);

// What is left of a triangle: fewer than three vertices for nothing.
struct ClippedPolygon {
  static constexpr int kMaxVertices = 9;
  const float* vertices[kMaxVertices];
  bool made[kMaxVertices];  // by clipping
  int count = 0;
};

// Clips the triangle a, b, c against those of the planes +x, -x, +y, -y, near, far, in this order, that one
// of its corners lies outside of (Sutherland and Hodgman 1974), without a guard band. Vertices are
// `stride` floats, position first; all are interpolated. Nothing is left of a triangle with a coordinate
// that is not finite. What is made lies in `storage`, which must stay alive and unmoved while it is used.
ClippedPolygon clip_triangle(const float* a, const float* b, const float* c, int stride,
                             std::vector<float>& storage);

}  // namespace caustics::raster
