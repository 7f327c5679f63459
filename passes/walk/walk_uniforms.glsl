#include "passes/shared/grid_light_uniforms.glsl"
View receiver;        // the light's view of what its light can land on
View caustic;         // the light's map that the landings are laid into
vec3 light_middle;    // of a light with a size: its middle, of a disk the way it shines
float light_radius;   // metres, of a rectangle as of a disk as large; of a disk the tangent of half its angle
vec3 light_width;     // a rectangle's edges
vec3 light_height;
vec3 channel_share;   // the branch's share of each channel's flux
float bend;           // the branch's index of refraction is n_d + bend (n_F - n_C)
float least_share;    // of the light on a cell, below which it is followed no further
int bounces;          // surfaces that light is bent at, at most
int splits;           // of them, those where what is mirrored is followed as well, by other branches
int mirrored_at;      // the one where this branch is mirrored; 0: none
int most_steps;       // of the search for one surface
int first_receiver;   // number of the first triangle that is no caster's
float touch;          // metres: surfaces that are as near touch
float rough_from;     // roughness above which glass spreads light
int first_uv;         // the first texel of texture coordinates in hierarchy_normals
int light_points;     // of a mesh that shines: the first texel of its points in hierarchy_normals
CHOICE(is_tinted)     // 1: blended surfaces may stand before casters
CHOICE(can_be_hidden) // 1: receivers may hide others from the light; 2: and it lands on backs, which count so
CHOICE(draws)         // 1: the branch follows what the others leave behind, by ways that are drawn
CHOICE(reads_hit)     // 1: the second surface has been found by a branch that comes to it alike
CHOICE(has_textures)  // 1: some caster has
CHOICE(has_cut_outs)  // 1: some receiver has holes
CHOICE(has_rough)     // 1: some glass is rough
CHOICE(has_walls)     // 1: some has no thickness
CHOICE(light_shape)   // 0: the light has no size; 1: a ball, 2: a rectangle, 3: a disk far away,
                      // 4: a ball that shines as a Lambertian surface, 5: any other mesh that does
