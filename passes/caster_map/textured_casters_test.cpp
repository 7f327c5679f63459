#include "passes/shared/textured_casters.hpp"

#include <cmath>

#include "passes/caster_exit_map/caster_exit_map.hpp"
#include "passes/caster_map/caster_map.hpp"
#include "tests/support/caster_bench.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// The level square of caster_bench.hpp, which covers the middle 4 x 4 of 8 x 8 texels. Its texture
// coordinates run from 0 to 1 along +x and -z, its tangent is +x, so the bitangent is -z. Bound are base
// colour, normal texture and transmission texture; the material uses those that are there.
struct Bench {
  Material material = glass(1.5f);
  SurfaceRole role{.role = Role::Refractor};
  Image base_color{}, normals{}, transmission{};
  glm::vec3 normal{0.0f, 1.0f, 0.0f};
  bool from_behind = false;

  PassImages run(const PassDefinition& definition) const {
    Material m = material;
    m.base_color_texture.image = base_color.values.empty() ? -1 : 0;
    m.normal_texture.image = normals.values.empty() ? -1 : 1;
    m.transmission_texture.image = transmission.values.empty() ? -1 : 2;
    std::vector<Image> bound = {base_color, normals, transmission};
    bound.resize(definition.reads.size());
    return run_pass(definition,
                    {.width = 8,
                     .height = 8,
                     .uniforms = uniform_bytes(textured_casters_uniforms(down(1.0, 4.0, 8.0), m, role, 3)),
                     .textures = bound,
                     .mesh = from_behind ? quad(kBack, normal) : quad(kFront, normal)});
  }
};

PassDefinition detailed_casters() {
  return definition_with(caster_map_pass(), &Effects::normal_mapped_casters);
}
PassDefinition tinted_casters() { return definition_with(caster_map_pass(), &Effects::textured_casters); }
PassDefinition detailed_exits_map() {
  return definition_with(caster_exit_map_pass(), &Effects::cut_out_casters);
}

Image two_by_two(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c, const glm::vec4& d) {
  Image image(Format::RGBA32F, 2, 2);
  for (int i = 0; i < 4; ++i) {
    image.at(0, 0, i) = a[i];
    image.at(1, 0, i) = b[i];
    image.at(0, 1, i) = c[i];
    image.at(1, 1, i) = d[i];
  }
  return image;
}

void check_direction(const glm::vec4& found, glm::vec3 expected) {
  expected /= std::sqrt(expected.x * expected.x + expected.y * expected.y + expected.z * expected.z);
  CHECK(found.x == Approx(expected.x).margin(1e-6));
  CHECK(found.y == Approx(expected.y).margin(1e-6));
  CHECK(found.z == Approx(expected.z).margin(1e-6));
}

}  // namespace

TEST_CASE("textured_casters: without textures all is as the plain passes draw it, bit for bit") {
  Bench bench;
  bench.normal = {0.3f, 2.0f, -0.4f};
  const UniformBytes plain = uniform_bytes(caster_map_uniforms(down(1.0, 4.0, 8.0), 3));
  for (const bool behind : {false, true}) {
    bench.from_behind = behind;
    const MeshData mesh = behind ? quad(kBack, bench.normal) : quad(kFront, bench.normal);
    const auto expected = [&](const Pass& pass) {
      return run_pass(definition_of(pass), {.width = 8, .height = 8, .uniforms = plain, .mesh = mesh});
    };
    const PassImages casters = expected(caster_map_pass()), exits = expected(caster_exit_map_pass());
    for (const PassDefinition& pass : {detailed_casters(), tinted_casters()}) {
      const PassImages out = bench.run(pass);
      CHECK(out["caster_position"].values == casters["caster_position"].values);
      CHECK(out["caster_normal"].values == casters["caster_normal"].values);
      CHECK(out["caster_depth"].values == casters["caster_depth"].values);
      CHECK(out.result.samples_passed == 16);
    }
    const PassImages out = bench.run(detailed_exits_map());
    CHECK(out["caster_exit_position"].values == exits["caster_exit_position"].values);
    CHECK(out["caster_exit_normal"].values == exits["caster_exit_normal"].values);
  }
}

