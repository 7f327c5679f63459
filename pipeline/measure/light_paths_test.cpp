#include "pipeline/measure/light_paths.hpp"

#include <cmath>

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A floor at y = 0 and what stands over it.
struct Bench {
  Scene scene;
  explicit Bench(std::vector<Mesh> casters, Material caster = glass(1.5f)) {
    scene.materials = {diffuse(0.8f), std::move(caster)};
    scene.meshes = std::move(casters);
    scene.meshes.insert(scene.meshes.begin(), floor(10.0, 0.0, 0));
    scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
    scene.cameras = {camera_down(0.2, 1.0)};
  }
  std::vector<LightLanding> follow(const std::vector<LightRay>& rays, const Settings& settings = {},
                                   std::vector<LightLanding>* astray = nullptr) const {
    const Effects effects = effects_of(scene, settings);
    const RayTables tables(scene, effects, pilot().device);
    std::vector<LightLanding> landings;
    LightPaths(tables, effects, settings, pilot().registry).follow(rays, landings, 0.0, astray);
    return landings;
  }
  std::vector<LightLanding> follow(const glm::dvec3& from, const glm::dvec3& along,
                                   std::uint64_t key = 1) const {
    return follow({{.origin = from, .direction = along, .key = key}});
  }
  // Draws of so many rays, one as the other.
  std::vector<LightLanding> follow_many(const glm::dvec3& from, std::uint64_t count) const {
    std::vector<LightRay> rays;
    for (std::uint64_t key = 0; key < count; ++key)
      rays.push_back({.origin = from, .direction = {0, -1, 0}, .key = key});
    return follow(rays);
  }
};

double followed_flux(const std::vector<LightLanding>& landings, bool followed) {
  double sum = 0.0;
  for (const LightLanding& landing : landings)
    if (landing.followed == followed) sum += landing.flux.x;
  return sum;
}

}  // namespace

TEST_CASE(
    "light paths: straight through a slab goes what two surfaces let in, and some of what they mirror") {
  const Bench bench({box({-1, 0.5, -1}, {1, 0.8, 1}, 1)});
  const auto landings = bench.follow({0.3, 2.0, 0.2}, {0, -1, 0});
  // R = 0.04 at each surface: 0.96^2; then 0.96^2 R^2 after two more. What is left is drawn.
  CHECK(followed_flux(landings, true) == Approx(0.9216).epsilon(1e-6));
  for (const LightLanding& landing : landings) {
    CHECK(landing.position.x == Approx(0.3));
    CHECK(std::fabs(landing.position.y) < 1e-6);
  }
  const auto many = bench.follow_many({0.3, 2.0, 0.2}, 4000);
  // All orders together: (1 - R) / (1 + R). 4000 draws of what is left, 0.0384 R either way: +- 0.0001.
  const double all = (followed_flux(many, true) + followed_flux(many, false)) / 4000.0;
  CHECK(all == Approx(0.96 / 1.04).margin(4e-4));
}

TEST_CASE("light paths: what the first surface mirrors is followed where the passes follow it") {
  Bench bench({box({-1, 0.5, -1}, {1, 0.8, 1}, 1), floor(10.0, 3.0, 0)});
  Settings settings;
  for (const bool reflections : {false, true}) {
    settings.reflections = reflections;
    const auto landings = bench.follow({{.origin = {0.3, 2.0, 0.2}, .direction = {0, -1, 0}}}, settings);
    // Up to the ceiling: R = 0.04.
    CHECK(followed_flux(landings, true) == Approx(0.9216 + (reflections ? 0.04 : 0.0)).epsilon(1e-6));
  }
}

