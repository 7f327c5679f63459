// Adds what the medium scatters towards the camera to the picture.
TEXTURE(0, haze)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, beauty)

void main() {
  Vec3 scattered = Vec3(texel_fetch(haze, floor_to_int(frag_x()), floor_to_int(frag_y())));
  beauty = Vec4(scattered, Float(1.0f));
}
#endif