TEST_CASE("textured_casters: a 2 x 2 normal texture leans the normals, interpolated between its texels") {
  // Left texels (1, ., 1) lean towards +x, right ones (-1, ., 1) back; the upper row leans 1 towards -z as
  // well. The first covered texel's centre lies at u = v = 0.125, a quarter of a texel left of and below the
  // first texel's centre: 0.75 of it and 0.25 of the one before it, which is the last. So x = 0.75 - 0.25, y
  // = 0.25 * 1.
  Bench bench;
  bench.normals = two_by_two({1.0f, 0.5f, 1.0f, 1.0f}, {0.0f, 0.5f, 1.0f, 1.0f}, {1.0f, 1.0f, 1.0f, 1.0f},
                             {0.0f, 1.0f, 1.0f, 1.0f});
  for (const PassDefinition& pass : {detailed_casters(), tinted_casters()}) {
    const Image out = bench.run(pass)["caster_normal"];
    check_direction(texel(out, 2, 2), {0.5f, 1.0f, -0.25f});
    check_direction(texel(out, 5, 2), {-0.5f, 1.0f, -0.25f});
    check_direction(texel(out, 3, 4), {0.5f, 1.0f, -0.75f});
    CHECK(out.at(2, 2, 3) == 3.0f);
  }
  // Clamped, the first texel alone: along u, and then along v.
  bench.material.normal_texture.wrap_u = Wrap::Clamp;
  check_direction(texel(bench.run(detailed_casters())["caster_normal"], 2, 2), {1.0f, 1.0f, -0.25f});
  bench.material.normal_texture.wrap_v = Wrap::Clamp;
  check_direction(texel(bench.run(detailed_casters())["caster_normal"], 2, 2), {1.0f, 1.0f, 0.0f});
  bench.material.normal_texture.wrap_u = bench.material.normal_texture.wrap_v = Wrap::Repeat;
  // Half the scale, half the lean.
  bench.material.normal_scale = 0.5f;
  check_direction(texel(bench.run(detailed_casters())["caster_normal"], 2, 2), {0.25f, 1.0f, -0.125f});
}

TEST_CASE("textured_casters: KHR_texture_transform moves the normal texture") {
  // Twice as often along u, and moved by half a texel: u' = 2 u + 0.25 is 0.5 at the first centre, between
  // both.
  Bench bench;
  bench.normals = two_by_two({1.0f, 0.5f, 1.0f, 1.0f}, {0.0f, 0.5f, 1.0f, 1.0f}, {1.0f, 0.5f, 1.0f, 1.0f},
                             {0.0f, 0.5f, 1.0f, 1.0f});
  bench.material.normal_texture.uv_transform[0][0] = 2.0f;
  bench.material.normal_texture.uv_transform[2][0] = 0.25f;
  const Image out = bench.run(detailed_casters())["caster_normal"];
  check_direction(texel(out, 2, 2), {0.0f, 1.0f, 0.0f});
  // u = 0.375 becomes 1.0: between the last texel and the first.
  check_direction(texel(out, 3, 2), {0.0f, 1.0f, 0.0f});
}

TEST_CASE("textured_casters: normals have length 1 and stay in the hemisphere of the smooth normal") {
  // Texels that point sideways, or into the surface, as damaged textures have them.
  Bench bench;
  bench.material.normal_scale = 30.0f;
  bench.normals = two_by_two({1.0f, 0.5f, 0.0f, 1.0f}, {0.0f, 0.1f, 0.25f, 1.0f}, {0.5f, 0.5f, 0.0f, 1.0f},
                             {0.9f, 0.9f, 0.9f, 1.0f});
  const Image out = bench.run(detailed_casters())["caster_normal"];
  for (int y = 2; y < 6; ++y)
    for (int x = 2; x < 6; ++x) {
      const glm::vec3 n(texel(out, x, y));
      CHECK(glm::length(n) == Approx(1.0f).epsilon(1e-6));
      CHECK(n.y > 0.0f);
    }
}

