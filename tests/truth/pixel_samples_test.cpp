// Several samples a pixel, in whole frames: what a pixel that an edge crosses shows.
#include <algorithm>
#include <set>

#include "pipeline/gpu/device.hpp"
#include "pipeline/views/sub_pixel.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Seen from above, 2 m a side in 8 pixels: a square that shines, 1 nit, in the dark. Its edges run through
// the middles of pixels: 0.625 m is 2.5 pixels.
Scene shining_square() {
  Scene scene;
  scene.materials = {diffuse(0.0f)};
  scene.materials[0].emissive = glm::vec3(1.0f);
  scene.meshes = {floor(0.625, 0.0, 0)};
  scene.cameras = {camera_down(1.0, 1.0)};
  return scene;
}

Image beauty_of(const Scene& scene, int samples, int picture = 8) {
  Settings settings = small_settings(16, 16, picture);
  settings.samples = samples;
  return render_alone(scene, settings, {"beauty"})["beauty"];
}

std::set<float> values_of(const Image& image) {
  std::set<float> values;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) values.insert(image.at(x, y, 0));
  return values;
}

// A ball of glass over a floor with a box on it, and the caustic.
Scene ball_and_box(double camera_height) {
  Scene scene = sphere_scene(1.5f, 4);
  scene.cameras = {camera_down(camera_height, 1.0)};
  scene.lights = {sun({0.2, -1.0, 0.1}, 1.0f)};
  scene.meshes.push_back(box({0.5, 0.0, 0.5}, {0.8, 0.1, 0.8}, 0));
  return scene;
}

}  // namespace

TEST_CASE("pixel samples: of a pixel that a surface covers by half or a quarter so much is seen") {
  for (const int samples : {4, 8, 16}) {
    const Image beauty = beauty_of(shining_square(), samples);
    INFO(samples);
    CHECK(beauty.at(4, 4, 0) == 1.0f);
    CHECK(beauty.at(7, 4, 0) == 0.0f);
    CHECK(beauty.at(4, 4, 3) == 1.0f);
    // Of 16 samples one lies on the edge, in the pixel's middle row and column each.
    const float allowed = samples == 16 ? 1.0f / 16.0f : 0.0f;
    for (const auto& [x, y] : {std::pair{6, 4}, {1, 4}, {4, 6}, {4, 1}})
      CHECK(std::fabs(beauty.at(x, y, 0) - 0.5f) <= allowed);
    CHECK(std::fabs(beauty.at(6, 6, 0) - 0.25f) <= allowed);
  }
  CHECK(values_of(beauty_of(shining_square(), 1)) == std::set{0.0f, 1.0f});
}

TEST_CASE("pixel samples: an edge aslant has every quarter between what it parts") {
  Scene scene = shining_square();
  Mesh& mesh = scene.meshes[0];
  mesh.vertices[1].position.x = 0.5f;
  mesh.vertices[2].position.x = 0.1f;
  CHECK(values_of(beauty_of(scene, 4, 32)) == std::set{0.0f, 0.25f, 0.5f, 0.75f, 1.0f});
}

TEST_CASE("pixel samples: the picture is the mean of those through shifted windows, to the bit") {
  // 12 lights are drawn light by light, one sample by sample (pipeline/plan/light_order.hpp).
  const std::size_t lights = GENERATE(1u, 12u);
  Scene scene = ball_and_box(0.2);  // below the ball: no glass is seen, so no surroundings either
  for (std::size_t i = 1; i < lights; ++i)
    scene.lights.push_back(sun({0.1 * static_cast<double>(i) - 0.6, -1.0, 0.3}, 0.7f));
  constexpr int kSide = 40;
  const auto device = make_software_device();
  FrameRenderer middles(scene, small_settings(48, 48, kSide), pass_registry(), *device,
                        {.goal = {{"beauty"}}});
  Image mean(Format::RGBA32F, kSide, kSide);
  for (const SubPixel& by : sub_pixels(4)) {
    FrameInputs inputs = middles.inputs();
    inputs.camera = shifted(inputs.camera, by, kSide, kSide);
    const FrameTargets targets(middles.plan(), *device);
    run_plan(middles.plan(), pass_registry(), middles.on_device(), targets, inputs);
    const Image one = device->read_back(targets[middles.plan().find("beauty")]);
    for (std::size_t i = 0; i < one.values.size(); ++i) mean.values[i] += 0.25f * one.values[i];
  }
  Settings settings = small_settings(48, 48, kSide);
  settings.samples = 4;
  FrameRenderer four(scene, settings, pass_registry(), *device, {.goal = {{"beauty"}}});
  std::vector<int> order;
  for (const PlannedPass& pass : four.plan().passes)
    if (pass.sample > 0) order.push_back(pass.sample);
  CHECK(std::is_sorted(order.begin(), order.end()) == (lights == 1));
  CHECK(rendering_of(four)["beauty"].values == mean.values);
}

TEST_CASE("pixel samples: layers have the bits that they have with one") {
  const std::vector<std::string> layers = {"aov_direct", "aov_caustic", "aov_position", "aov_normal"};
  Settings settings = small_settings(48, 48, 40);
  const Rendering one = render_alone(ball_and_box(2.0), settings, layers);
  settings.samples = 4;
  std::vector<std::string> wanted = layers;
  wanted.emplace_back("picture");
  const Rendering four = render_alone(ball_and_box(2.0), settings, wanted);
  for (const std::string& layer : layers) {
    INFO(layer);
    CHECK(four[layer].values == one[layer].values);
  }
}
