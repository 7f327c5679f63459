#include "pipeline/measure/landing_survey.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/measure/ledger.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// A cell of four neighbouring landings.
struct Quad {
  int landed = 0;  // of its vertices
  glm::dvec3 middle{0.0};
  double area = 0.0;     // window units squared, negative where the landings are turned over
  double longest = 0.0;  // side, window units
  double flux = 0.0;
  Window window;
  bool whole() const { return landed == 4; }
};

Quad quad_at(const Image& landing, const Image& flux, const View& view, int x, int y) {
  Quad cell;
  glm::dvec2 corners[4];
  for (int i = 0; i < 4; ++i) {
    const int column = x + i % 2, row = y + i / 2;
    if (!is_drawn(static_cast<LandingStatus>(static_cast<int>(landing.at(column, row, 3))))) continue;
    ++cell.landed;
    const glm::dvec3 p{landing.at(column, row, 0), landing.at(column, row, 1), landing.at(column, row, 2)};
    cell.middle += 0.25 * p;
    corners[i] = view.window(view.coordinates(p));
    for (int c = 0; c < 3; ++c) cell.flux += 0.25 * static_cast<double>(flux.at(column, row, c));
  }
  if (!cell.whole()) return cell;
  cell.window = {corners[0], corners[0]};
  for (const glm::dvec2& corner : corners) {
    cell.window.lower = glm::min(cell.window.lower, corner);
    cell.window.upper = glm::max(cell.window.upper, corner);
  }
  const glm::dvec2 across = corners[3] - corners[0], against = corners[2] - corners[1];
  cell.area = 0.5 * (across.x * against.y - across.y * against.x);
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 3), std::pair(3, 2), std::pair(2, 0)}) {
    const glm::dvec2 side = corners[b] - corners[a];
    cell.longest = std::max(cell.longest, std::sqrt(side.x * side.x + side.y * side.y));
  }
  return cell;
}

void add_edge(const Quad& a, const Quad& b, LandingSurvey& found) {
  if (a.whole() && b.whole() && a.area * b.area < 0.0) {
    const double longest = std::max({a.longest, b.longest, 1e-30});
    found.edges.push_back({.at = 0.5 * (a.middle + b.middle),
                           .flux = a.flux + b.flux,
                           .width = 0.5 * (std::fabs(a.area) + std::fabs(b.area)) / longest,
                           .fold = true});
  } else if (a.whole() != b.whole()) {
    const Quad& lit = a.whole() ? a : b;
    found.edges.push_back(
        {.at = lit.middle, .flux = lit.flux, .width = std::sqrt(std::fabs(lit.area)), .fold = false});
  }
}

bool sees(const View& camera, const glm::dvec3& q) {
  if (!(q.z > camera.near) || q.z > camera.far) return false;
  return Window{camera.window_lower, camera.window_upper}.holds(camera.window(q));
}

// The share of the light within a pixel of the edge that a map of `texels` texels a pixel puts on other
// pixels: fitted to one-dimensional edges at random places, from 1 to 6.3 texels.
double misplaced(bool fold, double texels) {
  return std::min(1.0, fold ? 0.28 / (texels * std::sqrt(std::sqrt(texels))) : 0.165 / (texels * texels));
}

}  // namespace

void LandingSurvey::add(const LandingSurvey& branch) {
  grid = branch.grid;
  branches += branch.branches;
  edges.insert(edges.end(), branch.edges.begin(), branch.edges.end());
  cells.insert(cells.end(), branch.cells.begin(), branch.cells.end());
  flux += branch.flux;
}

LandingSurvey survey_landings(const Image& landing, const Image& flux, const View& caustic) {
  LandingSurvey found;
  found.grid = landing.width();
  found.branches = 1;
  const int columns = landing.width() - 1, rows = landing.height() - 1;
  std::vector<Quad> below(static_cast<std::size_t>(std::max(columns, 0)));
  for (int y = 0; y < rows; ++y) {
    Quad before;
    for (int x = 0; x < columns; ++x) {
      const Quad cell = quad_at(landing, flux, caustic, x, y);
      found.flux += cell.flux;
      if (cell.whole()) found.cells.push_back(cell.window);
      if (x > 0) add_edge(before, cell, found);
      if (y > 0) add_edge(below[static_cast<std::size_t>(x)], cell, found);
      before = below[static_cast<std::size_t>(x)] = cell;
    }
  }
  return found;
}

double blurred_share(const LandingSurvey& survey, const LightViews& views, const View& camera,
                     int pixels_a_row, int map) {
  if (!(survey.flux > 0.0)) return 0.0;
  const double of_camera = (camera.window_upper.x - camera.window_lower.x) / pixels_a_row;
  double sum = 0.0;
  for (const CausticEdge& edge : survey.edges) {
    const glm::dvec3 seen = camera.coordinates(edge.at), lit = views.caustic.coordinates(edge.at);
    if (!sees(camera, seen)) continue;
    const double pixel =
        of_camera * (camera.perspective ? seen.z : 1.0) / (views.caustic.perspective ? lit.z : 1.0);
    const bool finer =
        views.cascade &&
        Window{views.cascade->window_lower, views.cascade->window_upper}.holds(views.cascade->window(lit));
    const View& view = finer ? *views.cascade : views.caustic;
    const double texel = std::sqrt(view.window_area()) / map;
    if (!(pixel > 0.0) || !(texel > 0.0)) continue;
    const double share = std::min(1.0, pixel / std::max(edge.width, 1e-30));
    sum += edge.flux * (edge.fold ? std::sqrt(share) : share) * misplaced(edge.fold, pixel / texel);
  }
  return std::min(sum / survey.flux, 1.0);
}

double covered_texels(const LandingSurvey& survey, const View& view, int grid, int map) {
  const double finer = std::max(1.0, static_cast<double>(grid) / std::max(survey.grid, 1));
  const glm::dvec2 texels = static_cast<double>(map) / (view.window_upper - view.window_lower);
  double sum = 0.0;
  for (const Window& cell : survey.cells) {
    if (cell.upper.x < view.window_lower.x || cell.upper.y < view.window_lower.y ||
        cell.lower.x > view.window_upper.x || cell.lower.y > view.window_upper.y)
      continue;
    // A cell of this grid is that much shorter, and touches a texel more than it is long.
    const glm::dvec2 size = glm::min((cell.upper - cell.lower) * texels, glm::dvec2(map));
    const double side = std::max(size.x, size.y) + finer;
    sum += side * side;
  }
  return sum;
}

}  // namespace caustics
