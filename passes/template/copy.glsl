// Copies a texture texel by texel, each channel times a factor.
UNIFORMS_BEGIN
#include "passes/template/copy_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, source)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, copy)

void main() { copy = fetch_clamped(source, floor_to_int(frag_x()), floor_to_int(frag_y())) * Vec4(u.factor); }
#endif
