#include "passes/ambient_rays/ambient_rays.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr float kFar = 1e3f;  // metres: what is near counts in full

// Pixels a millimetre apart around a place on a level floor, so that 4 x 4 texels have all 128 directions.
PassImages rays_of(const HierarchyBench& bench, const glm::vec3& place, float reach,
                   const std::vector<BenchMaterial>& materials, float up = 1.0f) {
  constexpr int kPixels = 16;
  Image positions(Format::RGBA32F, kPixels, kPixels);
  for (int y = 0; y < kPixels; ++y)
    for (int x = 0; x < kPixels; ++x) {
      const glm::vec4 at(
          place + glm::vec3(1e-3f * static_cast<float>(x), 0.0f, -1e-3f * static_cast<float>(y)), 1.0f);
      for (int c = 0; c < 4; ++c) positions.at(x, y, c) = at[c];
    }
  const HierarchyTables tables = bench.tables();
  const std140::AmbientRays uniforms{
      .most_steps = 1024, .first_receiver = bench.first_receiver(), .touch = 0.0f, .reach = reach};
  return run_pass(
      definition_of(ambient_rays_pass()),
      {.width = 4,
       .height = 4,
       .uniforms = uniform_bytes(uniforms),
       .textures = {positions, filled(kPixels, kPixels, {0.0f, up, 0.0f, 1.0f}), caster_materials(materials),
                    tables.nodes, tables.triangles, tables.normals}});
}

// The mean share of the rays that are open, of all directions.
double open_at(const HierarchyBench& bench, const glm::vec3& place = glm::vec3(0.0f), float reach = kFar,
               const std::vector<BenchMaterial>& materials = {{}}) {
  const PassImages out = rays_of(bench, place, reach, materials);
  return sum(out["ambient_rays"], 3) / 16.0 - 1.0;
}

Mesh rectangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
  return mesh_of({{{a, b, c}}, {{a, c, d}}});
}
// Level, faces up or down.
Mesh level_square(float height, float half, bool up = true) {
  const glm::vec3 a(-half, height, half), b(half, height, half), c(half, height, -half),
      d(-half, height, -half);
  return up ? rectangle(a, b, c, d) : rectangle(a, d, c, b);
}

// Of 1 m radius, level.
Mesh disc(float height) {
  std::vector<Corners> triangles;
  for (int i = 0; i < 96; ++i) {
    const auto rim = [&](int k) {
      const float angle = 6.28318531f * static_cast<float>(k) / 96.0f;
      return glm::vec3(std::cos(angle), height, std::sin(angle));
    };
    triangles.push_back({{{0.0f, height, 0.0f}, rim(i), rim(i + 1)}});
  }
  return mesh_of(triangles);
}

}  // namespace

TEST_CASE("ambient_rays: a plane keeps nothing from itself") {
  CHECK(open_at(HierarchyBench{}.receiver(level_square(0.0f, 100.0f))) == 1.0);
}

TEST_CASE("ambient_rays: at the foot of an endless wall half of the light arrives, whatever the reach") {
  const HierarchyBench wall = HierarchyBench{}.receiver(
      rectangle({-1e-4f, -1e5f, -1e5f}, {-1e-4f, -1e5f, 1e5f}, {-1e-4f, 1e5f, 1e5f}, {-1e-4f, 1e5f, -1e5f}));
  // Of 128 directions a few more lie on one side of a line.
  CHECK(open_at(wall, glm::vec3(0.0f)) == Approx(0.5).margin(1.0 / 32));
  CHECK(open_at(wall, glm::vec3(0.0f), 10.0f) == Approx(0.5).margin(1.0 / 32));
}

TEST_CASE("ambient_rays: below a disc the sky is open beyond the cone that it fills") {
  // 1 m over the point, 45 degrees wide on each side: sin^2 of that is kept, 1/2. At 0.5 m: 1 / 1.25 = 0.8.
  CHECK(open_at(HierarchyBench{}.receiver(disc(1.0f))) == Approx(0.5).margin(1.0 / 128));
  CHECK(open_at(HierarchyBench{}.receiver(disc(0.5f))) == Approx(0.2).margin(1.0 / 128));
}

TEST_CASE("ambient_rays: what lies below a surface that faces down keeps half as much") {
  const HierarchyBench below = HierarchyBench{}.receiver(disc(-1.0f));
  const PassImages out = rays_of(below, glm::vec3(0.0f), kFar, {{}}, -1.0f);
  CHECK(sum(out["ambient_rays"], 3) / 16.0 - 1.0 == Approx(0.75).margin(1.0 / 128));
}

TEST_CASE("ambient_rays: what is farther keeps less, and from the reach on nothing") {
  // 1 - (d / R)^2 with d = h / cos t over the cone of 45 degrees: the integral of 2 sin t cos t (1 - (h /
  // R)^2 / cos^2 t) is sin^2 t + 2 (h / R)^2 ln cos t. With h = 1, R = 2: 1/2 + 0.5 ln 0.70711 = 0.32671.
  CHECK(open_at(HierarchyBench{}.receiver(disc(1.0f)), glm::vec3(0.0f), 2.0f) ==
        Approx(1.0 - 0.32671).margin(1.0 / 128));
  CHECK(open_at(HierarchyBench{}.receiver(disc(1.0f)), glm::vec3(0.0f), 1.0f) == 1.0);
}

TEST_CASE("ambient_rays: clear glass keeps what its surfaces mirror, coloured glass what it absorbs too") {
  const auto pane =
      HierarchyBench{}.caster(mesh_of({{{{-1e3f, 1.0f, -1e3f}, {1e3f, 1.0f, -1e3f}, {0.0f, 1.0f, 1e3f}}},
                                       {{{-1e3f, 2.0f, -1e3f}, {0.0f, 2.0f, 1e3f}, {1e3f, 2.0f, -1e3f}}}}));
  // 2.3 * 0.2^2 at each of two surfaces: 0.908^2.
  CHECK(open_at(pane) == Approx(0.824464).epsilon(2e-3));
  CHECK(open_at(pane, glm::vec3(0.0f), kFar, {{.ior = 1.0f}}) == Approx(1.0).epsilon(2e-3));
  CHECK(open_at(pane, glm::vec3(0.0f), kFar, {{.ior = 1.0f, .color = glm::vec3(0.25f)}}) ==
        Approx(0.25).epsilon(2e-3));
  // So much that nothing is left.
  CHECK(open_at(pane, glm::vec3(0.0f), kFar, {{.ior = 1.0f, .absorption = glm::vec3(50.0f)}}) < 2e-3);
  CHECK(open_at(pane, glm::vec3(0.0f), kFar, {{.mirror = true}}) < 2e-3);
}

TEST_CASE("ambient_rays: where there is no surface nothing is written") {
  const HierarchyTables tables = HierarchyBench{}.receiver(disc(1.0f)).tables();
  const Image none = filled(4, 4, glm::vec4(0.0f));
  const PassImages out = run_pass(
      definition_of(ambient_rays_pass()),
      {.width = 1,
       .height = 1,
       .uniforms = uniform_bytes(
           std140::AmbientRays{.most_steps = 9, .first_receiver = 0, .touch = 0.0f, .reach = 1.0f}),
       .textures = {none, none, caster_materials({{}}), tables.nodes, tables.triangles, tables.normals}});
  CHECK(texel(out["ambient_rays"], 0, 0) == glm::vec4(0.0f));
}
