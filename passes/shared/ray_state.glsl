// The ray textures: light under way between two surfaces, a texel a grid vertex.
//   ray_start      xyz: where it starts, metres, scene space; w: number of the triangle there plus 1, 0 where
//                  no light is under way, RAY_ENDED where it has been given up
//   ray_direction  xyz: unit; w: its path, a number that the same sequence of bodies and events gives
//   ray_flux       rgb: its flux, relative to the light's intensity; w: the light's on the cell
//   ray_media      the bodies that it is in, the last one entered first: rows of caster_materials plus 1,
//                  or 0
//   ray_width      how the start moves from one grid vertex to the next: xy along the grid's rows, zw along
//                  its columns, metres, in the axes across the direction
//   ray_spread     likewise how the direction turns, radians
Bool is_under_way(Vec4 start_texel) { return start_texel.w > 0.0f; }
Bool has_ended(Vec4 start_texel) { return start_texel.w == float(RAY_ENDED); }
Float own_triangle(Vec4 start_texel) { return start_texel.w - 1.0f; }

// The texture surface_hit: xy: weights of the triangle's second and third corner, z: metres to it, w: its
// number plus 1, 0 where nothing is met, HIT_GIVEN_UP where the walk took too many steps.
Bool is_surface(Vec4 hit_texel) { return hit_texel.w > 0.0f; }
Bool is_on_caster(Vec4 hit_texel) { return is_surface(hit_texel) && hit_texel.w <= float(u.first_receiver); }
Bool is_given_up(Vec4 hit_texel) { return hit_texel.w == float(HIT_GIVEN_UP); }
