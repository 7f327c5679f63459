// What the landing passes of a light hold, read back: the ledger, the error estimate and the reports start
// from it.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "pipeline/effects/effects.hpp"
#include "pipeline/gpu/image_view.hpp"
#include "pipeline/plan/pass.hpp"

namespace caustics {

// Where cells lie: the textures of the `cells` pass, without values where landings are splatted one by one.
struct CellImages {
  ImageView near, far;
};

// What one branch's passes hold.
struct BranchImages {
  Branch branch;
  ImageView landing, flux, fresnel, absorbed;
  ImageView cell_flux;  // without values where landings are splatted one by one
  ImageView medium;     // without values where there is no medium
  ImageView footprint;  // likewise where light is not followed from surface to surface
};

// What a light's passes hold, of all its branches; what the search on the farthest receivers found stands in
// the place of what had not landed before; `read` gives a texture by its full name, and `has` tells whether
// the frame holds it.
std::vector<BranchImages> branch_images(int light, const std::vector<Branch>& branches,
                                        const std::function<bool(const std::string&)>& has,
                                        const std::function<ImageView(const std::string&)>& read);

// By branch; those of the farthest receivers among them. `has` and `read` as for branch_images.
std::vector<CellImages> cell_images(int light, const std::vector<Branch>& branches,
                                    const std::function<bool(const std::string&)>& has,
                                    const std::function<ImageView(const std::string&)>& read);

// The share of a grid vertex's flux that is splatted by itself: what no cell around it has taken. 1 where
// landings are not joined to cells: `cell_flux` without values.
double share_of_points(const ImageView& cell_flux, int x, int y);

}  // namespace caustics
