// Clip coordinates and colours as the test gives them; the smooth colour is written.
#include "tests/raster/shaders/raster_vertex.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, smooth_out)

void main() { smooth_out = smooth_color; }
#endif
