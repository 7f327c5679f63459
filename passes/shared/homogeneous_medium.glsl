// A homogeneous medium that fills a box, outside of glass, as a uniform (docs/medium.md). Include before
// UNIFORMS_BEGIN; medium_uniforms.hpp fills it.
struct Medium {
  vec3 lower;       // the box, scene space
  float anisotropy; // Henyey and Greenstein's g
  vec3 upper;
  int is_grey;      // the extinction is the same in all channels
  vec3 extinction;  // per metre
  vec3 scattering;  // per metre
};
