// Adds one, and where it lies, to each pixel whose texel is not 0.
UNIFORMS_BEGIN
vec4 unused;
UNIFORMS_END
TEXTURE(0, wanted)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, numbers)

void main() {
  Vec4 texel = texel_fetch(wanted, floor_to_int(frag_x()), floor_to_int(frag_y()));
  discard_if(texel.x == 0.0f && texel.y == 0.0f && texel.z == 0.0f && texel.w == 0.0f);
  numbers = Vec4(frag_x(), frag_y(), texel.x, Float(1.0f));
}
#endif
