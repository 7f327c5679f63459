Sky sky;
View view;           // the camera's
View surroundings;   // the same, three times as wide and high
vec3 eye;            // the camera's position
int surfaces;        // that bend a ray at most,
int most_surfaces;   // and that it is followed through
vec3 forward;        // the way the camera looks
float bend;          // the branch's index of refraction is n_d + bend (n_F - n_C): 0, the d line
int most_steps;      // of the search for one surface
int first_receiver;
float touch;
int first_uv;        // the first texel of texture coordinates in hierarchy_normals
CHOICE(blends)           // there are blended surfaces
CHOICE(several_rays)     // 1: two or four rays a pixel, else one
CHOICE(has_textures)     // 1: some caster has
