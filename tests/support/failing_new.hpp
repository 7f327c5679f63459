// Memory that runs out: operator new of the tests' program, which fails once at an allocation of one's
// choice.
#pragma once
#include <cstdint>

namespace caustics::test {

// While one lives, the n-th allocation of this thread from its making on, 0 the first, throws std::bad_alloc.
// Only what the program's own code asks for counts; shared libraries may take it worse.
class FailingNew {
 public:
  explicit FailingNew(std::int64_t n);
  ~FailingNew();
  FailingNew(const FailingNew&) = delete;
  FailingNew& operator=(const FailingNew&) = delete;
  // Has it failed yet?
  bool failed() const;
};

}  // namespace caustics::test
