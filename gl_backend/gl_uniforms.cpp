#include "gl_backend/gl_uniforms.hpp"

#include <algorithm>

namespace caustics::gl {

UniformBuffer::UniformBuffer() {
  GLint alignment = 0;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  alignment_ = static_cast<std::size_t>(std::max(alignment, 1));
}

void UniformBuffer::clear() {
  bytes_.clear();
  ranges_.clear();
}

void UniformBuffer::drop_buffer() {
  buffer_ = BufferObject();
  capacity_ = 0;
}

void UniformBuffer::add(const std::vector<std::byte>& block, int size) {
  const std::size_t start = (bytes_.size() + alignment_ - 1) / alignment_ * alignment_;
  const std::size_t bytes = std::max(block.size(), static_cast<std::size_t>(std::max(size, 0)));
  ranges_.push_back({start, bytes});
  bytes_.resize(start);
  bytes_.insert(bytes_.end(), block.begin(), block.end());
  bytes_.resize(start + bytes);
}

bool UniformBuffer::upload() {
  if (bytes_.empty()) return false;
  const bool grow = bytes_.size() > capacity_;
  if (grow) {
    capacity_ = std::max<std::size_t>(16384, 2 * bytes_.size());
    GLuint id = 0;
    glCreateBuffers(1, &id);
    buffer_ = BufferObject(id);
    glNamedBufferData(id, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
  } else {
    // The last run may still read the old contents: let the driver give the buffer fresh memory.
    glInvalidateBufferData(buffer_.id());
  }
  glNamedBufferSubData(buffer_.id(), 0, static_cast<GLsizeiptr>(bytes_.size()), bytes_.data());
  return grow;
}

void UniformBuffer::bind(std::size_t i) const {
  const Range& range = ranges_[i];
  if (range.size == 0) return;
  glBindBufferRange(GL_UNIFORM_BUFFER, 0, buffer_.id(), static_cast<GLintptr>(range.offset),
                    static_cast<GLsizeiptr>(range.size));
}

}  // namespace caustics::gl
