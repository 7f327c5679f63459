// From clip space to records that tiles can be filled from.
#pragma once
#include <vector>

#include "raster/tile_job.hpp"

namespace caustics::raster {

// The viewport: the whole target (OpenGL 4.5, 13.6.1, with clip control's zero-to-one depth).
struct Viewport {
  int width = 0, height = 0;
};

// A vertex in window coordinates.
struct WindowVertex {
  float x = 0.0f, y = 0.0f, z = 0.0f;
  float reciprocal_w = 0.0f;
  const float* varyings = nullptr;
};
// `made`: the vertex was made by clipping; llvmpipe then rounds the product before it adds.
WindowVertex to_window(const float* position, bool made, const Viewport& viewport);

struct TriangleOptions {
  Cull cull = Cull::None;
  int varying_count = 0;
  const std::uint8_t* varying_flat = nullptr;
};

// Snaps, culls and sets up a triangle. Returns false when it covers nothing. On success `planes` has
// grown by 2 + varying_count planes and record.planes is left null for the caller to fill in.
bool set_up_triangle(const WindowVertex (&v)[3], const float* provoking, const Viewport& viewport,
                     const TriangleOptions& options, TriangleRecord& record, std::vector<Plane>& planes);

// Returns false when the point is discarded: its centre lies outside the view volume.
bool set_up_point(const float* shaded, const Viewport& viewport, PointRecord& record);
// Returns false when the rectangle covers no pixel.
bool set_up_rectangle(const float* shaded, const Viewport& viewport, PointRecord& record);

}  // namespace caustics::raster
