// A whole frame of a fuzzed scene, and what must hold of it.
#include <algorithm>
#include <cmath>
#include <memory>

#include "passes/registry.hpp"
#include "pipeline/measure/error_estimate.hpp"
#include "pipeline/measure/ledger.hpp"
#include "pipeline/measure/pixel_side.hpp"
#include "pipeline/renderer/frame_renderer.hpp"
#include "pipeline/renderer/stage.hpp"
#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "pipeline/settings/check_settings.hpp"
#include "raster/software_device.hpp"
#include "tests/fuzz/fuzzed_scene.hpp"
#include "tests/support/pilot.hpp"

namespace caustics::fuzz {

namespace {

// What may remain of a ledger is rounding: of each landing's own numbers; and of the map's sums, which are
// single precision. A sum of n is off by up to n 2^-24 of its size, and where the map is small or all light
// meets in one texel, that texel takes each landing up to twice, as a part of cells and as a splat.
double most_residual(const Ledger& ledger, const View& caustic) {
  if (!caustic.cube) return 1e-5;  // the ledger has counted the splats of each texel itself
  const auto landed = static_cast<double>(ledger.vertices[static_cast<std::size_t>(LandingStatus::Landed)]);
  return std::max(1e-5, 2.0 * landed * 0x1p-24);
}

// Samples of all lights together: each has maps and passes of its own.
constexpr std::size_t kMostLights = 8;

// Everything that a frame is drawn from, in the order in which it is made.
class TinyFrame {
 public:
  TinyFrame(Scene scene, const Settings& settings, double seconds)
      : settings_(settings), scene_(std::move(scene)), device_(make_software_device({.threads = 1})) {
    renderer_ = std::make_unique<FrameRenderer>(scene_, settings_, pass_registry(), *device_,
                                                FrameOptions{.seconds = seconds});
  }

  void run() { renderer_->run(); }

  // Every texture, in the order in which the passes have written them.
  void check_finite() const {
    for (const PlannedPass& pass : renderer_->plan().passes)
      for (const int texture : pass.attachments()) {
        const std::size_t bad = count_non_finite(renderer_->read(texture));
        if (bad > 0)
          finding(pass.label + ": " + renderer_->plan().textures[static_cast<std::size_t>(texture)].name +
                  " has " + std::to_string(bad) + " values that are not finite");
      }
  }

  void check_ledgers() const {
    for (int light = 0; light < static_cast<int>(scene_.lights.size()); ++light) {
      const bool any = has(branch_texture(kLanding, light, renderer_->effects().branches.front()));
      if (any && has(light_texture(kCausticMap, light))) check_ledger(light);
    }
  }

 private:
  bool has(const std::string& name) const { return renderer_->has(name); }
  Image read(const std::string& name) const { return has(name) ? renderer_->read(name) : Image{}; }

  void check_ledger(int light) const {
    const auto is_there = [&](const std::string& name) { return has(name); };
    const auto get = [&](const std::string& name) { return read(name); };
    const std::vector<BranchImages> branches =
        branch_images(light, renderer_->effects().branches, is_there, get);
    const Image map = read(light_texture(kCausticMap, light));
    const LightViews& views = renderer_->views()[static_cast<std::size_t>(light)];
    const std::vector<CellImages> cells = cell_images(light, renderer_->effects().branches, is_there, get);
    const Ledger ledger = make_ledger(
        branches, cells, map, read(light_texture(far_texture(kCausticMap), light)), views.caustic, settings_);
    if (!(ledger.residual() <= most_residual(ledger, views.caustic)))
      finding("light " + std::to_string(light) + ": the ledger's residual is " +
              std::to_string(ledger.residual() * 1e6) + " millionths");
    const double pixel = settings_.pixel_means ? pixel_side(read("view_position"), map, views.caustic) : 0.0;
    const ErrorEstimate estimate = estimate_error(
        branches, cells, map, read(light_texture(kCascadeMap, light)), views, settings_, ledger, pixel);
    if (!std::isfinite(estimate.total()))
      finding("light " + std::to_string(light) + ": the error estimate is not finite");
  }

