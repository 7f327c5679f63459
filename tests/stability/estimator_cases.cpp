// Receivers on which searches oscillate, jump or find nothing.
#include <cmath>

#include "tests/stability/hard_case.hpp"
#include "tests/support/catch.hpp"

namespace caustics::test {

namespace {

// The square y = x tan(slope) over +-half metres along its slant.
Mesh ramp(double slope, double half) {
  Mesh mesh = floor(half, 0.0, 0);
  const float c = static_cast<float>(std::cos(slope)), s = static_cast<float>(std::sin(slope));
  for (Vertex& v : mesh.vertices) {
    v.position = {v.position.x * c, v.position.x * s, v.position.z};
    v.normal = {-s, c, 0.0f};
  }
  finish(mesh, 0.0f);
  return mesh;
}

// Steps up along x, each `run` wide and `rise` high, walls included.
Mesh stairs(int steps, float run, float rise) {
  Mesh mesh;
  mesh.name = "stairs";
  const float half = 1.5f;
  const auto quad = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& normal) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::vec3& p : {glm::vec3(a.x, a.y, half), glm::vec3(b.x, b.y, half),
                               glm::vec3(b.x, b.y, -half), glm::vec3(a.x, a.y, -half)})
      mesh.vertices.push_back({.position = p, .normal = normal});
    for (const std::uint32_t v : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + v);
  };
  const float start = -0.5f * run * static_cast<float>(steps);
  for (int i = 0; i < steps; ++i) {
    const float x = start + run * static_cast<float>(i), y = rise * static_cast<float>(i);
    quad({x, y, 0.0f}, {x + run, y, 0.0f}, {0.0f, 1.0f, 0.0f});
    if (i + 1 < steps) quad({x + run, y, 0.0f}, {x + run, y + rise, 0.0f}, {-1.0f, 0.0f, 0.0f});
  }
  finish(mesh, 0.0f);
  return mesh;
}

HardCase steep_case(Estimator estimator, double degrees) {
  char text[96];
  std::snprintf(text, sizeof text, "a ramp of %g degrees, %s", degrees,
                std::string(name_of(estimator)).c_str());
  HardCase c{text,
             estimator == Estimator::Paper ? "diverges: booked as not converged, never drawn off the ramp"
                                           : "what is drawn lies on the ramp; the rest is booked",
             sphere_scene(1.5f, 4)};
  const double slope = degrees * 3.14159265358979323846 / 180.0;
  c.scene.meshes[0] = ramp(slope, 6.0);
  for (Vertex& v : c.scene.meshes[1].vertices) v.position += glm::vec3(-0.6f, 0.4f, 0.0f);
  finish(c.scene.meshes[1], 1.0f);
  c.scene.cameras = {camera_down(8.0, 1.0)};
  c.settings.estimator = estimator;
  c.expect = [=](const DrawnCase& drawn) {
    const Image& landing = drawn.of_light(kLanding);
    // A landing may be off by what the pass itself takes for converged: three texels of the receiver map;
    // with impostors two texels of their cube across a slope that stretches them by 1 / cos.
    const double texel =
        (drawn.rendering.views[0].receiver.window_upper - drawn.rendering.views[0].receiver.window_lower).x /
        drawn.settings.map;
    double worst = 0.0;
    for (int y = 0; y < landing.height(); ++y)
      for (int x = 0; x < landing.width(); ++x) {
        if (landing.at(x, y, 3) != static_cast<float>(LandingStatus::Landed)) continue;
        const double off =
            double(landing.at(x, y, 1)) * std::cos(slope) - double(landing.at(x, y, 0)) * std::sin(slope);
        worst = std::max(worst, std::fabs(off));
      }
    CHECK(worst < (estimator == Estimator::Impostor ? 4.0 : 3.0) * texel);
    if (estimator == Estimator::Paper && degrees > 70.0) CHECK(drawn.share(&Ledger::not_converged) > 0.05);
    if (estimator == Estimator::Secant && degrees < 70.0) CHECK(drawn.share(&Ledger::not_converged) < 0.01);
  };
  return c;
}

HardCase stairs_case(Estimator estimator) {
  HardCase c{"stairs finer than a caster's cell, " + std::string(name_of(estimator)),
             "every ray ends on a step, as missed or as not converged", sphere_scene(1.5f, 4)};
  c.scene.meshes[0] = stairs(41, 0.06f, 0.05f);
  for (Vertex& v : c.scene.meshes[1].vertices) v.position.y += 1.6f;
  finish(c.scene.meshes[1], 1.0f);
  c.scene.lights = {sun({0.5, -1.0, 0.2}, 1.0f)};
  c.settings.estimator = estimator;
  return c;
}

HardCase nothing_below_case() {
  HardCase c{"no receiver", "no pass for caustics runs: nothing can catch them", sphere_scene(1.5f, 4)};
  c.scene.meshes.erase(c.scene.meshes.begin());
  c.expect = [](const DrawnCase& drawn) {
    CHECK(drawn.rendering.images.count(light_texture(kCausticMap, 0)) == 0);
  };
  return c;
}

