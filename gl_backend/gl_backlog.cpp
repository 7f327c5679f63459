#include "gl_backend/gl_backlog.hpp"

#include "pipeline/gpu/interrupt.hpp"

namespace caustics::gl {

namespace {

// Whether the wish to stop is to be looked at again: waiting went on for a twentieth of a second. A driver
// that fails to wait sets an error flag, which whoever checks the run finds.
bool still_waits(GLsync end) {
  constexpr GLuint64 kNanoseconds = 50'000'000;
  return glClientWaitSync(end, GL_SYNC_FLUSH_COMMANDS_BIT, kNanoseconds) == GL_TIMEOUT_EXPIRED;
}

}  // namespace

void Backlog::add() {
  ends_.push_back(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
  glFlush();
  while (ends_.size() > kMost) {
    while (still_waits(ends_.front())) stop_if_interrupted();
    glDeleteSync(ends_.front());
    ends_.pop_front();
  }
}

void Backlog::forget() noexcept {
  for (const GLsync end : ends_) glDeleteSync(end);
  ends_.clear();
}

}  // namespace caustics::gl
