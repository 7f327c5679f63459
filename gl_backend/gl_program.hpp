// A pass's shader text as an OpenGL program.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "gl_backend/gl_object.hpp"
#include "gl_backend/gl_text.hpp"
#include "pipeline/gpu/shader.hpp"

namespace caustics::gl {

// Attribute i of the shader's interface has location i; varyings meet by name; textures, outputs
// and the uniform block (binding 0) have the numbers that the text gives them.
struct Program {
  ProgramObject object;
  ShaderInterface interface;
  // Bytes of the uniform block; 0 where the text has none that is used.
  int uniform_bytes = 0;
};

// The values of a shader's choices, in their order, in the uniform block of a draw.
std::vector<int> choices_in(const Shader& shader, std::span<const std::byte> uniforms);

// Compiles and links, for these values of the choices. Throws Error (InternalError) with the shader's name,
// the stage and the compiler's first complaint, whose line numbers count from the first line of Shader::text.
// `vertex_stage`: Vertex or VertexOfQuads.
Program make_program(const Shader& shader, std::span<const int> choices, Stage vertex_stage);

}  // namespace caustics::gl
