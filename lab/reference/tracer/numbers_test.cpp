// Random numbers by counter.
#include "lab/reference/tracer/numbers.hpp"

#include <cmath>
#include <set>

#include "tests/support/catch.hpp"

namespace caustics::tracer {

TEST_CASE("tracer numbers: a shuffle meets every place once, whatever the count and the key") {
  for (const std::uint64_t count : {1u, 2u, 3u, 16u, 49u, 1000u, 4096u})
    for (const std::uint64_t key : {0ull, 7ull, 0xfedcba9876543210ull}) {
      std::set<std::uint64_t> places;
      for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t place = shuffled(i, count, key);
        REQUIRE(place < count);
        places.insert(place);
      }
      CHECK(places.size() == count);
    }
  CHECK(shuffled(5, 4096, 1) != shuffled(5, 4096, 2));
}

TEST_CASE("tracer numbers: rays draw independent even numbers, and always the same") {
  // Of 40,000 even numbers the mean is 1/2 +- 0.0014, that of products of neighbours 1/4 +- 0.0011; 4 of
  // these.
  double sum = 0.0, products = 0.0, across = 0.0;
  constexpr int kRays = 20'000;
  for (int ray = 0; ray < kRays; ++ray) {
    Numbers a(3, static_cast<std::uint64_t>(ray)), again(3, static_cast<std::uint64_t>(ray));
    Numbers other(4, static_cast<std::uint64_t>(ray));
    const double x = a.next(), y = a.next();
    CHECK((x >= 0.0 && x < 1.0 && again.next() == x));
    sum += x + y;
    products += x * y;
    across += x * other.next();
  }
  CHECK(std::fabs(sum / (2 * kRays) - 0.5) < 0.006);
  CHECK(std::fabs(products / kRays - 0.25) < 0.007);
  CHECK(std::fabs(across / kRays - 0.25) < 0.007);
}

}  // namespace caustics::tracer
