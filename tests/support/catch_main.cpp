// The tests' main, for Catch2 version 2 and 3: exit code 0 for tests that passed, kSkippedExit where some
// were skipped and none failed, else 1.
#define CATCH_CONFIG_RUNNER
#include <cstdio>
#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include "tests/support/catch.hpp"
#include "tests/support/skip.hpp"

namespace {
int skipped = 0;
}

namespace caustics::test {

void skip(const std::string& cause) {
  ++skipped;
  std::printf("skipped: %s\n", cause.c_str());
  std::fflush(stdout);
  // How Catch2 leaves a test at a REQUIRE that does not hold; what failed, if anything, it has noted before.
  throw Catch::TestFailureException();
}

}  // namespace caustics::test

int main(int count, char** arguments) {
#ifdef M_TRIM_THRESHOLD
  // Images come and go by the hundred: between them their memory stays here, or the system would clear it
  // each time.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
  if (Catch::Session().run(count, arguments) != 0) return 1;
  return skipped > 0 ? caustics::test::kSkippedExit : 0;
}
