#include "pipeline/measure/error_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

namespace {

// Of the difference from texels of twice the side: bilinear interpolation errs by the square of the side
// (Richardson: 1 in 2^2 - 1).
constexpr double kOfTexels = 1.0 / 3.0;
// Of the difference from cells, or splats, of half the number. A half would be of the first order, and a
// third of the second; texels even out most of what differs from cell to cell. This is what glass spheres
// measure (docs/accuracy.md).
constexpr double kOfGrid = 1.0 / 6.0;

// Of the light that cells have left to points, which lies in spots instead of between them. Metal rings
// measure it.
constexpr double kOfPoints = 0.5;

double sum_rgb(const Image& image, int x, int y) {
  if (image.channels() == 1) return 3.0 * static_cast<double>(image.at(x, y, 0));
  return static_cast<double>(image.at(x, y, 0)) + static_cast<double>(image.at(x, y, 1)) +
         static_cast<double>(image.at(x, y, 2));
}

// One value a texel, in double precision.
class Plane {
 public:
  explicit Plane(int side)
      : side_(side), values_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {}
  int side() const { return side_; }
  double& at(int x, int y) { return values_[index(x, y)]; }
  double at(int x, int y) const { return values_[index(x, y)]; }
  double clamped(int x, int y) const { return at(std::clamp(x, 0, side_ - 1), std::clamp(y, 0, side_ - 1)); }
  void add(const glm::dvec2& texel, double value) {
    const int x = static_cast<int>(std::floor(texel.x)), y = static_cast<int>(std::floor(texel.y));
    if (x >= 0 && y >= 0 && x < side_ && y < side_) at(x, y) += value;
  }
  // Sum of |mean over a box around each texel|; boxes of these sides, texels, and not below one.
  double absolute_sum(const glm::dvec2& box) const {
    const Plane averaged = along(std::max(box.x, 1.0), 1, 0).along(std::max(box.y, 1.0), 0, 1);
    double sum = 0.0;
    for (const double v : averaged.values_) sum += std::fabs(v);
    return sum;
  }

 private:
  // Means over `side` texels along an axis, by running sums; the outermost texels of a box count by the share
  // that lies in it, and beyond the map there is nothing.
  Plane along(double side, int dx, int dy) const {
    if (side <= 1.0) return *this;
    Plane result(side_);
    std::vector<double> sums(static_cast<std::size_t>(side_) + 1);
    const double box = std::min(side, 2.0 * side_);
    for (int line = 0; line < side_; ++line) {
      const auto value = [&](int k) { return at(dx ? k : line, dy ? k : line); };
      for (int k = 0; k < side_; ++k)
        sums[static_cast<std::size_t>(k) + 1] = sums[static_cast<std::size_t>(k)] + value(k);
      const auto up_to = [&](double t) {
        const double inside = std::clamp(t, 0.0, static_cast<double>(side_));
        const int whole = std::min(static_cast<int>(inside), side_ - 1);
        return sums[static_cast<std::size_t>(whole)] + (inside - whole) * value(whole);
      };
      for (int k = 0; k < side_; ++k)
        result.at(dx ? k : line, dy ? k : line) =
            (up_to(k + 0.5 + 0.5 * box) - up_to(k + 0.5 - 0.5 * box)) / side;
    }
    return result;
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }
  int side_;
  std::vector<double> values_;
};

Plane plane_of(const Image& image) {
  Plane plane(image.width());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) plane.at(x, y) = sum_rgb(image, x, y);
  return plane;
}

// The maps of a light as shading looks them up: the cascade where it reaches, else the caustic map.
struct Maps {
  int side = 0;
  bool has_cascade = false;
  glm::dvec2 scale{1.0}, offset{0.0};  // from the caustic map's texels to the cascade's
  double border = 0.0;                 // of the cascade, not looked up, texels

