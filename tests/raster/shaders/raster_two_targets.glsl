// The smooth colour into one target, the flat one and the facing into another.
#include "tests/raster/shaders/raster_vertex.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, smooth_out)
OUTPUT(1, Vec4, flat_out)

void main() {
  smooth_out = smooth_color;
  flat_out = Vec4(flat_color.x, flat_color.y, sel(front_facing(), Float(1.0f), Float(0.0f)), frag_x());
}
#endif