HardCase behind_case() {
  HardCase c{"the only receiver stands before the caster",
             "no pass for caustics runs: nothing stands where they could land", sphere_scene(1.5f, 4)};
  c.scene.meshes[0] = box({0.1, 1.6, -0.4}, {0.4, 1.7, 0.4}, 0);
  c.expect = [](const DrawnCase& drawn) {
    CHECK(drawn.rendering.images.count(light_texture(kCausticMap, 0)) == 0);
  };
  return c;
}

HardCase small_floor_case() {
  HardCase c{"a floor smaller than the caustic", "light past its edge is missed, not drawn on its border",
             sphere_scene(1.5f, 4)};
  // The sphere's light comes together 0.8 m under its middle, within some millimetres.
  c.scene.meshes[0] = floor(0.05, -1.0, 0);
  c.expect = [](const DrawnCase& drawn) {
    CHECK(drawn.share(&Ledger::missed) + drawn.share(&Ledger::outside) > 0.5);
    const Image& landing = drawn.of_light(kLanding);
    for (int y = 0; y < landing.height(); ++y)
      for (int x = 0; x < landing.width(); ++x)
        if (landing.at(x, y, 3) == static_cast<float>(LandingStatus::Landed))
          CHECK(std::fabs(landing.at(x, y, 0)) < 0.06f);
  };
  return c;
}

HardCase holed_floor_case() {
  HardCase c{"a hole in the floor under the caster",
             "no texel of the hole is taken for a receiver at the origin", sphere_scene(1.5f, 4)};
  const Mesh hole = floor(3.0, 0.0, 0);
  c.scene.meshes.erase(c.scene.meshes.begin());
  for (const glm::vec2& at : {glm::vec2(-1.2f, 0.0f), {1.2f, 0.0f}, {0.0f, -1.2f}, {0.0f, 1.2f}}) {
    Mesh piece = floor(0.95, 0.0, 0);
    for (Vertex& v : piece.vertices) v.position += glm::vec3(at.x, 0.0f, at.y);
    finish(piece, 0.0f);
    c.scene.meshes.push_back(piece);
  }
  c.expect = [](const DrawnCase& drawn) {
    // The map tells the hole's edge to half a texel.
    const View& map = drawn.rendering.views[0].receiver;
    const double texel = (map.window_upper - map.window_lower).x / drawn.settings.map;
    const Image& landing = drawn.of_light(kLanding);
    for (int y = 0; y < landing.height(); ++y)
      for (int x = 0; x < landing.width(); ++x) {
        if (landing.at(x, y, 3) != static_cast<float>(LandingStatus::Landed)) continue;
        const float px = std::fabs(landing.at(x, y, 0)), pz = std::fabs(landing.at(x, y, 2));
        CHECK(std::max(px, pz) > 0.25 - 0.5 * texel);  // the hole is 0.5 m wide
      }
  };
  return c;
}

HardCase steps_case(int iterations) {
  HardCase c{"iterations " + std::to_string(iterations), "ends; what has not converged is booked",
             sphere_scene(1.5f, 4)};
  c.settings.iterations = iterations;
  c.settings.estimator = iterations == 1 ? Estimator::Secant : Estimator::Paper;
  return c;
}

HardCase cut_case() {
  HardCase c{"a floor that cuts the caster", "light lands on what lies in its way or is booked",
             sphere_scene(1.5f, 4)};
  for (Vertex& v : c.scene.meshes[1].vertices) v.position.y -= 0.8f;
  finish(c.scene.meshes[1], 1.0f);
  return c;
}

HardCase touching_case() {
  HardCase c{"a caster that stands on its receiver", "ways of length 0 land where they leave",
             sphere_scene(1.5f, 4)};
  c.scene.meshes[1] = box({-0.5, 0.0, -0.5}, {0.5, 0.4, 0.5}, 1);
  c.expect = [](const DrawnCase& drawn) { CHECK(drawn.share(&Ledger::in_map) > 0.9); };
  return c;
}

}  // namespace

std::vector<HardCase> estimator_cases() {
  std::vector<HardCase> cases;
  for (const Estimator estimator :
       {Estimator::Paper, Estimator::Newton, Estimator::Secant, Estimator::Impostor})
    for (const double degrees : {60.0, 80.0}) cases.push_back(steep_case(estimator, degrees));
  for (const Estimator estimator :
       {Estimator::Paper, Estimator::Newton, Estimator::Secant, Estimator::Impostor})
    cases.push_back(stairs_case(estimator));
  cases.push_back(nothing_below_case());
  cases.push_back(behind_case());
  cases.push_back(small_floor_case());
  cases.push_back(holed_floor_case());
  cases.push_back(steps_case(1));
  cases.push_back(steps_case(1000));
  cases.push_back(cut_case());
  cases.push_back(touching_case());
  return cases;
}

}  // namespace caustics::test
