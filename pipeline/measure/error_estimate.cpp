#include "pipeline/measure/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/scene/in_pieces.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

namespace {

// Of the difference from texels of twice the side: bilinear interpolation errs by the square of the side
// (Richardson: 1 in 2^2 - 1).
constexpr double kOfTexels = 1.0 / 3.0;
// Of the difference from cells of half the number. A half would be of the first order, and a third of the
// second; texels even out most of what differs from cell to cell. This is what glass spheres measure
// (docs/accuracy.md).
constexpr double kOfGrid = 1.0 / 6.0;

// Of the light that cells have left to points, which lies in spots instead of between them. Metal rings
// measure it.
constexpr double kOfPoints = 0.5;
// Of the light that cells have left to footprints, as wide as its own differentials have it. Drinking glasses
// measure it.
constexpr double kOfFootprints = 0.125;

double sum_rgb(const ImageView& image, int x, int y) {
  if (image.channels() == 1) return 3.0 * static_cast<double>(image.at(x, y, 0));
  return static_cast<double>(image.at(x, y, 0)) + static_cast<double>(image.at(x, y, 1)) +
         static_cast<double>(image.at(x, y, 2));
}

TexelPlane plane_of(const ImageView& image) {
  TexelPlane plane(image.width());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) plane.at(x, y) = sum_rgb(image, x, y);
  return plane;
}

