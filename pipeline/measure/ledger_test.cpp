#include "pipeline/measure/ledger.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("ledger: the residual is what no account holds, in the worst channel") {
  Ledger ledger{.entered = {1.0, 2.0, 4.0}, .absorbed = {0.25, 0.0, 0.0}, .in_map = {0.75, 2.0, 3.0}};
  CHECK(ledger.residual() == Approx(0.25));
  // What rounding has taken is booked as far as its bound allows.
  ledger.rounding = {0.0, 0.0, 1.0};
  CHECK(ledger.residual() == Approx(0.25));
  ledger.rounding_bound = {0.0, 0.0, 0.5};
  CHECK(ledger.residual() == Approx(0.125));
  CHECK(Ledger{}.residual() == 0.0);
}

TEST_CASE("ledger: a sample's ledger counts by its share") {
  Ledger sum{.entered = {1.0, 1.0, 1.0}};
  add(sum, Ledger{.entered = {2.0, 4.0, 8.0}, .missed = {1.0, 1.0, 1.0}, .vertices = {0, 5}}, 0.25);
  CHECK(sum.entered == FluxRgb{1.5, 2.0, 3.0});
  CHECK(sum.missed == FluxRgb{0.25, 0.25, 0.25});
  CHECK(sum.vertices[1] == 5);
}
