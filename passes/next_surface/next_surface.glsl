// The next triangle that each ray under way meets. next_surface.md explains.
UNIFORMS_BEGIN
#include "passes/next_surface/next_surface_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, path_start)
TEXTURE(1, path_direction)
TEXTURE(2, path_media)
TEXTURE(3, hierarchy_nodes)
TEXTURE(4, hierarchy_triangles)
TEXTURE(5, hierarchy_normals)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, surface_hit)
#include "passes/shared/axes_across.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/ray_state.glsl"
#include "passes/shared/hierarchy.glsl"

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 start = texel_fetch(path_start, column, row);
  Bool walks = is_under_way(start);
  discard_if(!walks);
  surface_hit = Vec4(0.0f);
  if (any_lane(walks)) {
    Ray ray = ray_from(Vec3(start), Vec3(texel_fetch(path_direction, column, row)));
    WalkingRay walking = walking_ray(ray, own_triangle(start), texel_fetch(path_media, column, row));
    NearestTriangle nearest = nearest_triangle(walking, walks, nothing_met());
    Float number = sel(nearest.given_up, Float(HIT_GIVEN_UP), nearest.number + 1.0f);
    surface_hit = Vec4(nearest.weight1, nearest.weight2, nearest.distance, number);
    discard_if(number == 0.0f);
    TRACE(triangle, number - 1.0f);
    TRACE(stretch, nearest.distance);
  }
}
#endif
