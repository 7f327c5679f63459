#include "passes/shared/grid_light_uniforms.glsl"
#include "passes/shared/receiver_search_uniforms.glsl"
View caustic;             // the light's map that the landings are laid into
vec3 channel_share;       // the branch's share of each channel's flux
float bend;               // the branch's index of refraction is n_d + bend (n_F - n_C)
float exit_tolerance;     // how far from its surface a ray may end and still have met it, texels' extents
CHOICE(has_walls)         // 1: some glass has no thickness
CHOICE(paper_weights)     // 1: the flux of Shah et al. 2007, eq. 6 and 7
CHOICE(is_reflection)     // 1: follows what dielectrics mirror, not what they let in
CHOICE(has_mirrors)       // 1: some casters are metal
CHOICE(has_exit_maps)     // 1: solid casters let light out by a second surface
CHOICE(wyman_thickness)   // 1: the way inside is Wyman's thickness, not met in the exit maps
CHOICE(is_tinted)         // 1: blended surfaces may stand before casters
CHOICE(has_caster_tint)   // 1: caster_tint has the colours, not caster_materials
CHOICE(only_unconverged)  // 1: follows only what landed_before has not converged
