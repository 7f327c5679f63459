#include "tests/support/failing_new.hpp"

#include <cstdlib>
#include <new>

// Where the linker lays the code of this program itself.
extern "C" const char __executable_start[], etext[];

namespace {

constexpr std::int64_t kNever = -1;
// Allocations that are left before the one that fails.
thread_local std::int64_t left = kNever;

bool is_own_code(const void* address) {
  return address >= static_cast<const void*>(__executable_start) && address < static_cast<const void*>(etext);
}

inline void* allocate(std::size_t bytes, const void* caller) {
  if (left != kNever && is_own_code(caller) && left-- == 0) throw std::bad_alloc();
  void* memory = std::malloc(bytes > 0 ? bytes : 1);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

// All forms but the aligned ones, which pair among themselves: what one of these gives another takes back.
void* operator new(std::size_t bytes) { return allocate(bytes, __builtin_return_address(0)); }
void* operator new[](std::size_t bytes) { return allocate(bytes, __builtin_return_address(0)); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return std::malloc(bytes > 0 ? bytes : 1);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return std::malloc(bytes > 0 ? bytes : 1);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace caustics::test {

// After the failure `left` stands at kNever: it fails once.
FailingNew::FailingNew(std::int64_t n) { left = n; }
FailingNew::~FailingNew() { left = kNever; }
bool FailingNew::failed() const { return left == kNever; }

}  // namespace caustics::test
