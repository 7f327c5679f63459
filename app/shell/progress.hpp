// What a person sees while a frame is rendered: one line that renews itself on a terminal, plain
// lines elsewhere once a run takes longer than two seconds, nothing when quiet.
#pragma once
#include <string>

#include "pipeline/gpu/stopwatch.hpp"

namespace caustics::app {

// ", about 12 s left" of work of which a share was done in so many milliseconds; empty before that can be
// told.
std::string left_text(double milliseconds, double share);

class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // "loading", "rendering (3 of 14: caster_map[sun])", ...
  void show(const std::string& step);
  // Takes the terminal's line away.
  void clear();

 private:
  bool quiet_, terminal_, shown_ = false;
  double last_ = 0.0;
  Stopwatch watch_;
};

}  // namespace caustics::app
