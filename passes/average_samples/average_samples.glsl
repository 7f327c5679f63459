// Adds to the picture what one sample of each pixel sees, times its share of the pixel.
UNIFORMS_BEGIN
#include "passes/average_samples/average_samples_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, one_sample)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, beauty)

void main() { beauty = texel_fetch(one_sample, floor_to_int(frag_x()), floor_to_int(frag_y())) * u.weight; }
#endif
