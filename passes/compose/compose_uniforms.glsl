Sky sky;
CameraRays camera;
CHOICE(layer)             // of blended surfaces: 1: the nearest; 2: a further one; 0: all else
CHOICE(behind_glass)      // what only glass shows
CHOICE(blends)            // there are blended surfaces
CHOICE(mirrors)           // surfaces show the environment
CHOICE(is_occluded)       // textures keep some of its light away
CHOICE(has_ambient_occlusion)  // other surfaces do
float boxes_mean;  // nit: of the soft boxes over the upper hemisphere, under the cosine
// Ambient irradiance by second-order spherical harmonics: the bands 0, 1 (y, z, x), 2 (xy, yz, 3zz-1, xz,
// xx-yy), convolved with the cosine; used with an environment image.
vec3 ambient_0;
vec3 ambient_1;
vec3 ambient_2;
vec3 ambient_3;
vec3 ambient_4;
vec3 ambient_5;
vec3 ambient_6;
vec3 ambient_7;
vec3 ambient_8;
