// The environment, as a uniform: a gradient with soft boxes, or an image. Include before UNIFORMS_BEGIN;
// shader_sky() in passes/shared/sky_uniforms.hpp fills it.
struct SoftBox {
  vec3 middle;        // its axes, orthonormal
  float radiance;     // nit
  vec3 across;
  float half_width;   // tangents of the angles from the middle
  vec3 upward;
  float half_height;
};
struct Sky {
  vec3 zenith;    // nit
  vec3 horizon;   // nit
  vec3 ground;    // nit
  int has_image;  // 1: the texture environment, instead of these
  vec3 backdrop;  // nit: seen directly below the horizon, instead of `ground`
  int has_boxes;  // 1: these, before the gradient
  SoftBox key;
  SoftBox rim;
  SoftBox fill;
  vec2 turn;      // of the image about the vertical: cosine and sine
};
