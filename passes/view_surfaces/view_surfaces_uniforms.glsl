View view;              // the camera's
vec4 base_factor;       // rgb: albedo; a: opacity
float alpha_cutoff;     // 0 in opaque materials; in blended ones what is opaque
CHOICE(has_lift)        // some surfaces are smooth-shaded
CHOICE(layer)           // 0: what is opaque; 1: the nearest blended surface; 2: the next behind a layer
float pixel_side;       // at distance 1, over the root of the samples a pixel; 0: there are no mip maps
int has_colors;         // the vertices' colours stand where others have their tangents
int is_double_sided;    // or a closed body inside out; else its back is not seen
float normal_scale;
vec3 emissive_factor;   // nit
vec3 fade_centre;       // from all of the surface to none of it, by the distance from here
float fade_from;
float fade_to;          // 0: no fade
float metallic;         // of all of it, or what the texture is multiplied with; roughness likewise
vec3 dielectric;        // reflectance at normal incidence of what is not metal,
float coat;             // and at grazing incidence
int is_coated;          // 1: what the dielectric mirrors is taken from what it scatters
float roughness;
SurfaceTexture base_color_use;
SurfaceTexture normal_use;
SurfaceTexture emissive_use;
SurfaceTexture metallic_roughness_use;
SurfaceTexture occlusion_use;
float occlusion_strength;
int is_partly_diffuse;  // of a layer: glass, or a pane, of which only what is not let through is drawn
int is_pane;
float glass_ior;
int is_covering;        // of a pane: opacity counts as coverage
float transmitted;      // share of what is not mirrored that goes through, times the texture
int has_transmission;
TextureTransform transmission_uv;
