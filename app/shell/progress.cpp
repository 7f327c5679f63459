#include "app/shell/progress.hpp"

#include <cmath>
#include <cstdio>

#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {
constexpr double kQuietStart = 2000.0, kBetweenLines = 1000.0;  // milliseconds, off a terminal
constexpr std::size_t kColumns = 78;
constexpr double kFirstGuess = 1000.0, kLeastShare = 0.1;
}  // namespace

std::string left_text(double milliseconds, double share) {
  if (milliseconds < kFirstGuess || share < kLeastShare || share >= 1.0) return {};
  const double seconds = std::ceil(milliseconds * (1.0 - share) / share / 1000.0);
  return ", about " + duration_text(1000.0 * seconds) + " left";
}

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(is_terminal(stderr)) {}

void Progress::show(const std::string& step) {
  if (quiet_) return;
  const double now = watch_.milliseconds();
  std::string line = one_line(step) + "  " + duration_text(now);
  if (terminal_) {
    if (line.size() > kColumns) line.resize(kColumns);
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    std::fflush(stderr);
    shown_ = true;
  } else if (now > kQuietStart && now - last_ > kBetweenLines) {
    std::fprintf(stderr, "%s\n", line.c_str());
    last_ = now;
  }
}

void Progress::clear() {
  if (!shown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace caustics::app
