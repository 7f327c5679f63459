// The uniform blocks of a run's draws, in one buffer that is filled once a run.
#pragma once
#include <cstddef>
#include <vector>

#include "gl_backend/gl_object.hpp"

namespace caustics::gl {

class UniformBuffer {
 public:
  UniformBuffer();  // asks the current context how blocks must be aligned
  // Forgets the last run's blocks.
  void clear();
  // Forgets the buffer too, which the driver may have left half made: the next upload makes another.
  void drop_buffer();
  // Appends a draw's block, zeros behind it up to `size` bytes where the program expects more.
  void add(const std::vector<std::byte>& block, int size);
  // Moves all blocks to the device. True when a larger buffer had to be made.
  bool upload();
  // Binds the i-th block that was added; nothing for an empty one.
  void bind(std::size_t i) const;

 private:
  struct Range {
    std::size_t offset = 0, size = 0;
  };
  std::size_t alignment_ = 256;
  std::size_t capacity_ = 0;
  BufferObject buffer_;
  std::vector<std::byte> bytes_;
  std::vector<Range> ranges_;
};

}  // namespace caustics::gl
