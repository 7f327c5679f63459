// Runs the scalar kernel of a full-screen pass for single texels, with its trace.
#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "app/frame.hpp"
#include "pipeline/shader/kernel.hpp"

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
  std::vector<NamedValues> given;   // likewise, what the kernel gives, rounded to the format
  bool discarded = false;           // the shader writes nothing here
  bool agrees = true;  // the kernel's outputs, added to what was there, equal `stored` to the bit
};

// A pass that has just run, with its inputs as they were then.
class ProbedPass {
 public:
  // `before`: what is added to, by the definition's writes; empty: nothing that blends is judged.
  ProbedPass(const RenderedFrame& frame, const PlannedPass& pass, std::vector<Image> before = {});
  ProbedTexel at(int x, int y) const;

  // Shades these texels, at most kBlock, one after the other; the last one fills the block.
  struct Place {
    int x, y;
  };
  using Outputs = std::vector<std::array<float, kBlock>>;  // [4 * location + channel][lane]
  Outputs shade(std::span<const Place> places, TraceSink& trace,
                std::array<std::int32_t, kBlock>& discarded) const;

 private:
  const PlannedPass& pass_;
  PassRun run_;
  std::vector<Image> inputs_, before_, stored_;  // by reads, writes, writes
};

}  // namespace caustics::app
