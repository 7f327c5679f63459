#include "passes/template/copy.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("copy: every texel is the picture's, each channel times the exposure") {
  const Pass pass = copy_pass();
  Image beauty(Format::RGBA32F, 2, 1);
  beauty.values = {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f};
  const PassImages out = run_pass(
      definition_of(pass),
      {.width = 2, .height = 1, .uniforms = pass.uniforms({.exposure = 0.5f}), .textures = {beauty}});
  CHECK(out["copy"].values == std::vector<float>{0.5f, 1.0f, 1.5f, 2.0f, 2.5f, 3.0f, 3.5f, 4.0f});
}