  Maps(const LightViews& views, const Settings& settings, int map_side, bool cascade)
      : side(map_side), has_cascade(cascade && views.cascade) {
    if (!has_cascade) return;
    const glm::dvec2 whole = views.caustic.window_upper - views.caustic.window_lower;
    const glm::dvec2 part = views.cascade->window_upper - views.cascade->window_lower;
    scale = whole / part;
    offset = (views.caustic.window_lower - views.cascade->window_lower) / part * static_cast<double>(side);
    border = splat_kernel(settings).radius + 1.0;
  }
  glm::dvec2 in_cascade(const glm::dvec2& texel) const { return texel * scale + offset; }
  bool cascade_shows(const glm::dvec2& texel) const {
    if (!has_cascade) return false;
    const glm::dvec2 p = in_cascade(texel);
    return std::min(p.x, p.y) >= border && std::max(p.x, p.y) <= static_cast<double>(side) - border;
  }
};

// map - the same from means of two by two texels, interpolated; of the texels that `counts`.
template <class Counts>
Plane texel_error(const Plane& map, Counts counts) {
  const int half = map.side() / 2;
  Plane error(map.side());
  if (half < 1) return error;
  Plane coarse(half);
  for (int y = 0; y < half; ++y)
    for (int x = 0; x < half; ++x)
      coarse.at(x, y) = 0.25 * (map.at(2 * x, 2 * y) + map.at(2 * x + 1, 2 * y) + map.at(2 * x, 2 * y + 1) +
                                map.at(2 * x + 1, 2 * y + 1));
  for (int y = 0; y < map.side(); ++y)
    for (int x = 0; x < map.side(); ++x) {
      if (!counts(x, y)) continue;
      // A fine texel's centre lies a quarter of a coarse one from the nearer centre.
      const int x0 = x / 2, y0 = y / 2, x1 = x0 + (x % 2 ? 1 : -1), y1 = y0 + (y % 2 ? 1 : -1);
      const double shown = (9.0 * coarse.clamped(x0, y0) + 3.0 * coarse.clamped(x1, y0) +
                            3.0 * coarse.clamped(x0, y1) + coarse.clamped(x1, y1)) /
                           16.0;
      error.at(x, y) = map.at(x, y) - shown;
    }
  return error;
}

// A tile's guard is not shown, and what two texels of a face's edge are interpolated from lies in part in it.
constexpr int kBesideGuard = 2;

double map_error(const Image& caustic_map, const Image& cascade_map, const Maps& maps, const View& view,
                 double pixel) {
  double sum = texel_error(plane_of(caustic_map), [&](int x, int y) {
                 if (view.cube) return view.cube->in_face(x, y, kBesideGuard);
                 return !maps.cascade_shows({x + 0.5, y + 0.5});
               }).absolute_sum(glm::dvec2(pixel));
  if (maps.has_cascade) {
    const double lowest = maps.border, highest = maps.side - maps.border;
    sum += texel_error(plane_of(cascade_map), [&](int x, int y) {
             return x + 0.5 >= lowest && y + 0.5 >= lowest && x + 0.5 <= highest && y + 0.5 <= highest;
           }).absolute_sum(pixel * maps.scale);
  }
  return sum;
}

// What is moved from one place to another, gathered in the texels where it is shown.
struct Moved {
  Plane map, cascade;
  const Maps& maps;
  explicit Moved(const Maps& m) : map(m.side), cascade(m.has_cascade ? m.side : 0), maps(m) {}
  void add(const glm::dvec2& texel, double flux) {
    if (maps.cascade_shows(texel)) {
      cascade.add(maps.in_cascade(texel), flux);
    } else {
      map.add(texel, flux);
    }
  }
  double sum(double pixel) const {
    return map.absolute_sum(glm::dvec2(pixel)) + cascade.absolute_sum(pixel * maps.scale);
  }
};

struct Cell {
  glm::dvec2 middle{0.0};
  double area = 0.0, flux = 0.0;
  bool whole = false;
};

double triangle_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return 0.5 * std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

Cell cell_at(const CellImages& cells, const Image& flux, int x, int y) {
  if (!(flux.at(x, y, 3) == 1.0f)) return {};
  const auto corner = [&](const Image& image, int c) {
    return glm::dvec2(image.at(x, y, c), image.at(x, y, c + 1));
  };
  const glm::dvec2 a = corner(cells.near, 0), b = corner(cells.near, 2), c = corner(cells.far, 0),
                   d = corner(cells.far, 2);
  return {0.25 * (a + b + c + d), triangle_area(a, b, c) + triangle_area(d, c, b), sum_rgb(flux, x, y), true};
}

