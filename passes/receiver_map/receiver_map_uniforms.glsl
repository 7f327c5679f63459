mat4 from_scene;  // the frame drawn into
vec4 window;
vec4 depth;
vec4 alpha;       // base colour alpha, cutoff (0 in opaque materials), uses the texture (0 or 1), side of a cube view's map
vec4 uv_row0;     // base colour texture: u' = row0 . (u, v, 1)
vec4 uv_row1;
vec4 column;       // the window which receivers leave free between the light and the casters
vec4 column_depth; // its depth range; w: up to which z it is left free
