// Light under way, as a texel of the ray textures holds it (ray_state.glsl). Needs ray.glsl.
struct LightPath {
  Ray ray;
  Float path;     // what it has met: the same number for the same sequence of bodies and events
  Vec3 flux;
  Float whole;    // the light's flux on the grid vertex's cell
  Vec4 media;
  Vec3 width_x;   // of its differential (Igehy 1999): how its start moves along the grid's rows and columns,
  Vec3 width_y;
  Vec3 spread_x;  // and how its direction turns
  Vec3 spread_y;
};
