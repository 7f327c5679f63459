// A state goes on only with the request that it was made for: whatever a traced ray could tell makes another
// one.
#include "lab/reference/tracer/state_file.hpp"

#include <functional>
#include <map>
#include <set>

#include "pipeline/effects/effects.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scenes.hpp"

namespace caustics::tracer {

namespace {

struct Asked {
  Scene scene;
  Camera camera;
  TraceSettings trace;
  Asked() {
    scene.materials = {test::diffuse(0.8f), test::glass(1.5f)};
    scene.meshes = {test::floor(3.0, 0.0, 0), test::box({-1, 0.5, -1}, {1, 0.7, 1}, 1)};
    scene.lights = {test::sun({0.0, -1.0, 0.0}, 1.0f), test::sun({0.5, -1.0, 0.0}, 2.0f)};
    camera = test::camera_down(0.3, 0.3);
    trace.width = 8;
    trace.height = 6;
    trace.side = 16;
    sample_lights(scene, 1);
  }
  std::string text() const {
    const Asked plain;  // the effects stay: what is asked here is what the text holds itself
    static const Effects effects = effects_of(plain.scene, Settings{});
    return request_text(scene, effects, camera, trace);
  }
};

using Change = std::function<void(Asked&)>;

Light& light(Asked& asked) { return asked.scene.sources.at(1); }
Material& material(Asked& asked) { return asked.scene.materials.at(1); }

const std::map<std::string, Change> kChanges = {
    {"light.type", [](Asked& a) { light(a).type = LightType::Spot; }},
    {"light.color", [](Asked& a) { light(a).color.z = 0.5f; }},
    {"light.intensity", [](Asked& a) { light(a).intensity = 3.0f; }},
    {"light.position", [](Asked& a) { light(a).position.y = 3.0; }},
    {"light.direction", [](Asked& a) { light(a).direction.x = 0.4; }},
    {"light.range", [](Asked& a) { light(a).range = 7.0f; }},
    {"light.inner_cone", [](Asked& a) { light(a).inner_cone = 0.1f; }},
    {"light.outer_cone", [](Asked& a) { light(a).outer_cone = 0.6f; }},
    {"light.lambertian", [](Asked& a) { light(a).lambertian = true; }},
    {"light.shape", [](Asked& a) { light(a).shape = LightShape::Disk; }},
    {"light.radius", [](Asked& a) { light(a).radius = 0.1; }},
    {"light.width", [](Asked& a) { light(a).width.x = 0.1; }},
    {"light.height", [](Asked& a) { light(a).height.z = 0.1; }},
    {"light.angular_radius", [](Asked& a) { light(a).angular_radius = 0.01; }},
    {"light.emitter", [](Asked& a) { light(a).emitter = 1; }},
    {"material.base_color", [](Asked& a) { material(a).base_color.y = 0.5f; }},
    {"material.metallic", [](Asked& a) { material(a).metallic = 0.25f; }},
    {"material.roughness", [](Asked& a) { material(a).roughness = 0.25f; }},
    {"material.transmission", [](Asked& a) { material(a).transmission = 0.75f; }},
    {"material.ior", [](Asked& a) { material(a).ior = 1.25f; }},
    {"material.thickness", [](Asked& a) { material(a).thickness = 0.75f; }},
    {"material.attenuation_color", [](Asked& a) { material(a).attenuation_color.x = 0.5f; }},
    {"material.attenuation_distance", [](Asked& a) { material(a).attenuation_distance = 2.0f; }},
    {"material.dispersion", [](Asked& a) { material(a).dispersion = 0.25f; }},
    {"material.double_sided", [](Asked& a) { material(a).double_sided = !material(a).double_sided; }},
    {"a vertex", [](Asked& a) { a.scene.meshes[1].vertices[3].position.y += 0.1f; }},
    {"a normal", [](Asked& a) { a.scene.meshes[1].vertices[3].normal.y += 0.1f; }},
    {"a triangle", [](Asked& a) { std::swap(a.scene.meshes[1].indices[0], a.scene.meshes[1].indices[1]); }},
    {"a mesh's material", [](Asked& a) { a.scene.meshes[0].material = 1; }},
    {"a mesh's object", [](Asked& a) { a.scene.meshes[1].object = 5; }},
    {"closedness", [](Asked& a) { a.scene.meshes[1].closedness = 0.5f; }},
    {"the camera's place", [](Asked& a) { a.camera.position.x += 0.1; }},
    {"the camera's direction", [](Asked& a) { std::swap(a.camera.right, a.camera.up); }},
    {"the camera's height", [](Asked& a) { a.camera.half_height = 0.2; }},
    {"the camera's kind", [](Asked& a) { a.camera.orthographic = !a.camera.orthographic; }},
    {"the picture's size", [](Asked& a) { a.trace.height = 7; }},
    {"rays", [](Asked& a) { a.trace.side = 17; }},
    {"physics", [](Asked& a) { a.trace.physics = Physics::Full; }},
};

TraceState some_state() {
  TraceState state;
  state.batches = 3;
  state.accounts.resize(2);
  state.accounts[1].entered = {0.25, 0.5, 0.75};
  state.sum = {1.0, 2.0, 3.0};
  state.squares = {4.0, 5.0, 6.0};
  return state;
}

std::string refusal(const std::string& bytes, const std::string& request) {
  try {
    from_bytes(bytes, request, some_state());
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::BadInput);
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("tracer state: each property that a ray could tell makes another request") {
  const std::string before = Asked().text();
  CHECK(Asked().text() == before);
  std::map<std::string, std::string> texts;
  for (const auto& [name, change] : kChanges) {
    Asked asked;
    change(asked);
    INFO(name);
    const std::string text = asked.text();
    CHECK(text != before);
    for (const auto& [other, its] : texts) CHECK((text != its || other == name));
    texts[name] = text;
    CHECK(refusal(to_bytes(some_state(), before), text).find("there, ") != std::string::npos);
  }
}

TEST_CASE("tracer state: each number of an exact shape makes another request") {
  std::set<std::string> texts{Asked().text()};
  const auto is_new = [&](const ExactShape& shape) {
    Asked asked;
    asked.trace.exact = {shape};
    return texts.insert(asked.text()).second;
  };
  ExactSphere sphere{.centre = {0.1, 0.2, 0.3}, .radius = 0.4};
  ExactCylinder rod{.walls = {{.radius = 0.4}, {.radius = 0.3}}};
  ExactWaves waves{.field = {.waves = {{0.1, {1.0, 2.0}, 0.3}}}};
  CHECK(is_new({1, sphere}));
  CHECK(is_new({0, sphere}));
  for (double* number : {&sphere.centre.x, &sphere.centre.y, &sphere.centre.z, &sphere.radius}) {
    *number += 0.5;
    CHECK(is_new({1, sphere}));
  }
  CHECK(is_new({1, rod}));
  for (double* number : {&rod.foot.x, &rod.foot.y, &rod.foot.z, &rod.axis.x, &rod.axis.y, &rod.axis.z,
                         &rod.middle.x, &rod.middle.y, &rod.middle.z, &rod.height, &rod.least_cosine,
                         &rod.walls[0].radius, &rod.walls[0].outward, &rod.walls[1].radius}) {
    *number += 0.5;
    CHECK(is_new({1, rod}));
  }
  for (bool* lid : {&rod.lower_lid, &rod.upper_lid}) {
    *lid = true;
    CHECK(is_new({1, rod}));
  }
  CHECK(is_new({1, waves}));
  SineWave& wave = waves.field.waves[0];
  for (double* number :
       {&wave.amplitude, &wave.k.x, &wave.k.y, &wave.phase, &waves.field.level, &waves.field.origin.x,
        &waves.field.origin.y, &waves.field.origin.z, &waves.field.axes[0].y, &waves.field.axes[2].x,
        &waves.lower.x, &waves.lower.y, &waves.upper.x, &waves.upper.y, &waves.side}) {
    *number += 0.5;
    CHECK(is_new({1, waves}));
  }
}

TEST_CASE("tracer state: what is kept comes back, and nothing that is shorter, longer or altered") {
  const std::string request = Asked().text(), bytes = to_bytes(some_state(), request);
  const TraceState back = from_bytes(bytes, request, some_state());
  CHECK(back.batches == 3);
  CHECK(back.accounts.at(1).entered == glm::dvec3(0.25, 0.5, 0.75));
  CHECK(back.sum == some_state().sum);
  CHECK(back.squares == some_state().squares);
  CHECK_FALSE(refusal(bytes.substr(0, bytes.size() - 1), request).empty());
  CHECK_FALSE(refusal(bytes + "x", request).empty());
  CHECK_FALSE(refusal("", request).empty());
}

}  // namespace caustics::tracer
