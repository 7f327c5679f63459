#include "pipeline/measure/splat_counts.hpp"

#include "pipeline/settings/splat_kernel.hpp"
#include "pipeline/shader/constants.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("splat counts: a splat counts in every texel that it touches, and in no other") {
  // On a map of 8 x 8 texels of 1 m: a landing in the middle of texel (5, 2), and one that did not land.
  BranchImages branch{};
  Image landing(Format::RGBA32F, 2, 1);
  const float places[2][4] = {{1.5f, 0.0f, 1.5f, STATUS_LANDED}, {-2.5f, 0.0f, 1.5f, STATUS_MISSED}};
  for (int x = 0; x < 2; ++x)
    for (int c = 0; c < 4; ++c) landing.at(x, 0, c) = places[x][c];
  branch.landing = landing;
  for (const double radius : {0.0, 1.2}) {
    SplatKernel kernel;
    kernel.radius = radius;
    const View view = down(4.0, 10.0, 20.0);
    SplatCounts splats(kernel, view, 8);
    splats.add(branch, {});
    const std::vector<std::uint32_t> counts = splats.by_texel();
    REQUIRE(counts.size() == 64);
    const int reach = radius > 0.0 ? 1 : 0;
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        CHECK(counts[static_cast<std::size_t>(8 * y + x)] ==
              (std::abs(x - 5) <= reach && std::abs(y - 2) <= reach ? 1u : 0u));
  }
}

TEST_CASE("splat counts: a cell counts in the rectangle around its four corners, one without light nowhere") {
  Image landing(Format::RGBA32F, 2, 1), flux(Format::RGBA32F, 2, 1);
  for (int x = 0; x < 2; ++x) landing.at(x, 0, 3) = STATUS_MISSED;
  flux.at(0, 0, 3) = 1.0f;
  Image near(Format::RGBA32F, 2, 1), far(Format::RGBA32F, 2, 1);
  for (int x = 0; x < 2; ++x) {
    const float corners[2][4] = {{2.5f, 2.5f, 3.5f, 3.2f}, {1.5f, 4.5f, 2.2f, 5.9f}};
    for (int c = 0; c < 4; ++c) {
      near.at(x, 0, c) = corners[0][c];
      far.at(x, 0, c) = corners[1][c];
    }
  }
  BranchImages branch{};
  branch.landing = landing;
  branch.cell_flux = flux;
  CellImages cells{};
  cells.near = near;
  cells.far = far;
  const View view = down(4.0, 10.0, 20.0);
  SplatCounts splats(SplatKernel{}, view, 8);
  splats.add(branch, cells);
  splats.add(branch, {});
  const std::vector<std::uint32_t> counts = splats.by_texel();
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      INFO("texel " << x << ", " << y);
      CHECK(counts[static_cast<std::size_t>(8 * y + x)] == (x >= 1 && x <= 3 && y >= 2 && y <= 5 ? 1u : 0u));
    }
}

TEST_CASE("splat counts: where landings are splatted one by one, no cell counts") {
  Image landing(Format::RGBA32F, 1, 1);
  const float place[4] = {1.5f, 0.0f, 1.5f, STATUS_LANDED};  // in texel (5, 2)
  for (int c = 0; c < 4; ++c) landing.at(0, 0, c) = place[c];
  const Image corners = filled(1, 1, {0.5f, 0.5f, 1.5f, 1.5f});
  BranchImages branch{};
  branch.landing = landing;
  CellImages cells{};
  cells.near = cells.far = corners;
  SplatKernel kernel;
  kernel.radius = 0.0;
  const View view = down(4.0, 10.0, 20.0);
  SplatCounts splats(kernel, view, 8);
  splats.add(branch, cells);
  std::vector<std::uint32_t> expected(64, 0u);
  expected[8 * 2 + 5] = 1u;
  CHECK(splats.by_texel() == expected);
}
