#pragma once
#include "passes/shared/medium_uniforms.hpp"
#include "passes/walk/walk.hpp"

namespace caustics::std140 {

struct Stretches {
  Walk walk;
  Medium medium;
  int vertices_per_beam;
};

}  // namespace caustics::std140

namespace caustics {

// stretches.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass stretches_pass();

}  // namespace caustics
