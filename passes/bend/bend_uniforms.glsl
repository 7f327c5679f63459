#include "passes/shared/bend_light_uniforms.glsl"
int first_receiver;       // number of the first triangle that is no caster's