TEST_CASE("light paths: Snell's law bends the way through a slab, Beer and Lambert's takes its share") {
  Material tinted = glass(1.5f);
  tinted.attenuation_color = {0.5f, 1.0f, 1.0f};
  tinted.attenuation_distance = 0.4f;
  const Bench bench({box({-2, 0.5, -2}, {2, 0.8, 2}, 1)}, tinted);
  // 60 degrees from the vertical; inside sin t = sin 60 / 1.5.
  const double s = std::sqrt(0.75), inside = s / 1.5, cosine = std::sqrt(1.0 - inside * inside);
  const auto landings = bench.follow({-1.0, 0.8 + 0.5, 0.0}, {s, -0.5, 0.0});
  const auto straight =
      std::find_if(landings.begin(), landings.end(), [](const auto& landing) { return landing.followed; });
  REQUIRE(straight != landings.end());
  CHECK(straight->position.x == Approx(-1.0 + s + 0.3 * inside / cosine + 0.5 * s / 0.5).epsilon(1e-6));
  CHECK(straight->flux.x / straight->flux.y == Approx(std::pow(0.5, 0.3 / cosine / 0.4)).epsilon(1e-6));
}

TEST_CASE("light paths: total reflection is followed, as the passes do not") {
  // Vertical light onto a roof of 45 degrees upside down: a right-angled prism, hypotenuse up, sends it back
  // up; turned over its legs, it goes out at the side.
  Mesh prism;
  prism.material = 1;
  const glm::vec3 a(-0.5f, 1.0f, 0.0f), b(0.5f, 1.0f, 0.0f), c(0.5f, 0.0f, 0.0f), deep(0.0f, 0.0f, -1.0f),
      up(0.0f, 0.6f, 0.0f);
  const auto face = [&](const std::vector<glm::vec3>& points, const glm::vec3& normal) {
    const auto first = static_cast<std::uint32_t>(prism.vertices.size());
    for (const glm::vec3& p : points) prism.vertices.push_back({.position = p + up, .normal = normal});
    for (std::uint32_t k = 2; k < points.size(); ++k)
      prism.indices.insert(prism.indices.end(), {first, first + k - 1, first + k});
  };
  const float half = std::sqrt(0.5f);
  face({a, b, b + deep, a + deep}, {0, 1, 0});
  face({b, c, c + deep, b + deep}, {1, 0, 0});
  face({c, a, a + deep, c + deep}, {-half, -half, 0});
  face({a, c, b}, {0, 0, 1});
  face({a + deep, b + deep, c + deep}, {0, 0, -1});
  finish(prism, 1.0f);
  Bench bench({prism});
  bench.scene.meshes.push_back(box({2.0, 0.0, -1.0}, {2.1, 3.0, 1.0}, 0));
  const auto landings = bench.follow({0.2, 5.0, -0.5}, {0, -1, 0});
  // In at the top, off the slope at 45 degrees (beyond 41.8), out at the side, level: onto the wall.
  const auto turned = std::find_if(landings.begin(), landings.end(), [](const LightLanding& landing) {
    return std::fabs(landing.position.x - 2.0) < 1e-6;
  });
  REQUIRE(turned != landings.end());
  CHECK_FALSE(turned->followed);
  CHECK(turned->flux.x == Approx(0.9216).epsilon(1e-5));
  // The slope's height at x = 0.2.
  CHECK(turned->position.y == Approx(0.6 + 0.3).epsilon(1e-5));
}

TEST_CASE("light paths: a second body bends light that the passes send straight on") {
  const Bench bench({box({-1, 0.5, -1}, {1, 0.8, 1}, 1), box({-1, 1.0, -1}, {1, 1.3, 1}, 1)});
  const auto landings = bench.follow({0.3, 2.0, 0.2}, {0, -1, 0});
  CHECK(followed_flux(landings, true) == 0.0);
  CHECK(landings.front().flux.x > 0.0);
  // 0.96^4 go straight through both.
  double most = 0.0;
  for (const LightLanding& landing : landings) most = std::max(most, landing.flux.x);
  CHECK(most == Approx(0.84934656).epsilon(1e-6));
}

