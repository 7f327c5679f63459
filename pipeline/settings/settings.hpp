// How a frame is rendered. What each setting is called and means, and what values it may have, stands in
// settings.cpp's table (setting.hpp).
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/settings/stage.hpp"
#include "pipeline/shader/constants.hpp"

namespace caustics {

enum class Estimator : std::uint8_t {
  Paper = ESTIMATOR_PAPER,
  Secant = ESTIMATOR_SECANT,
  Newton = ESTIMATOR_NEWTON,
  Impostor = ESTIMATOR_IMPOSTOR
};
enum class Splat : std::uint8_t { Point, Gaussian, Cell };
enum class Weights : std::uint8_t { Physical, Paper };
enum class Thickness : std::uint8_t { Map, Wyman };
enum class Cube : std::uint8_t { Auto, On, Off };
enum class EmissiveLights : std::uint8_t { Auto, On, Off };
enum class ToneMap : std::uint8_t { Film, Neutral, Linear };
enum class Interfaces : std::uint8_t { Auto, One, Two };

// A side in grid vertices or texels: of so many, or chosen for what a picture shows
// (pipeline/renderer/picture_sides.hpp), and then the count is where the choice starts.
struct Side {
  int count = 512;
  bool automatic = true;
  Side() = default;
  Side(int given) : count(given), automatic(false) {}
  operator int() const { return count; }
};

// The defaults are the values here, and are written nowhere else.
struct Settings {
  int width = 1280, height = 720;
  Side grid, map;
  int shadow = 2048;
  int light_samples = 16;
  float least_light = 0.005f, full_light = 0.125f;
  int most_lights = 64;  // that throw caustics of their own; 0: all
  EmissiveLights emissive_lights = EmissiveLights::Auto;
  int shafts = 128;
  int medium_steps = 32;
  int iterations = 5;
  Estimator estimator = Estimator::Secant;
  std::optional<float> search_start;    // none: 0.10 m for Newton, 0 for the paper's
  std::optional<float> newton_epsilon;  // none: a texel's extent
  bool newton_guard = true;
  bool draw_unconverged = false;
  Thickness thickness = Thickness::Map;
  Splat splat = Splat::Cell;
  float gaussian_sigma = 0.7f;
  Interfaces interfaces = Interfaces::Auto;
  Weights weights = Weights::Physical;
  int wavelengths = 3;
  bool reflections = false;
  float further_share = 0.03f;
  int bounces = 32, splits = 2;
  bool drawn = true;
  float least_share = 1e-3f;
  bool shared_views = false;
  Cube cube = Cube::Auto;
  bool cascades = true;
  bool pixel_means = true;
  bool hidden_receivers = true;
  double outside_share = 4e-3;
  bool assume_solid = false;
  std::optional<float> exposure;  // none: automatic
  bool highlights = true, ambient_occlusion = true;
  ToneMap tone_map = ToneMap::Film;
  float environment_strength = 1.0f, environment_turn = 0.0f;
  std::string camera;  // empty: the first
  Ground ground;
  std::optional<SunWish> sun;   // none: the scene's lights
  std::optional<Bearing> view;  // none: the scene's camera
  float zoom = 1.0f;
  std::optional<float> fov;  // degrees; none: the camera's own
  float mirror_metallic = 0.5f, mirror_roughness = 0.2f;
  float glass_roughness = 0.2f;
  int samples = 0;  // a pixel, as sub_pixels (pipeline/views/sub_pixel.hpp) takes them; 0: automatic
};

// What is measured has one sample, in the pixels' middles.
inline int samples_a_pixel(const Settings& settings) { return settings.samples > 0 ? settings.samples : 1; }

// Sets one `-D key=value`. Throws Error (WrongUsage) naming the key, its range and the nearest key.
void set_option(Settings& settings, std::string_view key, std::string_view value);
// Throws Error (WrongUsage) for the first setting that is out of its range. What must hold between settings
// is check's (pipeline/settings/check_settings.hpp).
void check_ranges(const Settings& settings);

// Grid vertices a side that one beam of light stands for, and beams a side.
int vertices_per_beam(const Settings& settings);
int beams_a_side(const Settings& settings);

// As set_option takes them.
std::string_view name_of(Estimator estimator);
std::string_view name_of(Thickness thickness);
std::string_view name_of(Splat splat);
std::string_view name_of(Interfaces interfaces);

}  // namespace caustics
