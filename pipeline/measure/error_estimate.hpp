// How far a light's caustic may be from the truth, told from the frame itself (docs/accuracy.md).
#pragma once
#include <optional>
#include <vector>

#include "pipeline/effects/effects.hpp"
#include "pipeline/gpu/image_view.hpp"
#include "pipeline/measure/ledger.hpp"
#include "pipeline/measure/shown_light.hpp"
#include "pipeline/plan/pass.hpp"

namespace caustics {

// Light in wrong places: the integral of |irradiance - truth|, both averaged over a picture's pixels, over
// what receives it, in the ledger's unit of flux and summed over the three channels. Each part compares the
// frame with a coarser one, or with even light, made from its own textures.
struct ErrorEstimate {
  double landed = 0.0;  // all flux in the map; once `judged`, all that light itself lands
  double map = 0.0;     // by the size of the maps' texels: against texels of twice the side
  double grid = 0.0;  // by the grid's spacing: against cells of twice the side; splats, and light that cells
                      // have left in spots, against even light; light that microfacets spread by the noise of
                      // its vertices
  double missing = 0.0;  // landed beyond the map, or not followed to its landing
  // What rays through the scene's triangles have shown (model_error.hpp), where they were asked for.
  bool judged = false;
  double model = 0.0;         // by the model: light that goes other ways than the passes take it
  double sampling = 0.0;      // how far `model` may be off, as it comes from few rays
  double not_followed = 0.0;  // flux that lands by other ways, in the right place or not
  // Relative L1 of the caustic's irradiance; 0 where nothing landed.
  double relative(double part) const { return landed > 0.0 ? part / landed : 0.0; }
  double total() const { return relative(map + grid + missing + model); }
};

// Adds another estimate `share` times: a light's samples to the light's own. Errors of several are taken to
// add up.
void add(ErrorEstimate& sum, const ErrorEstimate& other, double share);

// Of one light, branch by branch, so that no more than one branch's images need be there. Of lights that see
// all around only cells are judged: landed is 0 where their landings are splatted one by one.
class ErrorSum {
 public:
  // Maps of `map` texels a side, with a cascade or without. Views and settings must outlive it.
  ErrorSum(const LightViews& views, const Settings& settings, int map, bool has_cascade);
  void add(const BranchImages& images, const CellImages& cells);
  // Once, at the end. `pixel` is a pixel's side in texels of the caustic map (pixel_side.hpp), 1 or less
  // where the maps' own texels are judged; `cascade_map` without values where the light has none.
  ErrorEstimate with_maps(const ImageView& caustic_map, const ImageView& cascade_map, const Ledger& ledger,
                          double pixel);

 private:
  void add_spread(const BranchImages& images);
  double grid_error(double pixel);

  const LightViews& views_;
  const Settings& settings_;
  ShownMaps maps_;
  std::optional<ShownLight> cells_, splats_;  // in wrong places; none of the kind at first
  // Of vertices whose microfacets are drawn: the squares of their flux, and these times their footprints'
  // areas in texels of the map that shows them.
  std::optional<ShownLight> squares_, areas_;
  double points_ = 0.0;
};

// The same of all branches at once; `cells` by branch.
ErrorEstimate estimate_error(const std::vector<BranchImages>& branches, const std::vector<CellImages>& cells,
                             const ImageView& caustic_map, const ImageView& cascade_map,
                             const LightViews& views, const Settings& settings, const Ledger& ledger,
                             double pixel);

}  // namespace caustics
