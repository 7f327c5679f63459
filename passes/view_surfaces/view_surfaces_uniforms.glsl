View view;              // the camera's
vec4 base_factor;       // rgb: albedo; a: opacity
float alpha_cutoff;     // 0 in opaque materials; in blended ones what is opaque
CHOICE(layer)           // 0: what is opaque; 1: the nearest blended surface; 2: the next behind a layer
int has_base_color;     // textures
int has_normal;
int has_emissive;
int has_metallic_roughness;
int has_occlusion;
float normal_scale;
vec3 emissive_factor;   // nit
vec3 fade_centre;       // from all of the surface to none of it, by the distance from here
float fade_from;
float fade_to;          // 0: no fade
float metallic;         // of all of it, or what the texture is multiplied with; roughness likewise
float dielectric;       // reflectance at normal incidence of what is not metal
float roughness;
TextureTransform base_color_uv;
TextureTransform normal_uv;
TextureTransform emissive_uv;
TextureTransform metallic_roughness_uv;
TextureTransform occlusion_uv;
float occlusion_strength;
