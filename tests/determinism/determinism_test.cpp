// The same bits for every number of threads and every lane width, over all attachments of a frame.
#include <cstring>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Scene lively_scene() {
  Scene scene = sphere_scene(1.5f, 4);
  scene.materials[1].attenuation_distance = 0.5f;
  scene.materials[1].attenuation_color = {0.9f, 0.5f, 0.3f};
  scene.meshes.push_back(box({-1.0, 0.0, -0.9}, {-0.6, 0.5, -0.4}, 0));
  scene.meshes.push_back(box({0.4, 0.2, 0.3}, {0.9, 0.6, 0.7}, 1));
  scene.lights = {sun({0.3, -1.0, -0.2}, 2.0f)};
  Light point{.name = "point", .type = LightType::Point, .intensity = 3.0f};
  point.position = {-0.8, 2.0, 0.6};
  scene.lights.push_back(point);
  scene.environment.reach = 1.0f;
  return scene;
}

Settings whole_picture() {
  Settings settings = small_settings(96, 96, 75);
  settings.height = 51;
  return settings;
}

using Images = std::map<std::string, Image>;
using Names = std::vector<std::string>;

Images drawn(SoftwareOptions options, const Settings& settings = whole_picture()) {
  return render(lively_scene(), settings,
                {"picture", "beauty", "aov_direct", "aov_caustic", "aov_position", "aov_normal"}, options)
      .images;
}

// Bit by bit, so that -0 is not 0 and NaN is itself; their hashes would take longer than the frames.
Names differing(const Images& found, const Images& expected) {
  Names names;
  for (const auto& [name, image] : expected) {
    const auto other = found.find(name);
    const bool same = other != found.end() && other->second.shape == image.shape &&
                      other->second.values.size() == image.values.size() &&
                      std::memcmp(other->second.values.data(), image.values.data(),
                                  image.values.size() * sizeof(float)) == 0;
    if (!same) names.push_back(name);
  }
  for (const auto& [name, image] : found)
    if (!expected.contains(name)) names.push_back(name);
  return names;
}

}  // namespace

TEST_CASE("determinism: 1, 2 and 7 threads on every lane width give the same bits") {
  const auto expected = drawn({.threads = 1, .lanes = Lanes::Scalar});
  REQUIRE(expected.size() > 20);
  for (const Lanes lanes : supported_lanes())
    for (const int threads : {1, 2, 7}) {
      INFO("lanes " << lanes_name(lanes) << ", threads " << threads);
      CHECK(differing(drawn({.threads = threads, .lanes = lanes}), expected) == Names{});
    }
}

TEST_CASE("determinism: light that is followed has the same bits on every lane width, by 1 and 3 threads") {
  Settings settings = small_settings(40, 40, 30);
  settings.further_share = 0.0f;
  settings.bounces = 5;
  const auto expected = drawn({.threads = 1, .lanes = Lanes::Scalar}, settings);
  REQUIRE(expected.count("landing_footprint[0 mirrored 1]") == 1);
  for (const Lanes lanes : supported_lanes())
    for (const int threads : {1, 3}) {
      INFO("lanes " << lanes_name(lanes) << ", threads " << threads);
      CHECK(differing(drawn({.threads = threads, .lanes = lanes}, settings), expected) == Names{});
    }
}

TEST_CASE("determinism: 4 samples a pixel have the same bits on every lane width, by 1 and 3 threads") {
  Settings settings = small_settings(40, 40, 30);
  settings.samples = 4;
  const auto picture = [&](SoftwareOptions options) {
    return render_alone(lively_scene(), settings, {"beauty", "picture"}, options).images;
  };
  const auto expected = picture({.threads = 1, .lanes = Lanes::Scalar});
  for (const Lanes lanes : supported_lanes())
    for (const int threads : {1, 3}) {
      INFO("lanes " << lanes_name(lanes) << ", threads " << threads);
      CHECK(differing(picture({.threads = threads, .lanes = lanes}), expected) == Names{});
    }
}

TEST_CASE("determinism: no attachment holds a value that is not finite") {
  Settings settings = small_settings(96, 96, 64);
  const Rendering r = render(lively_scene(), settings, {"picture", "aov_direct"});
  for (const auto& [name, image] : r.images) {
    INFO(name);
    CHECK(count_non_finite(image) == 0);
  }
}
