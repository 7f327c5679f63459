// The luminance of each texel of a picture.
UNIFORMS_BEGIN
#include "luminance/luminance_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, picture)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Float, luminance)

void main() {
  Vec4 color = texel_fetch(picture, floor_to_int(frag_x()), floor_to_int(frag_y()));
  luminance = color.x * u.weights.x + color.y * u.weights.y + color.z * u.weights.z;
}
#endif
