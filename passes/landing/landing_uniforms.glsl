View caster;              // the light's views: of the casters,
View receiver;            // of what its light can land on,
View caustic;             // and of the map that the landings are laid into
LightCone cone;
vec3 light;               // of parallel light the direction of travel, else the position; scene space
float cell_area;          // of a grid cell, window units squared
vec3 channel_share;       // the branch's share of each channel's flux
float bend;               // the branch's index of refraction is n_d + bend (n_F - n_C)
vec3 receivers_lower;     // the box around all receivers, scene space
float exit_tolerance;     // how far from its surface a ray may end and still have met it, texels' extents
vec3 receivers_upper;
float landing_tolerance;
vec3 impostor_centre;     // scene space
float tile_width;         // of a cube's caster map, texels
float tile_height;
float tile_guard;
int iterations;
float search_start;       // of the estimators paper and newton, metres
float newton_epsilon;     // metres; 0: a texel's extent
CHOICE(newton_guard)      // 1: no step where the slope is lost, nor beyond the view's depth
CHOICE(draws_unconverged) // 1: what has not converged is drawn where its search stopped
CHOICE(estimator)         // ESTIMATOR_PAPER ...
CHOICE(paper_weights)     // 1: the flux of Shah et al. 2007, eq. 6 and 7
CHOICE(is_reflection)     // 1: follows what dielectrics mirror, not what they let in
CHOICE(has_mirrors)       // 1: some casters are metal
CHOICE(has_exit_maps)     // 1: solid casters let light out by a second surface
CHOICE(wyman_thickness)   // 1: the way inside is Wyman's thickness, not met in the exit maps
CHOICE(has_caster_tint)   // 1: caster_tint has the colours, not caster_materials
CHOICE(only_unconverged)  // 1: follows only what landed_before has not converged
View impostor;            // the cube around the casters
