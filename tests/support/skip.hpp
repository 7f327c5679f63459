// A test that cannot run here says why, and counts as skipped, never as passed. Version 2 of Catch2 has no
// macro for it.
#pragma once
#include <string>

namespace caustics::test {

// What ctest takes for skipped; a test that failed ends with another code.
inline constexpr int kSkippedExit = 4;

// Prints "skipped: CAUSE" and leaves the test, not to be called within an assertion. What has failed before
// still counts as failed.
[[noreturn]] void skip(const std::string& cause);

}  // namespace caustics::test
