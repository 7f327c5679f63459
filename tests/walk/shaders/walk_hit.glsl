// Shows by itself how the passes walk and glass find the next surface in the hierarchy.
UNIFORMS_BEGIN
int most_steps;
int first_receiver;
float touch;
UNIFORMS_END
TEXTURE(0, ray_start)
TEXTURE(1, ray_direction)
TEXTURE(2, ray_media)
TEXTURE(3, hierarchy_nodes)
TEXTURE(4, hierarchy_triangles)
TEXTURE(5, hierarchy_normals)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, hit)
#include "passes/shared/axes_across.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/hierarchy.glsl"

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 start = texel_fetch(ray_start, column, row);
  Ray ray = ray_from(Vec3(start), Vec3(texel_fetch(ray_direction, column, row)));
  hit = hit_ahead(ray, start.w - 1.0f, texel_fetch(ray_media, column, row), start.w > 0.0f);
}
#endif