TEST_CASE("light paths: what would land if no other caster stood in its way goes astray") {
  const auto astray = [](const Bench& bench, double height) {
    std::vector<LightLanding> others;
    bench.follow({{.origin = {0.3, height, 0.2}, .direction = {0, -1, 0}}}, {}, &others);
    double sum = 0.0;
    for (const LightLanding& other : others) sum += other.flux.x;
    return sum;
  };
  const Mesh low = box({-1, 0.5, -1}, {1, 0.8, 1}, 1), high = box({-1, 1.0, -1}, {1, 1.3, 1}, 1);
  // 0.96^2 leaves the upper slab.
  CHECK(astray(Bench({low, high}), 2.0) == Approx(0.9216).epsilon(1e-6));
  CHECK(astray(Bench({low}), 2.0) == 0.0);
  // Off the lower box, all of it, to the upper one, which hides the ceiling; or where there is none.
  CHECK(astray(Bench({low, high, floor(10.0, 3.0, 0)}, metal(glm::vec3(1.0f))), 0.9) ==
        Approx(1.0).epsilon(1e-6));
  CHECK(astray(Bench({low, high}, metal(glm::vec3(1.0f))), 0.9) == 0.0);
  CHECK(astray(Bench({low, floor(10.0, 3.0, 0)}, metal(glm::vec3(1.0f))), 0.9) == 0.0);
}

TEST_CASE("light paths: a bubble's index is relative to the glass around it") {
  Bench bench({box({-1, 0.5, -1}, {1, 1.5, 1}, 1), box({-0.5, 0.9, -0.5}, {0.5, 1.1, 0.5}, 2)});
  bench.scene.materials.push_back(glass(1.0f / 1.5f));
  const auto landings = bench.follow({0.3, 2.0, 0.2}, {0, -1, 0});
  double most = 0.0;
  for (const LightLanding& landing : landings) most = std::max(most, landing.flux.x);
  // Glass to gas and back mirrors as much as air to glass.
  CHECK(most == Approx(0.84934656).epsilon(1e-6));
}

TEST_CASE(
    "light paths: of bodies that overlap the last that light entered counts, whichever it leaves first") {
  // Down through the first from 1.6 to 0.9 m and the second from 1.2 to 0.5 m, of indices 1.5 and 3: what
  // they mirror is 1/25 going in, (1.5 / 4.5)^2 = 1/9 from one to the other, nothing where the first is left
  // within the second, and 1/4 going out.
  Bench bench({box({-1, 0.9, -1}, {1, 1.6, 1}, 1), box({-1, 0.5, -1}, {1, 1.2, 1}, 2)});
  bench.scene.materials.push_back(glass(3.0f));
  double most = 0.0;
  for (const LightLanding& landing : bench.follow({0.3, 2.0, 0.2}, {0, -1, 0}))
    most = std::max(most, landing.flux.x);
  CHECK(most == Approx(24.0 / 25.0 * 8.0 / 9.0 * 3.0 / 4.0).epsilon(1e-6));
}

TEST_CASE("light paths: a body in two parts that overlap, within another of the same glass, bends nothing") {
  // One slab of glass from 1.9 to 0.5 m: Snell's law for sines of 0.6 outside and 0.4 inside. In the slab the
  // light enters the first part, then the second, and leaves them in the same order.
  Bench bench({box({-2, 0.5, -2}, {2, 1.9, 2}, 1), box({-2, 1.2, -2}, {2, 1.6, 2}, 2),
               box({-2, 0.9, -2}, {2, 1.4, 2}, 2)});
  bench.scene.materials.push_back(glass(1.5f));
  const double x = -0.8 + 0.6 * 0.75 + 1.4 * 0.4 / std::sqrt(1.0 - 0.16) + 0.5 * 0.75;
  int landed = 0;  // all but what the last surface mirrors, one way in 24
  for (std::uint64_t key = 0; key < 20; ++key)
    for (const LightLanding& landing : bench.follow({-0.8, 2.5, 0.1}, {0.6, -0.8, 0.0}, key))
      landed += std::fabs(landing.position.x - x) < 2e-6;
  CHECK(landed > 15);
}

