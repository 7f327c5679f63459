mat4 from_scene;      // the frame that sees the casters
vec4 window;
vec4 depth;
vec4 material;        // row of the material in caster_materials, scale of the normal texture, side of a cube
                      // frame's map, unused
vec4 color_factor;    // rgb: what the base colour texture is multiplied by; a: unused
vec4 color_offset;    // rgb: added to that: a metal's dielectric share
vec4 uses;            // 1 where there is a texture: base colour, normal, transmission; unused
vec4 alpha;           // base colour alpha, cutoff (0 in opaque materials), uses the texture for it (0 or 1), unused
vec4 uv_row0;         // base colour: rows of u' = row . (u, v, 1)
vec4 uv_row1;
vec4 normal_row0;
vec4 normal_row1;
vec4 transmission_row0;
vec4 transmission_row1;
