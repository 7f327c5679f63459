// A light, as a uniform. Include light_cone.glsl and this before UNIFORMS_BEGIN; shader_light() in
// passes/shared/light_uniforms.hpp fills it.
struct Light {
  vec3 position;     // scene space; of a light that has one
  int has_position;  // 0: a directional light
  vec3 direction;    // of a directional light: the way it shines, unit, scene space
  float range;       // of a light with a position: how far it reaches, metres; 0: without end
  vec3 intensity;    // lux (directional) or candela, by channel
  float radius;      // of a light with a position: Light::sample_radius (pipeline/scene/scene.hpp), metres
  LightCone cone;
};
