#include "passes/shared/sky_uniforms.glsl"
vec4 right;         // the camera's axes, scene space
vec4 up;
vec4 forward;       // w: 1 in a perspective view
vec4 pixel;         // window coordinates = (frag_x * x + z, frag_y * y + w)
// Ambient irradiance by second-order spherical harmonics: the bands 0, 1 (y, z, x), 2 (xy, yz, 3zz-1, xz,
// xx-yy), convolved with the cosine; used with an environment image.
vec4 ambient_0;
vec4 ambient_1;
vec4 ambient_2;
vec4 ambient_3;
vec4 ambient_4;
vec4 ambient_5;
vec4 ambient_6;
vec4 ambient_7;
vec4 ambient_8;
