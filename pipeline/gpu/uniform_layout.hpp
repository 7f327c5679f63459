// What lies where in a shader's uniform block, and what it means: read from the shader's text, where it is
// declared, so that nobody says it twice. pipeline/shader/SUBSET.md says how blocks are written.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace caustics {

struct Shader;

// One value of a block. A member that is a struct is taken apart into its own.
struct UniformVariable {
  std::string name;        // "receiver.scale"
  std::string type;        // int, float, vec2, vec3, vec4 or mat4
  std::string meaning;     // the text's comment, with the unit; behind that of the struct it is part of
  std::size_t offset = 0;  // bytes
};

struct UniformLayout {
  std::vector<UniformVariable> variables;  // in the order of their offsets
  std::size_t bytes = 0;                   // of the block, a multiple of 16; 0: there is none
};

// Of a type of UniformVariable, in values of four bytes; 0 for other words.
int uniform_components(std::string_view type);

// By std140's rules (OpenGL 4.5 core, 7.6.2.2), which C++'s layout follows too: the build compares them.
// Throws Error (InternalError) when a member's type is neither of those above nor a struct of the text.
UniformLayout reflect_uniforms(std::string_view text);

// The same of a shader, read from its text once in the life of the process.
const UniformLayout& uniform_layout_of(const Shader& shader);

}  // namespace caustics
