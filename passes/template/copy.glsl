// Copies the picture texel by texel, times a factor.
UNIFORMS_BEGIN
#include "passes/template/copy_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, beauty)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, copy)

void main() { copy = texel_fetch(beauty, floor_to_int(frag_x()), floor_to_int(frag_y())) * u.factor; }
#endif
