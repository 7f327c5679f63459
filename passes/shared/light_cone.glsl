// How a light falls off from its axis, as a uniform. Include before UNIFORMS_BEGIN; shader_cone() in
// passes/shared/light_uniforms.hpp fills it.
struct LightCone {
  vec3 axis;      // unit, scene space, the way the light shines
  float scale;    // of a spot light's falloff, clamp(offset - (1 - cos) scale, 0, 1)^2; 0: no cone
  float offset;
  int lambertian; // 1: the falloff is the cosine to the axis instead
};
