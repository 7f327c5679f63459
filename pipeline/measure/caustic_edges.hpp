// The sharp edges of a light's caustic, and how much of its light a map of a given resolution blurs over them
// as a picture shows it. For sizes of maps that are chosen for the picture.
#pragma once
#include <vector>

#include "pipeline/gpu/image.hpp"
#include "pipeline/scene/view.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

// A piece of an edge between two grid cells, of which one holds light and the other none, or which overlie
// each other.
struct CausticEdge {
  glm::dvec3 at{0.0};  // scene space
  double flux = 0.0;   // of the cells beside it, in any unit
  double width = 0.0;  // of a cell's landing across the edge, window units of the light's views
  bool fold = false;   // brightest at the edge, as one over the square root of the distance; else a step
};

struct CausticEdges {
  std::vector<CausticEdge> edges;
  double flux = 0.0;  // of all cells, in the same unit
  void add(const CausticEdges& other);
};

// From a grid of landings and their flux, as the pass `landing` writes them.
CausticEdges caustic_edges(const Image& landing, const Image& flux, const View& caustic);

// The share of the light that the camera sees on other pixels than full resolution would put it on, by a map
// of `map` texels a side, 0..1.
double blurred_share(const CausticEdges& edges, const LightViews& views, const View& camera, int pixels_a_row,
                     int map);

}  // namespace caustics
