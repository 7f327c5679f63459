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

// Whether a frame holds a texture, and the texture, by its full name.
using HasTexture = std::function<bool(const std::string&)>;
using ReadTexture = std::function<ImageView(const std::string&)>;

// What a branch's passes hold; what the search on the farthest receivers found stands in the place of what
// had not landed before.
BranchImages images_of_branch(int light, const Branch& branch, const HasTexture& has,
                              const ReadTexture& read);
// Those of the farthest receivers among them.
CellImages cells_of_branch(int light, const Branch& branch, const HasTexture& has, const ReadTexture& read);

// The same of all of a light's branches.
std::vector<BranchImages> branch_images(int light, const std::vector<Branch>& branches, const HasTexture& has,
                                        const ReadTexture& read);
std::vector<CellImages> cell_images(int light, const std::vector<Branch>& branches, const HasTexture& has,
                                    const ReadTexture& read);

// The names of the textures that a light's ledger, its outcomes and its error are made from.
std::vector<std::string> ledger_textures();
inline constexpr char kViewPosition[] = "view_position";

// The share of a grid vertex's flux that is splatted by itself: what no cell around it has taken. 1 where
// landings are not joined to cells: `cell_flux` without values.
double share_of_points(const ImageView& cell_flux, int x, int y);

}  // namespace caustics
