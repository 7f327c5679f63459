#include "pipeline/scene/material_optics.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("optics: a volume leaves its colour after its distance") {
  Material glass;
  glass.attenuation_color = {0.5f, 1.0f, 0.25f};
  glass.attenuation_distance = 2.0f;
  const glm::vec3 absorption = absorption_of(glass);
  CHECK(std::exp(-2.0 * double(absorption.x)) == Approx(0.5));
  CHECK(absorption.y == 0.0f);
  CHECK(std::exp(-2.0 * double(absorption.z)) == Approx(0.25));
}

TEST_CASE("optics: dispersion is 20 over Abbe's number") {
  // n_F - n_C = (n_d - 1) / V_d.
  Material glass;
  glass.ior = 1.6f;
  glass.dispersion = 20.0f / 30.0f;
  CHECK(main_dispersion(glass) == Approx(0.6 / 30.0));
}

TEST_CASE("optics: what is metal in part mirrors its colour and a dielectric's share") {
  Material metal;
  metal.metallic = 0.75f;
  metal.base_color = {1.0f, 0.5f, 0.0f, 1.0f};
  const glm::vec3 mirrored = metal_reflectance(metal);
  CHECK(mirrored.x == Approx(0.76));
  CHECK(mirrored.y == Approx(0.385));
  CHECK(mirrored.z == Approx(0.01));
}
