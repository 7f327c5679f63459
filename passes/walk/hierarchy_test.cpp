#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A ray straight down from (1, 3, 2) meets level_triangle(height) at 3 - height metres, with the weights
// 2 / 4 and 1 / 4.
constexpr glm::vec3 kAbove{1.0f, 3.0f, 2.0f};

glm::vec4 hit(const HierarchyBench& bench, const AimedRay& ray, const SurfaceSearch& uniforms = kAllCasters) {
  return walk(bench.tables(), {ray}, uniforms).front();
}

HierarchyBench two_levels() {
  return HierarchyBench{}.caster(mesh_of({level_triangle(0.0f), level_triangle(1.0f)}));
}

// A floor at height 1 over glass, or glass under it: how much is for the test. Surfaces touch within 1/64 m.
constexpr float kTouch = 1.0f / 64.0f;
HierarchyBench floor_and_glass(float floor, float glass) {
  HierarchyBench bench;
  bench.touch = kTouch;
  return bench.caster(mesh_of({level_triangle(glass)})).receiver(mesh_of({level_triangle(floor)}));
}
glm::vec4 touching_hit(float floor, float glass, const AimedRay& ray) {
  return hit(floor_and_glass(floor, glass), ray, {.most_steps = 100, .first_receiver = 1, .touch = kTouch});
}

}  // namespace

TEST_CASE("hierarchy: a ray meets the nearer of two triangles, wherever it comes from") {
  CHECK(hit(two_levels(), {.start = kAbove}) == glm::vec4(0.5f, 0.25f, 2.0f, 2.0f));
  const AimedRay up{.start = {1.0f, -1.5f, 2.0f}, .direction = {0.0f, 1.0f, 0.0f}};
  CHECK(hit(two_levels(), up) == glm::vec4(0.5f, 0.25f, 1.5f, 1.0f));
  const AimedRay between{.start = {1.0f, 0.5f, 2.0f}, .direction = {0.0f, 1.0f, 0.0f}};
  CHECK(hit(two_levels(), between) == glm::vec4(0.5f, 0.25f, 0.5f, 2.0f));
}

TEST_CASE("hierarchy: a slanted ray's distance is along it") {
  // From (0, 4, 1) by (0.6, -0.8, 0): 5 m to the level 0, at (3, 0, 1).
  const glm::vec4 found = hit(HierarchyBench{}.caster(mesh_of({level_triangle(0.0f)})),
                              {.start = {0.0f, 4.0f, 0.25f}, .direction = {0.6f, -0.8f, 0.0f}});
  CHECK(found.w == 1.0f);
  CHECK(found.z == Approx(5.0).epsilon(1e-6));
  CHECK(found.x == Approx(0.25 / 4.0).epsilon(1e-5));
  CHECK(found.y == Approx(3.0 / 4.0).epsilon(1e-6));
}

TEST_CASE("hierarchy: the triangle that a ray starts on is left out, by its number alone") {
  // From a point that rounding has put 1/1024 m above the upper triangle; number 1 is marked 2.
  const glm::vec3 start{1.0f, 1.0f + 1.0f / 1024.0f, 2.0f};
  CHECK(hit(two_levels(), {.start = start}).w == 2.0f);
  CHECK(hit(two_levels(), {.start = start, .mark = 2.0f}) ==
        glm::vec4(0.5f, 0.25f, 1.0f + 1.0f / 1024.0f, 1.0f));
}

TEST_CASE("hierarchy: of triangles in one place the one with the smallest number is met") {
  // A dozen, in several leaves: with the first of them left out the second is the one.
  const HierarchyBench same =
      HierarchyBench{}.caster(mesh_of(std::vector<Corners>(12, level_triangle(1.0f))));
  CHECK(hit(same, {.start = kAbove}).w == 1.0f);
  CHECK(hit(same, {.start = kAbove, .mark = 1.0f}).w == 2.0f);
  CHECK(hit(same, {.start = kAbove, .mark = 7.0f}).w == 1.0f);
}

TEST_CASE("hierarchy: a ray along a shared edge meets one of both triangles, and none is lost") {
  // A square of 4 m, cut from (0, 0) to (4, 4).
  const HierarchyBench square = HierarchyBench{}.caster(
      mesh_of({{{{0, 1, 0}, {4, 1, 4}, {4, 1, 0}}}, {{{0, 1, 0}, {0, 1, 4}, {4, 1, 4}}}}));
  for (const float t : {0.5f, 1.0f, 1.3f, 2.0f, 2.7f, 3.5f})
    CHECK(hit(square, {.start = {t, 3.0f, t}}) == glm::vec4(t / 4.0f, 0.0f, 2.0f, 1.0f));
  CHECK(hit(square, {.start = {1.0f, 3.0f, 1.0f}, .mark = 1.0f}).w == 2.0f);
}

