float bend;           // an index of refraction is n_d + bend (n_F - n_C)
int most_steps;       // of the search for one surface
int first_receiver;   // number of the first triangle that is no caster's
float touch;          // metres: surfaces that are as near touch
float rough_from;     // roughness above which glass spreads light
int first_uv;         // the first texel of texture coordinates in hierarchy_normals
CHOICE(has_textures)  // 1: some caster has
CHOICE(has_cut_outs)  // 1: some receiver has holes
CHOICE(has_rough)     // 1: some glass is rough
CHOICE(has_walls)     // 1: some has no thickness
