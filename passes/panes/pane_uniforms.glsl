#include "passes/shared/sky_uniforms.glsl"
mat4 from_scene;    // the frame drawn into
vec4 window;
vec4 depth;
vec4 eye;           // xyz: where its rays start, if w is 1; else they are parallel
vec4 forward;       // xyz: the frame's axis; w: 1: write what the pane mirrors, not what it lets through
vec4 tint;          // rgb: base colour times transmission; w: index of refraction
vec4 alpha;         // base colour alpha, cutoff (0 in opaque materials), uses the texture for it (0 or 1), unused
vec4 uv_row0;       // base colour texture: u' = row0 . (u, v, 1)
vec4 uv_row1;
vec4 uses;          // base colour texture, depth of the nearest opaque surface (0 or 1 each); side of a cube view's map
vec4 shadow_window; // of a light: the frame of shadow_depth
vec4 shadow_range;