TEST_CASE("textured_casters: seen from behind, the normal is still the outward one") {
  // The back's texture coordinates run along +x and +z; tangent and handedness are as before.
  Bench bench;
  bench.from_behind = true;
  bench.normals = filled(1, 1, {1.0f, 0.5f, 1.0f, 1.0f});
  const PassImages out = bench.run(detailed_casters());
  check_direction(texel(out["caster_normal"], 3, 3), {1.0f, 1.0f, 0.0f});
  CHECK(out["caster_position"].at(3, 3, 3) == -3.0f);
  const PassImages exit = bench.run(detailed_exits_map());
  check_direction(texel(exit["caster_exit_normal"], 3, 3), {1.0f, 1.0f, 0.0f});
  CHECK(exit["caster_exit_normal"].at(3, 3, 3) == 1.0f);
}

TEST_CASE("textured_casters: glass is tinted by factor, texture and transmission texture, texel by texel") {
  // Centres at u = 0.125 and 0.375 take 0.75 of the left texel and 0.25 of the right one.
  Bench bench;
  bench.material.base_color = {0.5f, 1.0f, 1.0f, 1.0f};
  bench.base_color = two_by_two({1.0f, 1.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 1.0f, 1.0f}, {1.0f, 1.0f, 0.0f, 1.0f},
                                {0.0f, 1.0f, 1.0f, 1.0f});
  const Image out = bench.run(tinted_casters())["caster_tint"];
  CHECK(texel(out, 3, 3) == glm::vec4(0.375f, 1.0f, 0.25f, 1.0f));
  CHECK(texel(out, 4, 3) == glm::vec4(0.125f, 1.0f, 0.75f, 1.0f));
  CHECK(texel(out, 1, 3) == glm::vec4(0.0f));
  bench.transmission = filled(1, 1, {0.5f, 0.0f, 0.0f, 1.0f});
  CHECK(texel(bench.run(tinted_casters())["caster_tint"], 3, 3) == glm::vec4(0.1875f, 0.5f, 0.125f, 1.0f));
}

TEST_CASE("textured_casters: a mirror's reflectance is its dielectric share and the texture's metal share") {
  // 0.04 (1 - 0.75) + 0.75 * 0.8 * texel; a transmission texture means nothing to metal.
  Bench bench;
  bench.role.role = Role::Mirror;
  bench.material = metal({0.8f, 0.8f, 0.8f});
  bench.material.metallic = 0.75f;
  bench.base_color = filled(1, 1, {1.0f, 0.5f, 0.0f, 1.0f});
  bench.transmission = filled(1, 1, glm::vec4(0.0f));
  const glm::vec4 tint = texel(bench.run(tinted_casters())["caster_tint"], 3, 3);
  CHECK(tint.x == Approx(0.61));
  CHECK(tint.y == Approx(0.31));
  CHECK(tint.z == Approx(0.01));
}

TEST_CASE("textured_casters: an alpha mask cuts holes, on both sides of a caster") {
  // The left half is transparent, to the nearest texel: two of four columns stay.
  Bench bench;
  bench.material.alpha_mode = AlphaMode::Mask;
  bench.base_color = two_by_two(glm::vec4(0.0f), glm::vec4(1.0f), glm::vec4(0.0f), glm::vec4(1.0f));
  for (const PassDefinition& pass : {detailed_casters(), tinted_casters()}) {
    const PassImages out = bench.run(pass);
    CHECK(out.result.samples_passed == 8);
    CHECK(out["caster_position"].at(3, 3, 3) == 0.0f);
    CHECK(out["caster_position"].at(4, 3, 3) == 2.0f);
  }
  bench.from_behind = true;
  const PassImages exit = bench.run(detailed_exits_map());
  CHECK(exit["caster_exit_position"].at(3, 3, 3) == 0.0f);
  CHECK(exit["caster_exit_position"].at(4, 3, 3) == 1.0f);
  bench.material.alpha_mode = AlphaMode::Opaque;
  CHECK(bench.run(detailed_exits_map())["caster_exit_position"].at(3, 3, 3) == 1.0f);
  bench.material.alpha_mode = AlphaMode::Mask;  // as opaque as the cutoff stays
  bench.base_color = filled(1, 1, glm::vec4(bench.material.alpha_cutoff));
  CHECK(bench.run(detailed_exits_map())["caster_exit_position"].at(3, 3, 3) == 1.0f);
}
