#pragma once
#include "passes/shared/light_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) Walk {
#include "passes/walk/walk_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// Steps that the search for one surface may take, of light that is bent `bounces` times: llvmpipe ends an
// invocation's loops after 65,535 rounds, all counted.
constexpr int most_steps(int bounces) { return 65000 / (bounces + 1) - 1; }

// As `stretches` has them, too, which walks the same way once more.
std140::Walk walk_uniforms(const PassContext& context);
std::vector<Read> reads_of_walk();
std::vector<Choice> choices_of_walk();

// walk.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass walk_pass();

}  // namespace caustics
