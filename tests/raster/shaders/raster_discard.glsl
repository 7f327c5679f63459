// Discards what has a red of 0.
#include "tests/raster/shaders/raster_vertex.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, smooth_out)

void main() {
  discard_if(smooth_color.x == 0.0f);
  smooth_out = smooth_color;
}
#endif
