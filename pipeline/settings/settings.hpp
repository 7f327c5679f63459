// How a frame is rendered: the command line's choices, with the documented defaults.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace caustics {

// What finds where a ray meets a height map (docs: passes/landing/landing.md).
enum class Estimator : std::uint8_t { Paper, Secant, Newton, Impostor };
// How a landing becomes light in the caustic map.
enum class Splat : std::uint8_t { Point, Gaussian, Cell };
enum class Weights : std::uint8_t { Physical, Paper };
// What tells how far light goes inside a solid caster: its back's map, or Wyman's (2005) mean of two thicknesses.
enum class Thickness : std::uint8_t { Map, Wyman };
// Which lights with a position are drawn onto a cube instead of through a window (pipeline/scene/cube_view.hpp).
enum class Cube : std::uint8_t { Auto, On, Off };
enum class Interfaces : std::uint8_t { Auto, One, Two };

struct Settings {
  int width = 1280, height = 720;  // picture
  int grid = 512;                  // grid vertices a side
  int map = 512;                   // caustic and receiver map, texels a side
  int shadow = 2048;               // shadow map, texels a side
  int light_samples = 16;          // points by which a light with a size is drawn
  bool emissive_lights = false;    // meshes that shine light the scene
  int shafts = 128;                // beams a side by which light shafts are drawn; at most the grid
  int medium_steps = 32;           // along each camera ray through a medium
  int iterations = 5;
  Estimator estimator = Estimator::Secant;
  Thickness thickness = Thickness::Map;
  Splat splat = Splat::Cell;
  float gaussian_sigma = 0.7f;  // texels of the caustic map; of Gaussian, and of what Cell leaves to points
  Interfaces interfaces = Interfaces::Auto;
  Weights weights = Weights::Physical;
  // Wavelengths of dispersing glass: 1 bends all colours alike, 3 are the C, d and F lines, 8 and more sample
  // the spectrum.
  int wavelengths = 3;
  bool reflections = false;  // light that glass and water mirror throws caustics too
  bool assume_solid = false;
  Cube cube = Cube::Auto;
  bool cascades = true;  // a light's caustic that is small in its map gets a finer second one
  bool hidden_receivers = true;  // light goes on to receivers that others hide from the light
  bool pixel_means = true;  // caustics are averaged over pixels that are wider than the map's texels
  // Caster, receiver and caustic map share the caster's window: for studies of the splat alone.
  bool shared_views = false;
  // Where a caustic's map is framed: this share of the landed flux may fall outside it.
  double outside_share = 4e-3;
  std::string camera;              // name or number; empty: the first
  std::optional<float> exposure;   // EV added to the scene's own; none: automatic
  float mirror_metallic = 0.5f, mirror_roughness = 0.2f;  // a mirror: at least, at most
  float glass_roughness = 0.2f;    // rougher glass throws no caustic
};

inline constexpr int kMaxPicture = 16384, kMaxGrid = 8192, kMaxMap = 8192, kMaxIterations = 1000,
                     kLeastSpectrum = 8, kMaxWavelengths = 64;
inline constexpr int kMaxLightSamples = 256;
inline constexpr int kMaxShafts = 1024, kMaxMediumSteps = 1024;

// Sets one `-D key=value`. Throws Error (WrongUsage) naming the key, its range and the nearest key.
// Keys: see settings.cpp's table, printed by setting_keys().
void set_option(Settings& settings, std::string_view key, std::string_view value);
// "key  range  meaning", one a line, for --help.
std::vector<std::string> setting_keys();
// Throws Error (WrongUsage) when a size or count lies outside its documented limits.
void check(const Settings& settings);
// Grid vertices a side that one beam of light stands for, and beams a side.
int vertices_per_beam(const Settings& settings);
int beams_a_side(const Settings& settings);

// Texels by which a tile of a cube's caustic map is wider than its face: room for splats, and for cells that
// reach over the face's edge.
int caustic_guard(const Settings& settings);
// "grid is 16, must be at least 48" where the maps have no room for six tiles, else empty.
std::string too_small_for_cubes(const Settings& settings);

std::string_view name_of(Estimator estimator);
std::string_view name_of(Thickness thickness);
std::string_view name_of(Splat splat);
std::string_view name_of(Weights weights);
std::string_view name_of(Interfaces interfaces);

}  // namespace caustics
