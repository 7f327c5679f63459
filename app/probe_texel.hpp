// Runs the scalar kernel of a full-screen pass for one texel, with its trace.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "app/frame.hpp"

namespace caustics::app {

struct NamedValues {
  std::string name;
  std::array<float, 4> values{};
  int count = 0;
};

struct ProbedTexel {
  std::vector<NamedValues> inputs;  // the texel of each texture that has the pass's size
  std::vector<NamedValues> trace;   // in the order in which the shader hands them out
  std::vector<NamedValues> stored;  // by the definition's writes, as the rendered frame holds them
  bool discarded = false;           // the shader writes nothing here
  bool agrees = true;  // the kernel's outputs equal `stored` to the bit, but for what is added up
};

// The pass must have run, and its inputs must be as they were then.
ProbedTexel probe_texel(const RenderedFrame& frame, const PlannedPass& pass, int x, int y);

}  // namespace caustics::app
