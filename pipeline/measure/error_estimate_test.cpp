#include "pipeline/measure/error_estimate.hpp"

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Image grey(int side, float value) {
  Image image(Format::R32F, side, side);
  for (float& v : image.values) v = value;
  return image;
}

// A light with one branch, a map of 8 x 8 texels and a grid of 3 x 3 vertices: one block of four cells.
struct Bench {
  LightViews views{};
  Settings settings;
  Ledger ledger;
  double pixel = 1.0;
  Image map = grey(8, 0.0f);
  Image landing = filled(3, 3, glm::vec4(0.0f)), flux = landing, cell_flux = landing;
  Image near = landing, far = landing;  // corners of cells

  Bench() { ledger.in_map = {1.0, 1.0, 1.0}; }
  // A cell from (x, y) to (x + w, y + 1), texels, with this flux in each channel.
  void put(int column, int row, float x, float y, float w, float flux) {
    set(near, column, row, {x, y, x + w, y});
    set(far, column, row, {x, y + 1, x + w, y + 1});
    set(cell_flux, column, row, {flux, flux, flux, 1.0f});
  }
  static void set(Image& image, int x, int y, const glm::vec4& value) {
    for (int c = 0; c < 4; ++c) image.at(x, y, c) = value[c];
  }
  ErrorEstimate estimate() const {
    BranchImages branch{};
    branch.landing = landing;
    branch.flux = flux;
    branch.cell_flux = cell_flux;
    return estimate_error({branch}, {{near, far}}, map, Image{}, views, settings, ledger, pixel);
  }
};

}  // namespace

TEST_CASE("error estimate: even light has none") {
  Bench bench;
  bench.map = grey(8, 1.0f / 64.0f);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column)
      bench.put(column, row, 2.0f + float(column), 2.0f + float(row), 1.0f, 0.25f);
  CHECK(bench.estimate().total() == 0.0);
  // Nor where cells have as much more light as they are larger.
  for (int row = 0; row < 2; ++row) bench.put(1, row, 3.0f, 2.0f + float(row), 3.0f, 0.75f);
  CHECK(bench.estimate().grid == Approx(0.0).margin(1e-9));
}

TEST_CASE("error estimate: a single bright texel") {
  // The mean of its four texels, a quarter, shows 9/16 of itself there: 9/64. The other 55/64 are missing
  // there and too much elsewhere. A third of that counts (second order).
  Bench bench;
  bench.map.values[3 * 8 + 3] = 1.0f;
  CHECK(bench.estimate().relative(bench.estimate().map) == Approx(2.0 * (1.0 - 9.0 / 64.0) / 3.0));
}

TEST_CASE("error estimate: cells of one block that differ from each other") {
  // Equal areas, and fluxes of 0.4, 0.2, 0.2, 0.2: 0.15 too much in one and 0.05 too little in three: 0.3, of
  // which a sixth.
  Bench bench;
  bench.put(0, 0, 2, 2, 1, 0.4f);
  bench.put(1, 0, 3, 2, 1, 0.2f);
  bench.put(0, 1, 2, 3, 1, 0.2f);
  bench.put(1, 1, 3, 3, 1, 0.2f);
  CHECK(bench.estimate().relative(bench.estimate().grid) == Approx(0.3 / 6.0));
}

TEST_CASE("error estimate: half of the light that cells leave to points counts") {
  // A landing of 0.25 in each channel, of which no cell has taken anything: 0.75 of 3.
  Bench bench;
  Bench::set(bench.landing, 1, 1, {0.0f, 0.0f, 0.0f, 1.0f});
  Bench::set(bench.flux, 1, 1, {0.25f, 0.25f, 0.25f, 0.0f});
  CHECK(bench.estimate().relative(bench.estimate().grid) == Approx(0.125));
}

TEST_CASE("error estimate: points against their light spread evenly between them") {
  // Four landings, two texels from each other, of 0.25 in each channel, in a map of 8 x 8 texels of 0.25:
  // each has all of its light in one texel instead of a quarter in each of four. 2 x 3/4 of all the light is
  // moved.
  Bench bench;
  bench.settings.splat = Splat::Point;
  bench.cell_flux = Image{};
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) {
      Bench::set(bench.landing, x, y, {-0.25f + 0.5f * float(x), -0.25f + 0.5f * float(y), 0.0f, 1.0f});
      Bench::set(bench.flux, x, y, {0.25f, 0.25f, 0.25f, 0.0f});
    }
  CHECK(bench.estimate().relative(bench.estimate().grid) == Approx(1.5));
  // Over a pixel of two texels a quarter of each point's light lies as it would.
  bench.pixel = 2.0;
  CHECK(bench.estimate().relative(bench.estimate().grid) < 1.0);
  // One in each texel is as good as even light; the middle one's neighbours are two steps apart, not one.
  bench.pixel = 1.0;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      Bench::set(bench.landing, x, y, {-0.125f + 0.25f * float(x), -0.125f + 0.25f * float(y), 0.0f, 1.0f});
      Bench::set(bench.flux, x, y, {1.0f / 9.0f, 1.0f / 9.0f, 1.0f / 9.0f, 0.0f});
    }
  CHECK(bench.estimate().grid == Approx(0.0).margin(1e-9));
}

TEST_CASE("error estimate: what differs within a texel is not seen") {
  Bench bench;
  bench.put(0, 0, 2.0f, 2.0f, 0.25f, 0.4f);
  bench.put(1, 0, 2.25f, 2.0f, 0.25f, 0.2f);
  bench.put(0, 1, 2.5f, 2.0f, 0.25f, 0.2f);
  bench.put(1, 1, 2.75f, 2.0f, 0.25f, 0.2f);
  CHECK(bench.estimate().grid == Approx(0.0).margin(1e-9));
}

TEST_CASE("error estimate: flux that is not in the map is missing") {
  Bench bench;
  bench.ledger.outside = {0.01, 0.01, 0.01};
  bench.ledger.not_converged = {0.02, 0.02, 0.02};
  bench.ledger.missed = {0.5, 0.5, 0.5};  // leaves the scene, as it does in truth
  CHECK(bench.estimate().total() == Approx(0.03));
}

TEST_CASE(
    "error estimate: nothing is said of nothing, nor of points on the maps of a light that sees all around") {
  Bench bench;
  bench.ledger.in_map = {};
  CHECK(bench.estimate().total() == 0.0);
  bench.ledger.in_map = {1.0, 1.0, 1.0};
  bench.views.caustic.cube = CubeAtlas{};
  bench.cell_flux = Image{};
  CHECK(bench.estimate().landed == 0.0);
}

TEST_CASE("error estimate: what evens out over a pixel does not count") {
  // A bright texel's error is 55/64 there and as much with the other sign within two texels around it (the
  // four texels of its block show 9, 3, 3 and 1 of 64, their neighbours the rest). A box of 3 texels leaves
  // less of it, one of 5 still less.
  Bench bench;
  bench.map.values[3 * 8 + 3] = 1.0f;
  const double own = bench.estimate().map;
  bench.pixel = 3.0;
  const double three = bench.estimate().map;
  bench.pixel = 5.0;
  CHECK(three < 0.8 * own);
  CHECK(bench.estimate().map < three);
  CHECK(bench.estimate().map > 0.0);
}
