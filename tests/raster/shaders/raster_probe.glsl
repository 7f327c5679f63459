// Clip coordinates and colours as the test gives them; the smooth colour is written.
VARYING_SMOOTH(0, Vec4, smooth_color)
VARYING_FLAT(4, Vec4, flat_color)

#ifdef VERTEX_STAGE
#include "tests/raster/shaders/raster_vertex.glsl"
#else
OUTPUT(0, Vec4, smooth_out)

void main() { smooth_out = smooth_color; }
#endif
