// Framebuffers by their attachments.
#pragma once
#include <map>
#include <vector>

#include "gl_backend/gl_object.hpp"
#include "pipeline/gpu/pass_run.hpp"

namespace caustics::gl {

// A run's targets in order, the depth target (or None) last.
using Attachments = std::vector<TextureId>;

// Attaches the textures of these OpenGL names, the last one (or 0) as depth. Throws Error
// (BackendUnavailable) when the driver cannot draw into them together.
FramebufferObject make_framebuffer(const std::vector<GLuint>& textures);

// Clears what is not kept to the definition's values. Every mask must be open.
void clear_targets(GLuint framebuffer, const PassRun& run);

}  // namespace caustics::gl
