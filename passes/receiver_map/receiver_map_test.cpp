#include "passes/receiver_map/receiver_map.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const Material kPlain{};

// The definition drawn with one quad facing up at this height, over a 2 m window from 10 m above.
PassImages draw(const glm::vec3 (&corners)[4], const View& view, const Material& material = kPlain,
                const Image& base_color = {}) {
  return run_pass(definition_of(receiver_map_pass()),
                  {.width = 4,
                   .height = 4,
                   .uniforms = uniform_bytes(receiver_map_uniforms(view, material)),
                   .textures = {base_color},
                   .mesh = quad(corners, {0.0f, 1.0f, 0.0f})});
}

const glm::vec3 kFloor[4] = {{-2, 2, 2}, {2, 2, 2}, {2, 2, -2}, {-2, 2, -2}};

}  // namespace

TEST_CASE("receiver_map: a floor fills the map with the positions of its texel centres") {
  // A window of 2 m in 4 texels: centres at -0.75, -0.25, 0.25, 0.75; right is +x, up is -z.
  const Image map = draw(kFloor, down(1.0, 10.0, 20.0))["receiver_position"];
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const glm::vec4 p = texel(map, x, y);
      CHECK(p.x == Approx(-0.75 + 0.5 * x));
      CHECK(p.y == Approx(2.0));
      CHECK(p.z == Approx(0.75 - 0.5 * y));
      CHECK(p.w == 1.0f);
    }
}

TEST_CASE("receiver_map: what nothing covers has w = 0") {
  const glm::vec3 left_half[4] = {{-2, 2, 2}, {0, 2, 2}, {0, 2, -2}, {-2, 2, -2}};
  const Image map = draw(left_half, down(1.0, 10.0, 20.0))["receiver_position"];
  CHECK(map.at(1, 0, 3) == 1.0f);
  CHECK(map.at(2, 0, 3) == 0.0f);
  CHECK(map.at(2, 0, 0) == 0.0f);
}

TEST_CASE(
    "receiver_map: what stands between the light and the casters is left out, what stands beside is not") {
  // Casters in the middle quarter, their top at height 1; the quad at height 2 covers everything.
  LightViews views;
  views.column = down(0.5, 10.0, 20.0);
  views.casters_nearest = 9.0;
  const View view = down(1.0, 10.0, 20.0);
  const Image map = run_pass(definition_of(receiver_map_pass()),
                             {.width = 4,
                              .height = 4,
                              .uniforms = uniform_bytes(receiver_map_uniforms(view, kPlain, &views)),
                              .textures = {Image{}},
                              .mesh = quad(kFloor, {0.0f, 1.0f, 0.0f})})["receiver_position"];
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const bool middle = (x == 1 || x == 2) && (y == 1 || y == 2);
      CHECK(map.at(x, y, 3) == (middle ? 0.0f : 1.0f));
    }
}

TEST_CASE("receiver_map: an alpha mask cuts holes") {
  // The texture's left half is transparent; the quad spans 4 m, the window its middle 2 m.
  Image base_color(Format::RGBA16F, 2, 1);
  base_color.at(1, 0, 3) = 1.0f;
  Material material;
  material.alpha_mode = AlphaMode::Mask;
  material.base_color_texture.image = 0;
  const Image map = draw(kFloor, down(1.0, 10.0, 20.0), material, base_color)["receiver_position"];
  CHECK(map.at(1, 2, 3) == 0.0f);
  CHECK(map.at(2, 2, 3) == 1.0f);
}

TEST_CASE("receiver_map: a point light's view sees positions in perspective") {
  // From 10 m above, the floor at height 2 is 8 m away: a window of tangent 0.5 spans +-4 m there.
  View view = down(0.5, 10.0, 20.0);
  view.perspective = true;
  view.near = 0.1;
  const glm::vec3 wide[4] = {{-9, 2, 9}, {9, 2, 9}, {9, 2, -9}, {-9, 2, -9}};
  const glm::vec4 p = texel(draw(wide, view)["receiver_position"], 3, 0);
  CHECK(p.x == Approx(3.0));
  CHECK(p.z == Approx(3.0));
}

TEST_CASE("receiver_map: sides whose outward normal faces the light, or faces away, can be left out") {
  const glm::vec3 under[4] = {{-2, 2, -2}, {2, 2, -2}, {2, 2, 2}, {-2, 2, 2}};
  const auto drawn = [](const glm::vec3(&corners)[4], int without_towards, int without_away) {
    std140::ReceiverMap u = receiver_map_uniforms(down(1.0, 10.0, 20.0), kPlain);
    u.without_towards = without_towards;
    u.without_away = without_away;
    return run_pass(definition_of(receiver_map_pass()),
                    {.width = 4,
                     .height = 4,
                     .uniforms = uniform_bytes(u),
                     .textures = {Image{}},
                     .mesh = quad(corners, {0.0f, 1.0f, 0.0f})})["receiver_position"]
               .at(1, 1, 3) == 1.0f;
  };
  CHECK(drawn(kFloor, 0, 1));
  CHECK_FALSE(drawn(kFloor, 1, 0));
  CHECK(drawn(under, 1, 0));
  CHECK_FALSE(drawn(under, 0, 1));
}