  Settings settings_;
  Scene scene_;
  std::unique_ptr<Device> device_;
  std::unique_ptr<FrameRenderer> renderer_;
};

template <class T, std::size_t N>
T pick(const T (&choices)[N], unsigned byte) {
  return choices[byte % N];
}

}  // namespace

FrameChoice choice_of(ByteSpan last) {
  const auto byte = [&](std::size_t i) -> unsigned { return i < last.size() ? last[i] : 0u; };
  const auto bit = [&](std::size_t i, unsigned at) { return (byte(i) >> at & 1u) != 0; };
  FrameChoice choice;
  Settings& s = choice.settings;
  s.estimator = static_cast<Estimator>(byte(0) & 3u);
  s.splat = static_cast<Splat>((2u + (byte(0) >> 2)) % 3u);
  s.thickness = static_cast<Thickness>(bit(0, 5));
  s.weights = static_cast<Weights>(bit(0, 6));
  s.shared_views = bit(0, 7);
  s.interfaces = static_cast<Interfaces>((byte(1) & 3u) % 3u);
  s.cube = static_cast<Cube>((byte(1) >> 2 & 3u) % 3u);
  s.reflections = bit(1, 4);
  s.assume_solid = bit(1, 5);
  s.emissive_lights = bit(1, 6) ? EmissiveLights::On : EmissiveLights::Off;
  s.cascades = !bit(1, 7);
  s.hidden_receivers = !bit(2, 0);
  s.pixel_means = !bit(2, 1);
  s.wavelengths = pick({3, 1, 8, 9}, byte(2) >> 2 & 3u);
  s.iterations = pick({5, 1, 2, 12}, byte(2) >> 4 & 3u);
  s.light_samples = pick({2, 1, 3, 4}, byte(2) >> 6);
  s.grid = pick({16, 1, 2, 48}, byte(3) & 3u);
  s.map = pick({16, 1, 2, 48}, byte(3) >> 2 & 3u);
  s.shadow = pick({16, 1, 3, 48}, byte(3) >> 4 & 3u);
  s.width = pick({16, 1, 2, 21}, byte(3) >> 6);
  s.height = pick({16, 1, 3, 11}, byte(4) & 3u);
  s.medium_steps = pick({2, 1, 5, 8}, byte(4) >> 2 & 3u);
  s.shafts = pick({4, 1, 16, 128}, byte(4) >> 4 & 3u);
  s.outside_share = pick({4e-3, 0.0, 0.1, 0.5}, byte(4) >> 6);
  s.gaussian_sigma = pick({0.7f, 0.1f, 1.5f, 4.0f}, byte(5) & 3u);
  if (bit(5, 2)) s.exposure = pick({0.0f, -40.0f, 40.0f, 3.5f}, byte(5) >> 3 & 3u);
  if (bit(5, 5)) s.mirror_metallic = 0.0f, s.mirror_roughness = 1.0f;
  if (bit(5, 6)) s.glass_roughness = 1.0f;
  if (bit(5, 7)) {
    s.further_share = 0.0f;
    s.bounces = pick({4, 2, 3, 9}, byte(7) & 3u);
    s.splits = pick({2, 0, 1, 4}, byte(7) >> 2 & 3u);
    s.least_share = pick({1e-3f, 0.0f, 0.5f, 1e-6f}, byte(7) >> 4 & 3u);
  }
  choice.moment = byte(6) / 255.0;
  // Some choices need larger maps than others; check() says so.
  if (s.cube == Cube::On || s.estimator == Estimator::Impostor) {
    s.grid = s.map = s.shadow = 48;
    if (!too_small_for_cubes(s).empty()) s.splat = Splat::Cell, s.gaussian_sigma = 0.7f;
  }
  return choice;
}

bool render_frame(Scene scene, const Settings& settings, double seconds) {
  try {
    check(settings);
  } catch (const Error&) {
    return false;
  }
  if (settings.emissive_lights == EmissiveLights::On) add_emissive_lights(scene);
  sample_lights(scene, settings.light_samples);
  try {
    complete_scene(scene, settings, test::pilot());
    if (scene.lights.size() > kMostLights) return false;
    TinyFrame frame(std::move(scene), settings, seconds);
    frame.run();
    frame.check_finite();
    frame.check_ledgers();
  } catch (const Error& error) {
    // Water that is no refractor under these settings, for example.
    check_refusal(error);
    return false;
  }
  return true;
}

}  // namespace caustics::fuzz