// map - the same from means of two by two texels, interpolated; of the texels that `counts`.
template <class Counts>
TexelPlane texel_error(const TexelPlane& map, Counts counts) {
  const int half = map.side() / 2;
  TexelPlane error(map.side());
  if (half < 1) return error;
  TexelPlane coarse(half);
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

double map_error(const ImageView& caustic_map, const ShownMaps& maps, const View& view, double pixel) {
  return texel_error(plane_of(caustic_map),
                     [&](int x, int y) {
                       if (view.cube) return view.cube->in_face(x, y, kBesideGuard);
                       return !maps.cascade_shows({x + 0.5, y + 0.5});
                     })
      .absolute_sum(glm::dvec2(pixel));
}

double cascade_error(const ImageView& cascade_map, const ShownMaps& maps, double pixel) {
  const double lowest = maps.border, highest = maps.side - maps.border;
  return texel_error(plane_of(cascade_map),
                     [&](int x, int y) {
                       return x + 0.5 >= lowest && y + 0.5 >= lowest && x + 0.5 <= highest &&
                              y + 0.5 <= highest;
                     })
      .absolute_sum(pixel * maps.scale);
}

struct Cell {
  glm::dvec2 middle{0.0};
  double area = 0.0, flux = 0.0;
  bool whole = false;
};

double triangle_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return 0.5 * std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

Cell cell_at(const CellImages& cells, const ImageView& flux, int x, int y) {
  if (!(flux.at(x, y, 3) == 1.0f)) return {};
  const auto corner = [&](const ImageView& image, int c) {
    return glm::dvec2(image.at(x, y, c), image.at(x, y, c + 1));
  };
  const glm::dvec2 a = corner(cells.near, 0), b = corner(cells.near, 2), c = corner(cells.far, 0),
                   d = corner(cells.far, 2);
  return {0.25 * (a + b + c + d), triangle_area(a, b, c) + triangle_area(d, c, b), sum_rgb(flux, x, y), true};
}

// Each block of two by two cells taken for one with even light: what each of the four has more or less than
// that. Of a grid in tiles, blocks of one face.
void compare_cells(const CellImages& cells, const ImageView& flux, const View& caster, ShownLight& moved) {
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

// Where the vertices' light lands, in texels of the caustic map.
class Landings {
 public:
  Landings(const ImageView& landing, const View& view, int map) : landing_(landing), view_(view), map_(map) {}
  std::optional<glm::dvec2> at(int x, int y) const {
    if (x < 0 || y < 0 || x >= landing_.width() || y >= landing_.height()) return {};
    if (!is_drawn(static_cast<LandingStatus>(landing_.at(x, y, 3)))) return {};
    const glm::dvec3 p{landing_.at(x, y, 0), landing_.at(x, y, 1), landing_.at(x, y, 2)};
    return (view_.window(view_.coordinates(p)) - view_.window_lower) /
           (view_.window_upper - view_.window_lower) * static_cast<double>(map_);
  }
  // The way from one vertex' landing to the next one's, along a row (dx = 1) or a column (dy = 1).
  std::optional<glm::dvec2> step(int x, int y, int dx, int dy) const {
    const std::optional<glm::dvec2> here = at(x, y), after = at(x + dx, y + dy), before = at(x - dx, y - dy);
    if (!here) return {};
    if (after && before) return 0.5 * (*after - *before);
    if (after) return *after - *here;
    return before ? std::optional(*here - *before) : std::nullopt;
  }

 private:
  const ImageView& landing_;
  const View& view_;
  int map_;
};

// Light as its splat lays it into the map.
void add_splat(const SplatKernel& kernel, const glm::dvec2& texel, double flux, ShownLight& light) {
  const int reach = static_cast<int>(std::ceil(kernel.radius));
  const auto share = [&](double from) { return reach ? kernel.share(from, from + 1.0) : 1.0; };
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      const glm::dvec2 corner = glm::floor(texel) + glm::dvec2(x, y), from = corner - texel;
      light.add(corner + 0.5, share(from.x) * share(from.y) * flux);
    }
}

// Light spread evenly over the parallelogram of sides u and v around a texel: by parts of a texel, up to so
// many along a side.
constexpr double kMostParts = 16.0;
void add_even(const glm::dvec2& texel, const glm::dvec2& u, const glm::dvec2& v, double flux,
              ShownLight& light) {
  const glm::dvec2 widest = glm::max(glm::abs(u), glm::abs(v));
  const double parts = std::clamp(std::ceil(std::max(widest.x, widest.y)), 1.0, kMostParts);
  for (double j = 0.5; j < parts; ++j)
    for (double i = 0.5; i < parts; ++i)
      light.add(texel + u * (i / parts - 0.5) + v * (j / parts - 0.5), flux / (parts * parts));
}

// What splats have laid around the landings, against the same light spread evenly between the landings.
void compare_splats(const BranchImages& images, const View& view, const SplatKernel& kernel, int map,
                    ShownLight& moved) {
  const Landings landings(images.landing, view, map);
  for (int y = 0; y < images.landing.height(); ++y)
    for (int x = 0; x < images.landing.width(); ++x) {
      const std::optional<glm::dvec2> u = landings.step(x, y, 1, 0), v = landings.step(x, y, 0, 1);
      if (!u || !v) continue;
      const glm::dvec2 texel = *landings.at(x, y);
      const double flux = sum_rgb(images.flux, x, y);
      add_splat(kernel, texel, flux, moved);
      add_even(texel, *u, *v, -flux, moved);
    }
}

bool in_cells(const BranchImages& images) { return !images.cell_flux.values.empty(); }

double total(const FluxRgb& flux) { return flux[0] + flux[1] + flux[2]; }

}  // namespace

void add(ErrorEstimate& sum, const ErrorEstimate& other, double share) {
  for (double ErrorEstimate::*part :
       {&ErrorEstimate::landed, &ErrorEstimate::map, &ErrorEstimate::grid, &ErrorEstimate::missing,
        &ErrorEstimate::model, &ErrorEstimate::sampling, &ErrorEstimate::not_followed})
    sum.*part += share * (other.*part);
  sum.judged = sum.judged || other.judged;
}

ErrorSum::ErrorSum(const LightViews& views, const Settings& settings, int map, bool has_cascade)
    : views_(views), settings_(settings), maps_(views, settings, map, has_cascade) {}

void ErrorSum::add(const BranchImages& images, const CellImages& cells) {
  if (in_cells(images)) {
    if (!cells_) cells_.emplace(maps_);
    compare_cells(cells, images.cell_flux, views_.caster, *cells_);
    if (images.branch.spread) {
      add_spread(images);
      return;
    }
    points_ += (images.footprint.values.empty() ? kOfPoints : kOfFootprints) * flux_of_points(images);
    return;
  }
  if (!splats_) splats_.emplace(maps_);
  if (!views_.caustic.cube)
    compare_splats(images, views_.caustic, splat_kernel(settings_), maps_.side, *splats_);
}

