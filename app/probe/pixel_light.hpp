// Where a pixel of the picture gets its light: of each light directly and by its caustics, the texels of the
// caustic maps that it reads, and the primitives that put light there.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/frame.hpp"
#include "app/probe/probe_texel.hpp"
#include "app/shell/parser.hpp"

namespace caustics::app {

// The caustic maps among what light_shading reads, by their numbers: the whole map, the cascade, the map of
// the farthest receivers.
inline constexpr const char* kCausticMaps[] = {"caustic_map", "cascade_map", "far_caustic_map"};

// A bilinear look-up of a caustic map that gave a pixel light.
struct MapFetch {
  int map = 0;               // of kCausticMaps
  float u = 0.0f, v = 0.0f;  // where in the map, 0..1
  float share = 0.0f;        // of what is found there, that counts
  float per_flux = 0.0f;     // irradiance that each unit of it gives, 1 / m2 or 1 / sr
};
struct PixelFetches {
  std::vector<MapFetch> fetches{};
  int samples = 0;  // of the pixel, whose mean it is; those without light too
};

// Puts them together from what light_shading's text hands out of a pixel, in order.
class FetchReader {
 public:
  void read(std::string_view label, const float* values);
  PixelFetches take();  // and begins with the next pixel

 private:
  PixelFetches found_;
  std::vector<MapFetch> at_;  // those that the next irradiance comes from
  int map_ = 0;
  float per_flux_ = 0.0f;
};

// A texel of a caustic map that a pixel reads.
struct MapTexel {
  int map;        // of kCausticMaps
  int texture;    // index into FramePlan::textures
  int x, y;       // from the left and the bottom
  double weight;  // irradiance that the pixel has of each unit of the texel's flux, 1 / m2 or 1 / sr
};

// A cell or a vertex of the grid that put light on those texels.
struct Contribution {
  std::string pass;    // its label
  std::string kind;    // "cell": of vertices x, y to x + 1, y + 1; else "vertex"
  int x = 0, y = 0;    // of the grid, from the left and the bottom
  double share = 0.0;  // of the pixel's caustic light of this light
};

struct LightOnPixel {
  int light = 0;                              // index into Scene::lights
  std::array<float, 3> direct{}, caustic{};   // lux, as light_shading gives them
  std::vector<MapTexel> texels{};             // those that count; by map, row, column
  std::vector<Contribution> contributions{};  // largest first
  double explained = 0.0;                     // what the texels' light is of `caustic`: 1 but for rounding
  double accounted = 0.0;  // what the contributions' light is of the texels': 1 but for rounding
  bool agrees = true;      // recomputed and rendered are the same bits
};

// The texels around all fetches of a pixel, by map, row and column. The page of `inspect` has these steps a
// second time, in the same arithmetic: texelsOfFetches of light_links.js.
std::vector<MapTexel> map_texels(const RenderedFrame& frame, const PlannedPass& light_shading,
                                 const PixelFetches& pixel);

// Is this the pass that gives the picture one light's light?
bool shades_picture(const PlannedPass& pass);

// Draws the frame twice: the maps' texels are known when the first is done. Pixels from the left and the
// bottom. Of each one all lights, those that give it nothing too.
std::vector<std::vector<LightOnPixel>> light_on_pixels(RenderedFrame& frame, const std::vector<Pair>& pixels);

}  // namespace caustics::app
