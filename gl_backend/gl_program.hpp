// A pass's shader text as an OpenGL program.
#pragma once
#include "gl_backend/gl_object.hpp"
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

// Compiles and links. Throws Error (InternalError) with the shader's name, the stage and the
// compiler's first complaint, whose line numbers count from the first line of Shader::text.
Program make_program(const Shader& shader);

}  // namespace caustics::gl
