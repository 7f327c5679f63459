#include "gl_backend/gl_framebuffer.hpp"

#include <array>
#include <string>

#include "pipeline/gpu/error.hpp"

namespace caustics::gl {

FramebufferObject make_framebuffer(const std::vector<GLuint>& textures) {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  FramebufferObject framebuffer(id);
  std::vector<GLenum> buffers;
  for (std::size_t i = 0; i + 1 < textures.size(); ++i) {
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    buffers.push_back(textures[i] ? attachment : GL_NONE);
    if (textures[i]) glNamedFramebufferTexture(id, attachment, textures[i], 0);
  }
  if (textures.back()) glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, textures.back(), 0);
  if (buffers.empty())
    glNamedFramebufferDrawBuffer(id, GL_NONE);
  else
    glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(buffers.size()), buffers.data());
  if (glCheckNamedFramebufferStatus(id, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ExitCode::BackendUnavailable, "this driver cannot draw into such a set of " +
                                                  std::to_string(buffers.size()) +
                                                  " targets; --backend software works");
  return framebuffer;
}

void clear_targets(GLuint framebuffer, const PassRun& run) {
  const PassDefinition& definition = *run.definition;
  for (std::size_t i = 0; i < run.colors.size(); ++i) {
    if (run.colors[i] == TextureId::None || (!run.keep.empty() && run.keep[i])) continue;
    const ColorWrite& write = definition.writes[i];
    std::array<float, 4> value{};
    for (std::size_t c = 0; c < 4; ++c) value[c] = stored_value(write.format, write.clear[c]);
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, static_cast<GLint>(i), value.data());
  }
  if (definition.depth && (run.keep.empty() || !run.keep.back()))
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &definition.depth->clear);
}

}  // namespace caustics::gl
