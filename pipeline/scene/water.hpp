// Water whose surface waves run over, stirred by plops at regular intervals (Shah, Konttinen, Pattanaik
// 2007, figure 8): what a scene says of it, and the grid that its waves are computed on. docs/water.md
// has the equations; passes/water_step computes them.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>

#include "pipeline/gpu/image.hpp"

namespace caustics {

struct Scene;

// What `extras` of a water mesh say. The ranges are checked by add_water.
struct WaterSettings {
  double speed = 0.5;            // metres a second, 0.001..100: how fast waves run, all of them
  double damping = 0.4;          // 1/second, 0..1000: a calm wave loses 1/e of its height in 2 / damping
  int cells = 256;               // 8..2048, along the sheet's x axis
  double start = 0.0;            // seconds, 0..3600: how long the plops have fallen at time 0
  double interval = 0.4;         // seconds from plop to plop, 0.01..1e4; the first falls after one interval
  std::optional<double> radius;  // metres, at least 3 cells; none: 1/20 of the sheet's shorter side
  std::optional<double> height;  // metres, 0..radius, of the largest plop; none: 1/5 of the radius
  std::uint64_t seed = 1;        // of the plops' places, sizes and signs
};

// A plop: a round bump that holds as much water above the level as below it.
struct Plop {
  glm::dvec2 centre{0.0};  // metres from the grid's corner
  double height = 0.0;     // metres, of its middle; negative is a dip
};

// A water surface: a nearly horizontal open sheet of triangles, and the grid over its bounding rectangle.
// Up is +y of the glTF world. Grid columns run along `right`, the node's x axis made horizontal, rows along
// `across`; cell (i, j) has its middle at corner + right (i + 1/2) dx + across (j + 1/2) dz.
struct Water {
  std::string name;
  int mesh = 0;  // index into Scene::meshes
  WaterSettings settings;
  double radius = 0.0, height = 0.0;                       // of plops, metres
  glm::dvec3 corner{0.0};                                  // scene space; its y does not count
  glm::dvec3 right{1.0, 0.0, 0.0}, across{0.0, 0.0, 1.0};  // unit, horizontal
  int columns = 0, rows = 0;
  double dx = 0.0, dz = 0.0;  // metres, of a cell
  // Seconds of a step: an interval holds a whole number of them, and speed * step / min(dx, dz) <= 1/2,
  // which keeps the explicit scheme stable in two dimensions (it needs 1 / sqrt 2).
  double step = 0.0;
  std::int64_t steps_per_plop = 1;  // from one plop to the next
  std::int64_t plop_steps = 1;      // over which a plop rises: about radius / speed
  // No vertex is moved farther from its rest than this, metres: the mesh's bounds hold its highest waves.
  double highest = 0.0;
  // The moment that the scene shows: RG32F columns x rows, (height m, its rate m/s) before the step of
  // this number, which was the last one.
  Image before{};
  std::int64_t last_step = 0;

  // Seconds since the water was at rest at a moment of the scene; moments before that are at rest.
  double since_rest(double seconds) const;
  // Steps to be made from rest until a moment is reached or just passed; at least 1.
  std::int64_t steps_until(double seconds) const;
  // The n-th plop, from 0. The same bits everywhere: integers and exact arithmetic only.
  Plop plop(std::int64_t n) const;
  // The plop that a step adds its part of, if any.
  std::optional<Plop> plop_in_step(std::int64_t step) const;
};

// What a water may cost at most.
struct WaterLimits {
  double cells = std::numeric_limits<double>::infinity();    // of its grid
  double updates = std::numeric_limits<double>::infinity();  // cells times the steps before time 0
  std::size_t triangles = std::size_t{1} << 20;              // that its mesh is split into
};

// Makes a mesh of the scene water: lays the grid, splits the mesh's triangles until their edges are no
// longer than a cell's diagonal (up to `limits.triangles`), and widens its bounds by its highest waves.
// `axis` is the direction along which `cells` are counted. Returns what forbids it, or "".
std::string add_water(Scene& scene, int mesh, const glm::dvec3& axis, const WaterSettings& settings,
                      const WaterLimits& limits = {});

}  // namespace caustics
