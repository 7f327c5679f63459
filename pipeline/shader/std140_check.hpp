// Follows std140's rules through a block or struct, member by member, and compares with where C++ has put
// them.
#pragma once
#include <cstddef>
#include <string_view>

namespace caustics {

class Std140Check {
 public:
  // The next member: its type's name and size, and its offset in C++.
  constexpr void member(std::string_view type, std::size_t size, std::size_t offset) {
    const std::size_t alignment = type == "int" || type == "float" ? 4 : type == "vec2" ? 8 : 16;
    end_ = (end_ + alignment - 1) / alignment * alignment;
    sound_ = sound_ && offset == end_;
    end_ += size;
  }
  // Was every offset right, and is the whole as long as C++ has it, a multiple of 16 bytes?
  constexpr bool sound(std::size_t whole) const { return sound_ && whole == (end_ + 15) / 16 * 16; }

 private:
  std::size_t end_ = 0;
  bool sound_ = true;
};

}  // namespace caustics
