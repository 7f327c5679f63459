// A tracer that has run on a scene, and what its tests ask of it.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "lab/reference/tracer/state_file.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/ray_queries.hpp"
#include "tests/support/scenes.hpp"

namespace caustics::tracer {

inline constexpr double kPi = 3.14159265358979323846;

// A scene, what it calls for, and a tracer on it.
struct Run {
  Scene scene;
  Settings settings;
  Effects effects;
  TraceSettings trace;
  std::unique_ptr<Tracer> tracer;

  Run(Scene from, int pixels, int side, int batches, Physics physics = Physics::Single, Settings with = {},
      int threads = 0)
      : scene(std::move(from)), settings(std::move(with)) {
    settings.width = settings.height = pixels;
    sample_lights(scene, 1);
    effects = effects_of(scene, settings);
    trace.width = trace.height = pixels;
    trace.side = side;
    trace.physics = physics;
    trace.threads = threads;
    tracer = std::make_unique<Tracer>(scene, effects, scene.cameras.at(0), trace);
    for (int i = 0; i < batches; ++i) REQUIRE(tracer->run_batch());
  }
  const Account& account() const { return tracer->state().accounts.at(0); }
  double batches() const { return static_cast<double>(tracer->state().batches); }
  std::string request() const { return request_text(scene, effects, scene.cameras.at(0), trace); }
};

// Red of each pixel.
inline std::vector<double> red(const std::vector<float>& values) {
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); i += 3) result.push_back(static_cast<double>(values[i]));
  return result;
}
inline void check_closed(const Account& a) {
  const glm::dvec3 gap = a.gap();
  CHECK(std::max({std::fabs(gap.x), std::fabs(gap.y), std::fabs(gap.z)}) < 1e-12 * a.entered.x);
}

// The line with which something is refused; empty where it is not.
template <class Act>
std::string refusal(Act act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

inline bool says(const std::string& line, const std::string& part) {
  return line.find(part) != std::string::npos;
}

// Light at an angle through a wide slab; the camera sees where it entered through the top alone.
inline Scene slab_scene(double incidence) {
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::glass(1.5f)};
  scene.meshes = {test::floor(3.0, 0.0, 0), test::box({-1.5, 0.5, -1.5}, {1.5, 0.7, 1.5}, 1)};
  scene.lights = {test::sun({std::sin(incidence), -std::cos(incidence), 0.0}, 1.0f)};
  scene.cameras = {test::camera_down(0.3, 0.3)};
  return scene;
}

// A lamp that shines down from so many metres above the middle, so wide along x and z.
inline Light panel_above(double height, float candela, double along_x, double along_z) {
  Light panel{.name = "panel", .type = LightType::Point, .intensity = candela};
  panel.position = {0.0, height, 0.0};
  panel.direction = {0.0, -1.0, 0.0};
  panel.lambertian = true;
  panel.shape = LightShape::Rectangle;
  panel.width = {along_x, 0.0, 0.0};
  panel.height = {0.0, 0.0, along_z};
  return panel;
}

}  // namespace caustics::tracer
