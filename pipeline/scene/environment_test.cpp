#include "pipeline/scene/environment.hpp"

#include <cmath>

#include "pipeline/renderer/exposure.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Scene under(float radiance, double strength = 1.0) {
  Scene scene;
  scene.environment.image = filled(64, 32, {radiance, radiance, radiance, 1.0f});
  adjust(scene.environment, strength, 0.0);
  return scene;
}

Scene in_sun(float lux) {
  Scene scene;
  scene.lights = {Light{.name = "sun", .intensity = lux}};
  return scene;
}

double factor_of(const Scene& scene) {
  return static_cast<double>(exposure_of(scene, {}, {}, pilot()).factor);
}

}  // namespace

TEST_CASE("environment: of a constant environment only the first coefficient is left") {
  const auto c = environment_irradiance(filled(256, 128, {3.0f, 2.0f, 1.0f, 1.0f}));
  for (int channel = 0; channel < 3; ++channel) {
    CHECK(c[0][channel] == Approx(3.0 - channel));
    for (std::size_t i = 1; i < 9; ++i) CHECK(std::fabs(c[i][channel]) < 1e-4);
  }
}

TEST_CASE("environment: one that grows with height lights surfaces by two thirds of its slope") {
  // Radiance y, the sine of the elevation: a surface facing up receives 2 pi times the integral of cos^2 sin,
  // 2 pi / 3 over the upper half, which is pi times 2/3. By symmetry nothing else remains.
  Image image(Format::RGBA32F, 256, 128);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x)
      image.at(x, y, 0) = static_cast<float>(std::sin(((y + 0.5) / 128 - 0.5) * 3.14159265358979));
  const auto c = environment_irradiance(image);
  CHECK(c[1].x == Approx(2.0 / 3.0).epsilon(2e-4));
  for (const std::size_t i : {0, 2, 3, 4, 5, 6, 7, 8}) CHECK(std::fabs(c[i].x) < 1e-5);
}

TEST_CASE(
    "environment: radiance L from everywhere is exposed as a sun of pi L, both together as twice that") {
  const float lux = 3.14159265f * 2.5f;
  const double alone = factor_of(in_sun(lux));
  CHECK(factor_of(under(2.5f)) == Approx(alone).epsilon(1e-3));
  Scene both = under(2.5f);
  both.lights = in_sun(lux).lights;
  CHECK(factor_of(both) == Approx(0.5 * alone).epsilon(1e-3));
  // An open floor of albedo 0.7 under pi L lux shows 0.7 L nit: 0.31 of display white.
  CHECK(alone * 0.7 * 2.5 == Approx(0.31));
}

TEST_CASE("environment: its strength is a factor on image, gradient and ambient light") {
  Scene strong = under(2.0f, 3.0);
  CHECK(strong.environment.image->at(5, 5, 1) == 6.0f);
  CHECK(strong.environment.image->at(5, 5, 3) == 1.0f);
  CHECK(strong.environment.ambient[0].y == Approx(6.0));
  CHECK(factor_of(strong) == Approx(factor_of(under(2.0f)) / 3.0));
  Environment sky;
  sky.zenith = glm::vec3(1.0f);
  sky.horizon = glm::vec3(2.0f);
  adjust(sky, 0.5, 0.0);
  CHECK(sky.zenith == glm::vec3(0.5f));
  CHECK(sky.horizon == glm::vec3(1.0f));
  CHECK(under(3e38f, 1e6).environment.image->at(0, 0, 0) == std::numeric_limits<float>::max());
  CHECK(under(3e38f, 1.1).environment.image->at(0, 0, 0) == Approx(3.3e38f));
}
