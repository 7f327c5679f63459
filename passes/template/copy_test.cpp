#include "passes/template/copy.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("copy: every texel is the source's, each channel times its factor") {
  Image source(Format::RGBA32F, 2, 1);
  source.values = {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f};
  std140::Copy uniforms{};
  uniforms.factor = {2.0f, 0.5f, 0.0f, 1.0f};
  const PassImages out = run_pass(
      copy_pass(), {.width = 2, .height = 1, .uniforms = uniform_bytes(uniforms), .textures = {source}});
  CHECK(out["copy"].values == std::vector<float>{2.0f, 1.0f, 0.0f, 4.0f, 10.0f, 3.0f, 0.0f, 8.0f});
}
