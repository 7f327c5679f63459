// Everything a fragment can be made from: smooth and flat varyings, the fragment's place, its facing.
UNIFORMS_BEGIN
vec4 limits;  // x: fragments with a smooth red below it are discarded
UNIFORMS_END
#include "tests/raster/shaders/raster_vertex.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, smooth_out)
OUTPUT(1, Vec4, flat_out)

void main() {
  discard_if(smooth_color.x < u.limits.x);
  smooth_out = smooth_color;
  flat_out = Vec4(flat_color.x + flat_color.y, frag_x() * 0.25f, frag_y() - flat_color.z,
                  sel(front_facing(), flat_color.w, Float(0.5f)));
}
#endif
