mat4 from_scene;      // the camera's view
vec4 window;
vec4 depth;
vec4 base_factor;     // rgb albedo, a opacity
vec4 alpha;           // opacity, cutoff (0 in opaque materials), unused, unused
vec4 emissive_factor; // rgb nit; w unused
vec4 uses;            // 1 where there is a texture: base colour, normal, emissive; w: scale of the normal texture
vec4 uv_row0;         // base colour: rows of u' = row . (u, v, 1)
vec4 uv_row1;
vec4 normal_row0;
vec4 normal_row1;
vec4 emissive_row0;
vec4 emissive_row1;