TEST_CASE(
    "light paths: what meets no caster is not followed, and one ray's draws do not depend on another's") {
  const Bench bench({sphere({0.0, 1.0, 0.0}, 0.5, 3, 1)});
  CHECK(bench.follow({3.0, 2.0, 0.0}, {0, -1, 0}).empty());
  const auto once = bench.follow({0.3, 2.0, 0.1}, {0, -1, 0}, 7),
             again = bench.follow({0.3, 2.0, 0.1}, {0, -1, 0}, 7);
  REQUIRE(once.size() == again.size());
  REQUIRE(!once.empty());
  for (std::size_t i = 0; i < once.size(); ++i) CHECK(once[i].position == again[i].position);
}

TEST_CASE("light paths: the passes do not follow light to a thing within glass, nor what glass mirrors") {
  // A floor within the slab, 0.1 m under its top: 0.96 lands there by one surface, which the passes that know
  // two would carry on.
  Bench inside({box({-1, 0.5, -1}, {1, 0.8, 1}, 1)});
  inside.scene.meshes.push_back(floor(0.5, 0.7, 0));
  const auto landings = inside.follow({0.3, 2.0, 0.2}, {0, -1, 0});
  REQUIRE_FALSE(landings.empty());
  CHECK(landings.front().surfaces == 1);
  CHECK(followed_flux(landings, true) == 0.0);
  CHECK(followed_flux(landings, false) == Approx(0.96));
  // Mirrored by a slab at 45 degrees onto a wall.
  Bench mirrored({box({-1, 0.5, -1}, {1, 0.8, 1}, 1)});
  mirrored.scene.meshes.front() = floor(10.0, 5.0, 0);
  const auto off = mirrored.follow({0.0, 2.0, 0.0}, glm::normalize(glm::dvec3(0.6, -0.8, 0.0)));
  CHECK(followed_flux(off, true) == 0.0);
  CHECK(followed_flux(off, false) > 0.04);
}

TEST_CASE("light paths: KHR_materials_specular scales what a surface mirrors, but not total reflection") {
  Material clear = glass(1.5f);
  clear.fresnel_factor = 0.0f;
  const Bench bench({box({-1, 0.5, -1}, {1, 0.8, 1}, 1)}, clear);
  const auto landings = bench.follow({0.3, 2.0, 0.2}, {0, -1, 0});
  REQUIRE(landings.size() == 1);
  CHECK(landings.front().flux.x == 1.0);
}

TEST_CASE(
    "light paths: rough glass spreads light by its microfacets, half of them steeper than their width") {
  // An open sheet at 1 m: a facet of slope 0.25, 14.036 degrees, turns light by 4.732 degrees, 0.0828 on the
  // floor.
  Material rough = glass(1.5f);
  rough.roughness = 0.5f;
  const Bench bench({floor(1.0, 1.0, 1)}, rough);
  const auto landings = bench.follow_many({0.3, 2.0, 0.1}, 4000);
  int within = 0, through = 0;
  for (const LightLanding& landing : landings) {
    if (landing.surfaces != 1) continue;
    ++through;
    within += std::hypot(landing.position.x - 0.3, landing.position.z - 0.1) < 0.08278 ? 1 : 0;
  }
  REQUIRE(through > 3000);
  // +- 3 standard deviations of a draw.
  CHECK(static_cast<double>(within) / through == Approx(0.5).margin(0.025));
}

TEST_CASE("light paths: a picture tints what enters glass, and what passes holes has met none") {
  Material stained = glass(1.5f);
  stained.base_color_texture.image = 0;
  Bench bench({box({-1, 0.5, -1}, {1, 0.8, 1}, 1)}, stained);
  bench.scene.images = {Image(Format::RGBA32F, 1, 1)};
  bench.scene.images[0].values = {0.5f, 1.0f, 1.0f, 0.25f};
  CHECK(followed_flux(bench.follow({0.3, 2.0, 0.2}, {0, -1, 0}), true) == Approx(0.5 * 0.9216).epsilon(1e-6));
  bench.scene.materials[1].alpha_mode = AlphaMode::Mask;
  bench.scene.materials[1].alpha_cutoff = 0.5f;
  // Light that meets holes alone has met no caster.
  CHECK(bench.follow({0.3, 2.0, 0.2}, {0, -1, 0}).empty());
}