// Each block of two by two cells taken for one with even light: what each of the four has more or less than
// that. Of a grid in tiles, blocks of one face.
void compare_cells(const CellImages& cells, const Image& flux, const View& caster, Moved& moved) {
  for (int y = 0; y + 2 < flux.height(); y += 2)
    for (int x = 0; x + 2 < flux.width(); x += 2) {
      if (caster.cube && !(caster.cube->in_face(x, y) && caster.cube->in_face(x + 2, y + 2))) continue;
      const Cell four[] = {cell_at(cells, flux, x, y), cell_at(cells, flux, x + 1, y),
                           cell_at(cells, flux, x, y + 1), cell_at(cells, flux, x + 1, y + 1)};
      double area = 0.0, light = 0.0;
      bool whole = true;
      for (const Cell& cell : four) {
        whole = whole && cell.whole;
        area += cell.area;
        light += cell.flux;
      }
      if (!whole || !(area > 0.0)) continue;
      for (const Cell& cell : four) moved.add(cell.middle, cell.flux - light * cell.area / area);
    }
}

// Flux of landings that no cell has taken.
double flux_of_points(const BranchImages& images) {
  double sum = 0.0;
  for (int y = 0; y < images.landing.height(); ++y)
    for (int x = 0; x < images.landing.width(); ++x)
      if (is_drawn(static_cast<LandingStatus>(images.landing.at(x, y, 3))))
        sum += share_of_points(images.cell_flux, x, y) * sum_rgb(images.flux, x, y);
  return sum;
}

// Landings of every other vertex, like the fields of a chessboard, against the rest.
void compare_splats(const BranchImages& images, const View& view, int map, Moved& moved) {
  for (int y = 0; y < images.landing.height(); ++y)
    for (int x = 0; x < images.landing.width(); ++x) {
      if (!is_drawn(static_cast<LandingStatus>(images.landing.at(x, y, 3)))) continue;
      const glm::dvec3 p{images.landing.at(x, y, 0), images.landing.at(x, y, 1), images.landing.at(x, y, 2)};
      const glm::dvec2 texel = (view.window(view.coordinates(p)) - view.window_lower) /
                               (view.window_upper - view.window_lower) * static_cast<double>(map);
      moved.add(texel, ((x + y) % 2 ? -1.0 : 1.0) * sum_rgb(images.flux, x, y));
    }
}

double total(const FluxRgb& flux) { return flux[0] + flux[1] + flux[2]; }

}  // namespace

void add(ErrorEstimate& sum, const ErrorEstimate& other, double share) {
  for (double ErrorEstimate::*part :
       {&ErrorEstimate::landed, &ErrorEstimate::map, &ErrorEstimate::grid, &ErrorEstimate::missing,
        &ErrorEstimate::model, &ErrorEstimate::sampling, &ErrorEstimate::not_followed})
    sum.*part += share * (other.*part);
  sum.judged = sum.judged || other.judged;
}

ErrorEstimate estimate_error(const std::vector<BranchImages>& branches, const std::vector<CellImages>& cells,
                             const Image& caustic_map, const Image& cascade_map, const LightViews& views,
                             const Settings& settings, const Ledger& ledger, double pixel) {
  ErrorEstimate estimate;
  const bool spots = std::any_of(branches.begin(), branches.end(),
                                 [](const BranchImages& images) { return images.cell_flux.values.empty(); });
  if (views.caustic.cube && spots) return estimate;
  const Maps maps(views, settings, caustic_map.width(), !cascade_map.values.empty());
  estimate.landed = total(ledger.in_map);
  estimate.map = kOfTexels * map_error(caustic_map, cascade_map, maps, views.caustic, pixel);
  estimate.missing = total(ledger.outside) + total(ledger.kernel_edge) + total(ledger.not_converged) +
                     total(ledger.exit_not_found);
  Moved moved(maps);
  double points = 0.0;
  for (std::size_t b = 0; b < branches.size(); ++b) {
    if (branches[b].cell_flux.values.empty()) {
      compare_splats(branches[b], views.caustic, maps.side, moved);
    } else {
      compare_cells(cells[b], branches[b].cell_flux, views.caster, moved);
      points += flux_of_points(branches[b]);
    }
  }
  estimate.grid = kOfGrid * moved.sum(pixel) + kOfPoints * points;
  return estimate;
}

}  // namespace caustics
