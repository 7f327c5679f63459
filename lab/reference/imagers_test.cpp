// The surfaces without aberration, against rays bent by the plain vector forms.
#include "lab/reference/imagers.hpp"

#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("An ellipsoidal entry face sends every ray to one point inside the glass") {
  const EllipsoidalEntry face{.index = 1.5, .focus = 2.0};
  CHECK(face.largest_radius() == Approx(2.0 / std::sqrt(5.0)).epsilon(1e-14));
  for (const double r : {0.05, 0.3, 0.6, 0.85}) {
    const double z = face.surface(r);
    CHECK(2.25 * r * r + 1.25 * z * z == Approx(2.0 * 1.5 * 0.5 * 2.0 * z).epsilon(1e-13));
    CHECK(face.slope(r) == Approx((face.surface(r + 1e-6) - face.surface(r - 1e-6)) / 2e-6).epsilon(1e-7));
    const glm::dvec3 normal = glm::normalize(glm::dvec3(face.slope(r), 0.0, -1.0));
    const glm::dvec3 d = *refract_direction({0.0, 0.0, 1.0}, normal, 1.0 / 1.5);
    CHECK(r + d.x * (2.0 - z) / d.z == Approx(0.0).margin(1e-12));
    CHECK(face.landing(r, 1.2) == Approx(r + d.x * (1.2 - z) / d.z).epsilon(1e-12));
  }
}

TEST_CASE("A paraboloid mirrors every ray to its focus") {
  const ParaboloidMirror mirror{.focus = 0.25};
  for (const double r : {0.1, 0.5, 0.8, 1.0}) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-mirror.slope(r), 0.0, 1.0));
    const glm::dvec3 d = glm::reflect(glm::dvec3(0.0, 0.0, -1.0), normal);
    const double z = mirror.surface(r);
    // At r = 2 F the way to the focus is level.
    if (std::fabs(d.z) > 1e-12) {
      CHECK(r + d.x * (0.25 - z) / d.z == Approx(0.0).margin(1e-12));
      CHECK(mirror.landing(r, 0.1) == Approx(r + d.x * (0.1 - z) / d.z).epsilon(1e-12));
    }
  }
}
