#include "pipeline/gpu/allowance.hpp"

#include <limits>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// Ten texels of one channel with the value 1; the first differs by this. Its relative difference is of the
// larger value: 0.25 / 1.25 = 0.2.
ImageDifference off_by(float amount) {
  Image a(Format::R32F, 10, 1), b(Format::R32F, 10, 1);
  for (float& v : a.values) v = 1.0f;
  b.values = a.values;
  b.values[0] += amount;
  return difference(a, b);
}

const Allowance kOneInTen{"driver", "pass", "*", 0.1, 0.2, "a reason"};

}  // namespace

TEST_CASE("allowance: one covers what it names, as far as it says") {
  AllowanceBook book("driver", {kOneInTen});
  CHECK(book.covers("another pass", "color", off_by(0.125f)) == nullptr);
  CHECK(book.unused().size() == 1);
  const Allowance* found = book.covers("pass", "color", off_by(0.25f));
  REQUIRE(found);
  CHECK(found->reason == "a reason");
  CHECK(book.unused().empty());
  CHECK(book.covers("pass", "color", off_by(0.5f)) == nullptr);
}

TEST_CASE("allowance: more texels than it says are not covered") {
  Allowance none = kOneInTen;
  none.texels = 0.05;
  AllowanceBook book("driver", {none});
  CHECK(book.covers("pass", "color", off_by(0.125f)) == nullptr);
}

TEST_CASE("allowance: another driver's is of no use") {
  AllowanceBook book("another driver", {kOneInTen});
  CHECK(book.covers("pass", "color", off_by(0.125f)) == nullptr);
  CHECK(book.unused().empty());
}

TEST_CASE("allowance: a NaN on one side alone is never covered") {
  Allowance all = kOneInTen;
  all.texels = 1.0;
  all.relative = 2.0;
  AllowanceBook book("driver", {all});
  Image a(Format::R32F, 1, 1), b(Format::R32F, 1, 1);
  b.values[0] = std::numeric_limits<float>::quiet_NaN();
  CHECK(book.covers("pass", "color", difference(a, b)) == nullptr);
}
