// The table of closed forms (docs/accuracy.md): every row renders a scene with the whole
// pipeline on a device, and says how far from the closed form it is and how far the method's
// resolution lets it be.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

namespace caustics::test {

struct Row {
  std::string truth;  // which closed form
  std::string what;   // which figure of it, and the unit where it is not a share
  double error = 0.0;
  double bound = 0.0;    // what grid, map, tessellation and single precision account for
  std::string settings;  // grid, map, tessellation
};
using Rows = std::vector<Row>;

// A device and the size at which a row is measured.
struct Bench {
  Device& device;
  Device& pilot;  // fits the light views, so that all devices see the same
  bool full = false;

  int maps() const { return full ? 512 : 256; }    // grid and map, a side
  int pixels() const { return full ? 256 : 128; }  // of the picture
  // The closed forms are of two surfaces.
  Settings settings() const { return through_two_surfaces(small_settings(maps(), maps(), pixels())); }
  Rendering render(const Scene& scene, const Settings& settings,
                   const std::vector<std::string>& textures) const {
    return render_on(device, scene, settings, textures, &pilot);
  }
};

std::string text_of(const Settings& settings);  // "grid = map 256"

// Extent of a caustic map's texel on a level floor, the larger side, metres. Directional lights.
double texel_on_floor(const Scene& scene, const Rendering& r, const Settings& settings);

// Sum of |a - b| over the sum of b.
double relative_l1(const std::vector<double>& a, const std::vector<double>& b);

// The most by which f differs from straight lines between points `step` apart.
template <typename F>
double linear_error(const F& f, double lower, double upper, double step) {
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double x = lower + (upper - step - lower) * i / 1000.0;
    worst = std::max(worst, std::fabs(f(x + 0.5 * step) - 0.5 * (f(x) + f(x + step))));
  }
  return worst;
}

// One rounding of single precision.
inline constexpr double kUlp = 1.1920928955078125e-7;

// Checks every row on the software device, and on OpenGL where there is one.
void check_rows(Rows (*rows)(const Bench&));

Rows sphere_rows(const Bench& bench);
Rows bubble_rows(const Bench& bench);
Rows ring_rows(const Bench& bench);
Rows water_rows(const Bench& bench);
Rows point_light_rows(const Bench& bench);
Rows slab_rows(const Bench& bench);
Rows prism_rows(const Bench& bench);
Rows interface_rows(const Bench& bench);
Rows imager_rows(const Bench& bench);

}  // namespace caustics::test
