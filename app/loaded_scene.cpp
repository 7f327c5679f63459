#include "app/loaded_scene.hpp"

#include <algorithm>

#include "app/frame.hpp"
#include "app/frame_options.hpp"
#include "app/shell/interrupt.hpp"
#include "app/shell/standard_input.hpp"
#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/renderer/stage.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/environment.hpp"
#include "pipeline/scene/far_lights.hpp"
#include "pipeline/scene/gltf/load_environment.hpp"
#include "pipeline/scene/gltf/load_gltf.hpp"
#include "pipeline/scene/lamp_meshes.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "pipeline/settings/nearest.hpp"
#include "pipeline/views/framing.hpp"

namespace caustics::app {

namespace {

// A camera by its name, or else by its number.
const Camera& camera_called(const Scene& scene, const std::string& wanted) {
  if (wanted.empty()) return scene.cameras.front();
  std::vector<std::string> names;
  for (const Camera& camera : scene.cameras) {
    if (camera.name == wanted) return camera;
    names.push_back(camera.name);
  }
  if (wanted.find_first_not_of("0123456789") == std::string::npos && wanted.size() < 8) {
    const std::size_t number = static_cast<std::size_t>(std::stoi(wanted));
    if (number < scene.cameras.size()) return scene.cameras[number];
  }
  throw Error(ExitCode::WrongUsage, "there is no camera " + in_quotes(wanted) + suggestion(wanted, names));
}

// More would plan for minutes before the memory that they need is refused.
constexpr std::size_t kMostSamples = 4096;

void sample_area_lights(Scene& scene, int count) {
  std::size_t sized = 0, samples = 0;
  for (const Light& light : scene.lights) {
    if (light.shape == LightShape::None) continue;
    ++sized;
    samples += static_cast<std::size_t>(light.samples > 0 ? light.samples : count);
  }
  if (samples > kMostSamples) {
    throw Error(ExitCode::WrongUsage, std::to_string(sized) + " lights with a size would need " +
                                          grouped(samples) + " samples, more than " + grouped(kMostSamples) +
                                          "; lower -D light.samples");
  }
  sample_lights(scene, count);
  make_far_lights_parallel(scene);
}

AnimatedScene load(const FrameRequest& request) {
  LoadOptions options;
  options.animation = request.animation;
  options.memory = request.budget();
  if (!is_standard_input(request.scene)) return load_animated(request.scene, options);
  options.content = standard_input(options.max_bytes);
  return load_animated("standard input", options);
}

}  // namespace

LoadedScene::LoadedScene(const FrameRequest& request)
    : settings_(request.settings), animation_(load(request)), moving_(animation_.moving_meshes()) {
  for (const int mesh : moving_) {
    swept_.push_back(animation_.swept_bounds(mesh));
    outlines_.push_back(animation_.outline(mesh));
  }
  RunFiles run = request.files;
  for (const std::filesystem::path& file : animation_.files()) run.reads(file, "a file of the scene");
  scene_ = animation_.take();
  if (request.environment) {
    LoadOptions options;
    options.memory = request.budget();
    scene_.environment = load_environment(*request.environment, options);
  }
  const std::unique_ptr<Device> device = make_pilot_device(request.backend);
  complete({*device, pass_registry()});
  stop_if_interrupted();
  move_to(request.seconds.value_or(0.0));
}

// Which meshes are lamps is judged once, as the scene stands at its beginning. A sun that is asked for stands
// in the place of all other lights.
Lamps LoadedScene::judge_what_shines() const {
  if (settings_.sun || settings_.emissive_lights == EmissiveLights::Off) return {};
  if (settings_.emissive_lights == EmissiveLights::Auto)
    return choose_lamps(scene_, static_cast<double>(sun_lux(scene_.environment)), settings_.light_samples);
  Lamps all;
  all.instead_of_sun = true;
  for (int i = 0; i < static_cast<int>(scene_.meshes.size()); ++i)
    if (shines(scene_, scene_.meshes[static_cast<std::size_t>(i)]))
      all.lights.push_back(light_of_mesh(scene_, i));
  return all;
}

// The lights as they stand now: the scene's own, or what was added in their place, and the meshes that shine.
void LoadedScene::light_up() {
  if (!added_sources_.empty()) scene_.lights = added_sources_;
  for (const Light& lamp : lamps_) {
    Light light = light_of_mesh(scene_, lamp.emitter);
    light.samples = lamp.samples;
    scene_.lights.push_back(std::move(light));
  }
  sample_area_lights(scene_, settings_.light_samples);
}

void LoadedScene::complete(const Pilot& pilot) {
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    Mesh& mesh = scene_.meshes[static_cast<std::size_t>(moving_[i])];
    mesh.lower = glm::vec3(swept_[i].lower);
    mesh.upper = glm::vec3(swept_[i].upper);
    mesh.outline = outlines_[i];
  }
  Lamps lamps = judge_what_shines();
  scene_.dim_meshes = std::move(lamps.dim);
  // Beside a sun that is yet to be added they come after it.
  const bool after_sun = scene_.lights.empty() && !lamps.instead_of_sun;
  if (!after_sun) lamps_ = lamps.lights;
  light_up();
  const Completed completed = complete_scene(scene_, settings_, pilot);
  if (completed.lights) added_sources_ = scene_.sources;
  if (after_sun && !lamps.lights.empty()) {
    lamps_ = std::move(lamps.lights);
    light_up();
  }
  adjust(scene_.environment, static_cast<double>(settings_.environment_strength),
         static_cast<double>(settings_.environment_turn));
  note_environment();
  if (completed.cameras) added_cameras_ = scene_.cameras;
  added_ = completed.added;
  notes_ = scene_.notes;
  choose_camera();
  exposure_ = exposure_of(scene_, settings_,
                          view_of(camera_, settings_.width, settings_.height, bounds_of(scene_)), pilot);
}

// An image that is much brighter or dimmer than the lights hides their caustics, or stays dark itself.
void LoadedScene::note_environment() {
  constexpr double kUsual = 0.3, kLeast = 0.1, kMost = 2.0;  // of what the lights give
  const double lights = light_level(scene_), around = upward_irradiance(scene_.environment);
  if (!scene_.environment.image || !(lights > 0.0 && around > 0.0)) return;
  const double share = around / lights;
  if (share > kLeast && share < kMost) return;
  const double strength = static_cast<double>(settings_.environment_strength) * kUsual / share;
  const auto text = [](double value) {
    const bool is_counted = value >= 10.0 && value < 1e9;
    return is_counted ? grouped(static_cast<std::uint64_t>(value)) : significant(value, 2);
  };
  scene_.notes.push_back("The environment gives " + text(share) +
                         " times what the lights give; --environment-strength " + text(strength) +
                         " would balance them.");
}

void LoadedScene::choose_camera() {
  camera_ = with_lens(camera_called(scene_, settings_.camera), settings_.fov, settings_.zoom);
}

void LoadedScene::move_to(double seconds) {
  if (!moves()) return;
  animation_.move_to(seconds, scene_);
  light_up();
  if (!added_cameras_.empty()) scene_.cameras = added_cameras_;
  scene_.notes = notes_;
  choose_camera();
}

std::unique_ptr<LoadedScene> load_scene(const FrameRequest& request) {
  return std::make_unique<LoadedScene>(request);
}

}  // namespace caustics::app
