#include "passes/shared/sky_uniforms.glsl"
mat4 from_scene;    // the camera's view
vec4 window;
vec4 depth;
vec4 wide_window;   // the same view, three times as wide and high
vec4 wide_depth;
vec4 eye;           // xyz: the camera's position; w: 1 in a perspective view
vec4 forward;       // xyz: the way the camera looks
ivec4 method;       // x: steps of the intersection; y: 1: view_caster_tint has the colours
