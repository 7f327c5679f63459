View view;            // the view drawn into
int map_side;         // of a cube's map, texels
vec3 eye;             // where a perspective view's rays start
vec3 forward;         // the view's axis, the way of parallel rays
vec3 color;           // base colour
float ior;
float fresnel;        // of what Fresnel's equations mirror
float transmitted;    // share of what is not mirrored that goes through, times the texture
int has_transmission;
TextureTransform transmission_uv;
int is_covering;      // opacity counts as coverage
int has_base_color;   // a texture
TextureTransform base_color_uv;
AlphaMask alpha_mask;   // of a blended surface: what is not opaque
int is_blended;         // a surface that covers a share of what lies behind, not a pane
View shadow_view;     // of a light: the view of shadow_depth
CHOICE(has_shadow_map)
CHOICE(before_casters)  // keep what lies before casters, not all before opaque surfaces
