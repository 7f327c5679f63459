// Names of OpenGL objects that delete themselves. Their context must be current when they do.
#pragma once
#include <epoxy/gl.h>

#include <utility>

namespace caustics::gl {

template <void (*kDelete)(GLuint)>
class Owned {
 public:
  Owned() = default;
  explicit Owned(GLuint id) : id_(id) {}
  Owned(Owned&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() {
    if (id_ != 0) kDelete(id_);
  }
  GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};

inline void delete_texture(GLuint id) { glDeleteTextures(1, &id); }
inline void delete_buffer(GLuint id) { glDeleteBuffers(1, &id); }
inline void delete_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void delete_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
inline void delete_query(GLuint id) { glDeleteQueries(1, &id); }
inline void delete_shader(GLuint id) { glDeleteShader(id); }
inline void delete_program(GLuint id) { glDeleteProgram(id); }

using TextureObject = Owned<delete_texture>;
using BufferObject = Owned<delete_buffer>;
using FramebufferObject = Owned<delete_framebuffer>;
using VertexArrayObject = Owned<delete_vertex_array>;
using QueryObject = Owned<delete_query>;
using ShaderObject = Owned<delete_shader>;
using ProgramObject = Owned<delete_program>;

}  // namespace caustics::gl
