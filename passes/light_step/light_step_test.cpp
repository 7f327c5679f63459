#include "passes/light_step/light_step.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Image rays(const std::vector<glm::vec4>& texels) {
  Image image(Format::RGBA32F, 1, 4);
  for (int block = 0; block < 4; ++block)
    for (int c = 0; c < 4; ++c) image.at(0, block, c) = texels[static_cast<std::size_t>(block)][c];
  return image;
}

// A slab of glass between the heights 0 and 1, over a floor at -1: body 1, index 1.5. Numbers plus 1: the
// slab's upper triangle 1, its lower 2, the floor's 3.
struct Bench {
  BenchMaterial material{};
  float rough_from = 1.0f;  // its roughness is 0.5
  glm::vec2 facet{0.0f};

  PassImages step(const glm::vec4& start, const glm::vec3& direction, const glm::vec4& media = {}) const {
    Corners under = level_triangle(0.0f, -1.0f, -1.0f);
    std::swap(under[1], under[2]);
    HierarchyBench bench;
    bench.caster(mesh_of({level_triangle(1.0f, -1.0f, -1.0f), under}));
    bench.receiver(mesh_of({level_triangle(-1.0f, -1.0f, -1.0f)}));
    const HierarchyTables tables = bench.tables();
    std140::LightStep u{};
    u.most_steps = 64;
    u.first_receiver = bench.first_receiver();
    u.has_rough = rough_from < 1.0f ? 1 : 0;
    u.rough_from = rough_from;
    Image materials = caster_materials({material});
    materials.at(2, 0, 3) = 0.5f;
    return run_pass(definition_of(light_step_pass()),
                    {.uniforms = uniform_bytes(u),
                     .textures = {rays({start, {direction, 1.0f}, media, {facet, 0.0f, 0.0f}}), materials,
                                  tables.nodes, tables.triangles, tables.normals, Image{}}});
  }
};

void check_near(const Image& image, const glm::vec4& expected) {
  for (int c = 0; c < 4; ++c)
    CHECK(static_cast<double>(image.at(0, 0, c)) == Approx(static_cast<double>(expected[c])).margin(1e-6));
}

constexpr glm::vec3 kDown{0.0f, -1.0f, 0.0f};

}  // namespace

TEST_CASE("light step: at a slab's upper side a part goes back, and what crosses is in the body") {
  const PassImages out = Bench{}.step({0.5f, 3.0f, 0.25f, 0.0f}, kDown);
  check_near(out["met"], {0.5f, 1.0f, 0.25f, 1.0f});
  check_near(out["left"], {1.0f, 1.0f, 1.0f, 1.0f});
  check_near(out["mirrored_way"], {0.0f, 1.0f, 0.0f, 0.04f});
  check_near(out["mirrored_light"], {1.0f, 1.0f, 1.0f, 0.0f});
  check_near(out["crossing_way"], {0.0f, -1.0f, 0.0f, 0.0f});
  check_near(out["crossing_light"], {1.0f, 1.0f, 1.0f, 0.0f});
  check_near(out["crossing_media"], {1.0f, 0.0f, 0.0f, 0.0f});
}

TEST_CASE("light step: within the slab its glass absorbs, and beyond 41.8 degrees all light goes back") {
  Bench bench;
  bench.material.absorption = {0.0f, 0.5f, 1.0f};
  const PassImages out = bench.step({0.0f, 1.0f, 0.0f, 1.0f}, {0.8f, -0.6f, 0.0f}, {1.0f, 0.0f, 0.0f, 0.0f});
  check_near(out["met"], {0.8f / 0.6f, 0.0f, 0.0f, 2.0f});
  // exp(-a / 0.6).
  check_near(out["left"], {1.0f, 0.43459821f, 0.18887560f, 0.0f});
  check_near(out["mirrored_way"], {0.8f, 0.6f, 0.0f, 1.0f});
}

TEST_CASE("light step: metal has one way, in its color") {
  Bench bench;
  bench.material.mirror = true;
  bench.material.color = {1.0f, 0.5f, 0.25f};
  const PassImages out = bench.step({0.0f, 3.0f, 0.0f, 0.0f}, kDown);
  check_near(out["mirrored_way"], {0.0f, 1.0f, 0.0f, 1.0f});
  check_near(out["mirrored_light"], {1.0f, 0.5f, 0.25f, 0.0f});
}

TEST_CASE("light step: a receiver is met as it is, and beside everything nothing is met") {
  check_near(Bench{}.step({0.0f, 0.0f, 0.0f, 2.0f}, kDown)["met"], {0.0f, -1.0f, 0.0f, 3.0f});
  CHECK(Bench{}.step({0.0f, 3.0f, 0.0f, 0.0f}, -kDown)["met"].at(0, 0, 3) == 0.0f);
}

TEST_CASE("light step: rough glass bends light at the facet that is drawn") {
  Bench bench;
  bench.rough_from = 0.2f;
  // Half of the facets are steeper than their width, 0.25: 14.036 degrees, and 9.305 inside.
  bench.facet = {0.5f, 0.25f};
  const PassImages out = bench.step({0.0f, 3.0f, 0.0f, 0.0f}, kDown);
  const Image& way = out["crossing_way"];
  CHECK(std::hypot(static_cast<double>(way.at(0, 0, 0)), static_cast<double>(way.at(0, 0, 2))) ==
        Approx(0.08249).margin(1e-4));
  // Smith's masking takes some of what is sent.
  CHECK(out["crossing_light"].at(0, 0, 0) < 1.0f);
  CHECK(out["crossing_light"].at(0, 0, 0) > 0.9f);
}
