// What the medium leaves of what each of the camera's rays ends on.
#include "passes/shared/homogeneous_medium.glsl"
UNIFORMS_BEGIN
#include "passes/view_medium/view_medium_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, view_range)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, beauty)
#include "passes/shared/optics.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/medium_optics.glsl"
#include "passes/shared/view_range.glsl"

void main() {
  ViewRange range = fetch_view_range(view_range);
  beauty = Vec4(medium_transmittance(u.medium, range.exit - range.entry), Float(1.0f));
}
#endif
