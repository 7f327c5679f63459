// The types of uniform blocks under the names that GLSL has for them, aligned so that C++ lays a block out as
// std140 does (OpenGL 4.5 core, 7.6.2.2): a vec3 starts at a multiple of 16 bytes and takes 12, so that a
// scalar fits behind it. One text then declares a block for both sides; cmake/shaders.cmake has every offset
// checked by the compiler.
#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>

// What Pass::uniforms fills (pipeline/plan/pass.hpp); a block that is filled otherwise has 0.
#define CHOICE(name) int name = 0;

namespace caustics::std140 {

using vec2 __attribute__((aligned(8))) = glm::vec2;
using vec3 __attribute__((aligned(16))) = glm::vec3;
using vec4 __attribute__((aligned(16))) = glm::vec4;
using mat4 __attribute__((aligned(16))) = glm::mat4;

#include "pipeline/shader/view.glsl"

}  // namespace caustics::std140
