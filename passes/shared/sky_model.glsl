// The environment, as a uniform: a gradient, or an image beside it. Include before UNIFORMS_BEGIN;
// shader_sky() in passes/shared/sky_uniforms.hpp fills it.
struct Sky {
  vec3 zenith;    // nit
  vec3 horizon;   // nit
  vec3 ground;    // nit
  int has_image;  // 1: the texture environment, instead of these
  vec2 turn;      // of the image about the vertical: cosine and sine
};