TEST_CASE("hierarchy: rays from anywhere through the middle of a fan and its spokes are not lost") {
  // A flat cone of 7 triangles whose corners are no round numbers.
  std::vector<Corners> fan;
  std::vector<glm::vec3> rim;
  for (int i = 0; i < 7; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / 7.0f;
    rim.push_back({1.3f * std::sin(angle), 0.1f, 1.3f * std::cos(angle)});
  }
  const glm::vec3 middle{0.0f, 0.37f, 0.0f};
  for (std::size_t i = 0; i < 7; ++i) fan.push_back({middle, rim[i], rim[(i + 1) % 7]});
  std::vector<AimedRay> rays;
  for (int i = 0; i < 50; ++i) {
    const float a = static_cast<float>(i);
    const glm::vec3 start{0.9f * std::sin(a), 2.0f + 0.03f * a, 0.9f * std::cos(1.7f * a)};
    rays.push_back({.start = start, .direction = glm::normalize(middle - start)});
    for (const float t : {0.25f, 0.5f, 0.7f})
      for (const glm::vec3& corner : rim)
        rays.push_back(
            {.start = start, .direction = glm::normalize(middle * (1.0f - t) + corner * t - start)});
  }
  // What a ray is put on by rounding lies in its box too, as in a frame: boxes are larger by 4e-6 m.
  HierarchyBench bench;
  bench.touch = 4e-6f;
  int lost = 0;
  for (const glm::vec4& found : walk(bench.caster(mesh_of(fan)).tables(), rays)) lost += found.w == 0.0f;
  CHECK(lost == 0);
}

TEST_CASE("hierarchy: light passes a blended surface") {
  HierarchyBench bench;
  bench.receiver(mesh_of({level_triangle(0.0f)})).sheet(mesh_of({level_triangle(1.0f)}));
  CHECK(hit(bench, {.start = kAbove}) == glm::vec4(0.5f, 0.25f, 3.0f, 1.0f));
}

TEST_CASE("hierarchy: glass that touches a floor is met before the floor") {
  // The floor lies 1/128 m above the glass, half as much as counts as touching: 2 - 1/128 m off, and counted
  // as 2 + 1/128. At 3/128 m it is counted as 2 - 3/128 + 1/64 and met first, where it is: 2 - 3/128 m off.
  CHECK(touching_hit(1.0f + 1.0f / 128.0f, 1.0f, {.start = kAbove}) == glm::vec4(0.5f, 0.25f, 2.0f, 1.0f));
  CHECK(touching_hit(1.0f + 3.0f / 128.0f, 1.0f, {.start = kAbove}) ==
        glm::vec4(0.5f, 0.25f, 2.0f - 3.0f / 128.0f, 2.0f));
}

TEST_CASE("hierarchy: light that starts a little behind a floor's front still meets it, not its back") {
  // From 1/128 m below: counted as -1/128 + 1/64, so it is met where the light starts. From 1/32 m below the
  // floor is behind the ray.
  const auto below = [](float metres, float way) {
    return AimedRay{.start = {1.0f, 1.0f - metres, 2.0f}, .direction = {0.0f, way, 0.0f}};
  };
  CHECK(touching_hit(1.0f, -9.0f, below(1.0f / 128.0f, -1.0f)) == glm::vec4(0.5f, 0.25f, 0.0f, 2.0f));
  CHECK(touching_hit(1.0f, -9.0f, below(1.0f / 32.0f, -1.0f)).w == 1.0f);
  // Upwards its back is met from 1/64 m on.
  CHECK(touching_hit(1.0f, -9.0f, below(1.0f / 128.0f, 1.0f)).w == 0.0f);
  CHECK(touching_hit(1.0f, -9.0f, below(1.0f / 32.0f, 1.0f)) == glm::vec4(0.5f, 0.25f, 1.0f / 32.0f, 2.0f));
}

namespace {

// A skin of body 1 that faces down and one of body 2 that faces up, so many metres above it: a ray straight
// down leaves body 1 and enters body 2. What is within 1/128 m of each other is in contact.
glm::vec4 contact_hit(float apart, const AimedRay& ray) {
  Corners down = level_triangle(1.0f);
  std::swap(down[1], down[2]);
  HierarchyBench bench;
  bench.touch = kTouch;
  bench.caster(mesh_of({down}), 0).caster(mesh_of({level_triangle(1.0f + apart)}), 1);
  return hit(bench, ray, {.most_steps = 100, .first_receiver = 2, .touch = kTouch});
}

constexpr glm::vec4 kInBody1{1.0f, 0.0f, 0.0f, 0.0f}, kInBoth{2.0f, 1.0f, 0.0f, 0.0f},
    kInBody2{2.0f, 0.0f, 0.0f, 0.0f}, kInNone{0.0f};

}  // namespace

TEST_CASE("hierarchy: where two bodies touch light enters the one before it leaves the other") {
  // Whichever lies 1/256 m before the other; at 1/64 m apart the nearer is met.
  for (const float apart : {0.0f, 1.0f / 256.0f, -1.0f / 256.0f, 1.0f / 64.0f})
    CHECK(contact_hit(apart, {.start = kAbove, .media = kInBody1}).w == 2.0f);
  const glm::vec4 leaves = contact_hit(-1.0f / 64.0f, {.start = kAbove, .media = kInBody1});
  CHECK(leaves.w == 1.0f);
  CHECK(leaves.z == 2.0f);  // where it is, not where it counts
}

