#include "gl_backend/gl_program.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "pipeline/gpu/error.hpp"

namespace caustics::gl {

namespace {

// The first line that says "error", else the first that says anything; on one line.
std::string complaint(const std::vector<char>& log) {
  std::string_view rest(log.data());
  std::string first;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string line(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.find("error") != std::string::npos || line.find("ERROR") != std::string::npos) return line;
    if (first.empty()) first = line;
  }
  return first.empty() ? "no reason given" : first;
}

[[noreturn]] void refuse(const Shader& shader, const char* stage, const std::vector<char>& log) {
  throw Error(ExitCode::InternalError, "shader '" + std::string(shader.name) + "' (" + stage +
                                           "): OpenGL refuses it: " + complaint(log));
}

ShaderObject compile(const Shader& shader, Stage stage, std::span<const int> choices) {
  const std::string text = gl_text(shader, stage, choices);
  const GLchar* start = text.data();
  const GLint size = static_cast<GLint>(text.size());
  ShaderObject object(glCreateShader(stage == Stage::Fragment ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER));
  glShaderSource(object.id(), 1, &start, &size);
  glCompileShader(object.id());
  GLint compiled = GL_FALSE, length = 0;
  glGetShaderiv(object.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return object;
  glGetShaderiv(object.id(), GL_INFO_LOG_LENGTH, &length);
  std::vector<char> log(static_cast<std::size_t>(std::max(length, 0)) + 1);
  glGetShaderInfoLog(object.id(), length, nullptr, log.data());
  refuse(shader, stage == Stage::Fragment ? "fragment stage" : "vertex stage", log);
}

int uniform_bytes_of(GLuint program) {
  const GLuint block = glGetUniformBlockIndex(program, "UniformBlock");
  if (block == GL_INVALID_INDEX) return 0;
  GLint bytes = 0;
  glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
  return bytes;
}

}  // namespace

std::vector<int> choices_in(const Shader& shader, std::span<const std::byte> uniforms) {
  std::vector<int> values;
  for (const ShaderChoice& choice : choices_of(shader))
    std::memcpy(&values.emplace_back(), &uniforms[choice.offset], sizeof(int));
  return values;
}

Program make_program(const Shader& shader, std::span<const int> choices, Stage vertex_stage) {
  Program program{ProgramObject(glCreateProgram()), interface_of(shader)};
  const GLuint id = program.object.id();
  const ShaderObject vertex = compile(shader, vertex_stage, choices);
  const ShaderObject fragment = compile(shader, Stage::Fragment, choices);
  glAttachShader(id, vertex.id());
  glAttachShader(id, fragment.id());
  for (std::size_t i = 0; i < program.interface.attributes.size(); ++i)
    glBindAttribLocation(id, static_cast<GLuint>(i), program.interface.attributes[i].name.c_str());
  glLinkProgram(id);
  GLint linked = GL_FALSE, length = 0;
  glGetProgramiv(id, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> log(static_cast<std::size_t>(std::max(length, 0)) + 1);
    glGetProgramInfoLog(id, length, nullptr, log.data());
    refuse(shader, "linking", log);
  }
  glDetachShader(id, vertex.id());
  glDetachShader(id, fragment.id());
  program.uniform_bytes = uniform_bytes_of(id);
  return program;
}

}  // namespace caustics::gl
