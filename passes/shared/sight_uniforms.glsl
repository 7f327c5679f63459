View view;           // the camera's
vec3 eye;            // the camera's position
int surfaces;        // that bend a ray at most,
vec3 forward;        // the way the camera looks
int most_surfaces;   // and that it is followed through
float bend;          // the branch's index of refraction is n_d + bend (n_F - n_C): 0, the d line
int most_steps;      // of the search for one surface
int first_receiver;
float touch;
int first_uv;        // the first texel of texture coordinates in hierarchy_normals
float rough_from;    // from this roughness on the view is spread
vec4 eye_media;      // the bodies that the camera is in, as media.glsl has them
CHOICE(has_textures)     // 1: some surface has
CHOICE(has_rough)        // some glass is rough
CHOICE(has_walls)        // some has no thickness
CHOICE(has_sheets)       // 1: some surface scatters a share of what comes, and lets the rest through
