View view;               // what sees the casters
AlphaMask mask;          // its uv are the base colour's
TextureTransform normal_uv;
TextureTransform transmission_uv;
vec3 color_factor;       // what the base colour texture is multiplied by,
float normal_scale;      // of the normal texture
vec3 color_offset;       // and what is added to that: a metal's dielectric share
int material_row;        // in caster_materials
int has_base_color;      // 1: there is such a texture
int has_normal_texture;
int has_transmission;
int map_side;            // of a cube view's map, texels
int first_triangle;      // of the mesh in the hierarchy