void ErrorSum::add_spread(const BranchImages& images) {
  if (!squares_) squares_.emplace(maps_);
  if (!areas_) areas_.emplace(maps_);
  const Landings landings(images.landing, views_.caustic, maps_.side);
  const double texels = static_cast<double>(maps_.side) * maps_.side;
  for (int y = 0; y < images.landing.height(); ++y)
    for (int x = 0; x < images.landing.width(); ++x) {
      const std::optional<glm::dvec2> texel = landings.at(x, y);
      if (!texel) continue;
      const auto side = [&](int c) { return static_cast<double>(images.footprint.at(x, y, c)); };
      const double flux = sum_rgb(images.flux, x, y);
      const double area = std::fabs(side(0) * side(3) - side(1) * side(2)) * texels;
      const double times = maps_.cascade_shows(*texel) ? maps_.scale.x * maps_.scale.y : 1.0;
      squares_->add(*texel, flux * flux);
      areas_->add(*texel, flux * flux * area * times);
    }
}

namespace {

// The mean difference of normally distributed light from its mean, in standard deviations: sqrt(2 / pi).
constexpr double kMeanDifference = 0.797884560802865;

// What vertices that fall by chance, each laid over its footprint, differ by from even light over boxes of so
// many texels.
double noise_of(TexelPlane squares, TexelPlane areas, const glm::dvec2& box) {
  squares.average(box);
  areas.average(box);
  const double judged = std::max(box.x, 1.0) * std::max(box.y, 1.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < squares.values().size(); ++i) {
    const double square = squares.values()[i];
    if (square > 0.0) sum += std::sqrt(square / (areas.values()[i] / square + judged));
  }
  return kMeanDifference * sum;
}

}  // namespace

double ErrorSum::grid_error(double pixel) {
  double error = 0.0;
  if (squares_)
    error = noise_of(std::move(squares_->map), std::move(areas_->map), glm::dvec2(pixel)) +
            noise_of(std::move(squares_->cascade), std::move(areas_->cascade), pixel * maps_.scale);
  if (cells_) error += kOfGrid * std::move(*cells_).sum(pixel);
  if (splats_) error += std::move(*splats_).sum(pixel);
  return error + points_;
}

ErrorEstimate ErrorSum::with_maps(const ImageView& caustic_map, const ImageView& cascade_map,
                                  const Ledger& ledger, double pixel) {
  ErrorEstimate estimate;
  if (views_.caustic.cube && splats_) return estimate;
  estimate.landed = total(ledger.in_map);
  estimate.missing = total(ledger.outside) + total(ledger.kernel_edge) + total(ledger.not_converged) +
                     total(ledger.exit_not_found) + total(ledger.given_up);
  double of_map = 0.0, of_cascade = 0.0, of_grid = 0.0;
  const std::function<void()> parts[] = {
      [&] { of_map = map_error(caustic_map, maps_, views_.caustic, pixel); },
      [&] { of_cascade = maps_.has_cascade ? cascade_error(cascade_map, maps_, pixel) : 0.0; },
      [&] { of_grid = grid_error(pixel); }};
  in_pieces(static_cast<int>(std::size(parts)), 0, [&](int part) { parts[part](); });
  estimate.map = kOfTexels * (of_map + of_cascade);
  estimate.grid = of_grid;
  return estimate;
}

ErrorEstimate estimate_error(const std::vector<BranchImages>& branches, const std::vector<CellImages>& cells,
                             const ImageView& caustic_map, const ImageView& cascade_map,
                             const LightViews& views, const Settings& settings, const Ledger& ledger,
                             double pixel) {
  ErrorSum sum(views, settings, caustic_map.width(), !cascade_map.values.empty());
  for (std::size_t b = 0; b < branches.size(); ++b) sum.add(branches[b], cells[b]);
  return sum.with_maps(caustic_map, cascade_map, ledger, pixel);
}

}  // namespace caustics
