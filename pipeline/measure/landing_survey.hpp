// What a coarse grid of landings tells of a light's caustic before it is drawn: how sharp its edges are, and
// how many texels of a map its cells will cover. For sizes that are chosen for a picture.
#pragma once
#include <vector>

#include "pipeline/gpu/image.hpp"
#include "pipeline/scene/view.hpp"
#include "pipeline/views/landing_window.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

// A piece of an edge between two cells, of which one holds light and the other none, or which overlie each
// other.
struct CausticEdge {
  glm::dvec3 at{0.0};  // scene space
  double flux = 0.0;   // of the cells beside it, in any unit
  double width = 0.0;  // of a cell's landing across the edge, window units of the light's views
  bool fold = false;   // brightest at the edge, as one over the square root of the distance; else a step
};

struct LandingSurvey {
  int grid = 0;      // vertices a side
  int branches = 0;  // grids that are added up here
  std::vector<CausticEdge> edges;
  std::vector<Window> cells;  // the landings of each: the smallest window around them
  double flux = 0.0;          // of all cells, in the unit of the edges
  void add(const LandingSurvey& branch);
};

// Of the images that the pass `landing` writes.
LandingSurvey survey_landings(const Image& landing, const Image& flux, const View& caustic);

// The share of a light that a map of `map` texels a side shows on other pixels than full resolution would,
// 0..1, of what the camera sees.
double blurred_share(const LandingSurvey& survey, const LightViews& views, const View& camera,
                     int pixels_a_row, int map);

// Texels that the squares of a grid's cells cover in a map of the view, all counted, as caustic_cells lays
// them.
double covered_texels(const LandingSurvey& survey, const View& view, int grid, int map);

}  // namespace caustics