TEST_CASE("hierarchy: from the surface that it has entered light leaves the one that it touches, once") {
  // The back lies 1/256 m before the start or behind it.
  for (const float apart : {1.0f / 256.0f, -1.0f / 256.0f}) {
    const glm::vec3 start{1.0f, 1.0f + apart, 2.0f};
    const glm::vec4 back = contact_hit(apart, {.start = start, .mark = 2.0f, .media = kInBoth});
    CHECK(back.w == 1.0f);
    CHECK(back.z == std::max(apart, 0.0f));
    const AimedRay left{.start = {1.0f, 1.0f, 2.0f}, .mark = 1.0f, .media = kInBody2};
    CHECK(contact_hit(apart, left).w == 0.0f);
  }
}

TEST_CASE("hierarchy: light that is mirrored where two bodies touch crosses nothing there") {
  // In body 1, mirrored by the skin of body 2; and back in body 2, mirrored by the skin of body 1.
  const glm::vec3 up{0.0f, 1.0f, 0.0f}, start{1.0f, 1.0f, 2.0f};
  for (const float apart : {0.0f, 1.0f / 256.0f, -1.0f / 256.0f}) {
    CHECK(contact_hit(apart, {start + apart * up, up, 2.0f, kInBody1}).w == 0.0f);
    CHECK(contact_hit(apart, {start, -up, 1.0f, kInBody2}).w == 0.0f);
  }
}

TEST_CASE("hierarchy: a plate thinner than a contact is entered and left, once each") {
  // Both skins of body 1, 1/256 m apart, the upper one number 0.
  Corners down = level_triangle(1.0f);
  std::swap(down[1], down[2]);
  HierarchyBench plate;
  plate.touch = kTouch;
  plate.caster(mesh_of({level_triangle(1.0f + 1.0f / 256.0f), down}));
  const SurfaceSearch frame{.most_steps = 100, .first_receiver = 2, .touch = kTouch};
  const glm::vec3 upper{1.0f, 1.0f + 1.0f / 256.0f, 2.0f}, lower{1.0f, 1.0f, 2.0f};
  CHECK(hit(plate, {.start = kAbove, .media = kInNone}, frame).w == 1.0f);
  CHECK(hit(plate, {.start = upper, .mark = 1.0f, .media = kInBody1}, frame).w == 2.0f);
  CHECK(hit(plate, {.start = lower, .mark = 2.0f, .media = kInNone}, frame).w == 0.0f);
}

TEST_CASE("hierarchy: light that leaves by an edge leaves by one of its triangles") {
  // A square of 4 m that faces down, cut from (0, 0) to (4, 4); both halves lie under the ray.
  HierarchyBench square;
  square.touch = kTouch;
  square.caster(mesh_of({{{{0, 1, 0}, {4, 1, 0}, {4, 1, 4}}}, {{{0, 1, 0}, {4, 1, 4}, {0, 1, 4}}}}));
  const SurfaceSearch frame{.most_steps = 100, .first_receiver = 2, .touch = kTouch};
  CHECK(hit(square, {.start = {1.0f, 3.0f, 1.0f}, .media = kInBody1}, frame).w == 1.0f);
  CHECK(hit(square, {.start = {1.0f, 1.0f, 1.0f}, .mark = 1.0f, .media = kInNone}, frame).w == 0.0f);
}

TEST_CASE("hierarchy: what meets nothing, or is not under way, has zeros") {
  CHECK(hit(two_levels(), {.start = {3.0f, 3.0f, 3.0f}}) == glm::vec4(0.0f));
  CHECK(hit(two_levels(), {.start = kAbove, .direction = {0.0f, 1.0f, 0.0f}}) == glm::vec4(0.0f));
  CHECK(hit(two_levels(), {.start = kAbove, .mark = 0.0f}) == glm::vec4(0.0f));
  CHECK(hit(two_levels(), {.start = kAbove, .mark = kEnded}) == glm::vec4(0.0f));
  CHECK(hit(HierarchyBench{}, {.start = kAbove}) == glm::vec4(0.0f));
}

TEST_CASE("hierarchy: a ray along a triangle's plane does not meet it") {
  CHECK(hit(two_levels(), {.start = {-1.0f, 1.0f, 1.0f}, .direction = {1.0f, 0.0f, 0.0f}}).w == 0.0f);
}

TEST_CASE("hierarchy: a walk of more steps than it may take is given up") {
  // The root, then its one leaf's two triangles: three steps.
  const auto after = [](int steps, const AimedRay& ray) {
    return hit(two_levels(), ray, {.most_steps = steps, .first_receiver = 9, .touch = 0.0f}).w;
  };
  CHECK(after(1, {.start = kAbove}) == HIT_GIVEN_UP);
  CHECK(after(2, {.start = kAbove}) == HIT_GIVEN_UP);
  CHECK(after(3, {.start = kAbove}) == 2.0f);
  // Past the root's box one step tells.
  CHECK(after(1, {.start = {9.0f, 3.0f, 9.0f}}) == 0.0f);
}
