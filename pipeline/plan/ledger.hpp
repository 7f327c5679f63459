// The flux ledger: where the light that entered a caster grid went.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/gpu/image.hpp"
#include "pipeline/plan/effects.hpp"
#include "pipeline/plan/pass.hpp"

namespace caustics {

// How a grid vertex ended; `landing`'s alpha channel holds the number.
enum class LandingStatus : std::uint8_t {
  Empty,            // no caster in this texel
  Landed,
  Missed,           // leaves the scene: no receiver on its way
  Outside,          // leaves the receiver or the caustic map
  TotalReflection,  // cannot leave the caster at its second surface
  Absorbed,         // less than a millionth is left
  NotConverged,     // the estimator did not close in on a receiver
};
inline constexpr int kLandingStatuses = 7;
std::string_view name_of(LandingStatus status);

using FluxRgb = std::array<double, 3>;

// One light's ledger, per colour channel. Flux is relative to the light's own intensity: square
// metres (lumen per lux) for directional lights, steradians (lumen per candela) for the others.
struct Ledger {
  FluxRgb entered{};             // onto the casters
  FluxRgb fresnel{};             // reflected at the surfaces
  FluxRgb absorbed{};            // in the material, and what ended as Absorbed
  FluxRgb total_reflection{};
  FluxRgb medium{};              // absorbed and scattered by the medium, before and after the casters
  FluxRgb missed{};
  FluxRgb outside{};
  FluxRgb not_converged{};
  FluxRgb kernel_edge{};         // parts of splats beyond the map's edge
  FluxRgb in_map{};              // the sum over the caustic map
  // (entered - everything else) / entered, the largest of the channels; 0 for an empty grid. What
  // remains is the rounding of the map's sums.
  double residual() const;
  std::array<std::uint64_t, kLandingStatuses> vertices{};  // by LandingStatus
};

// Adds another ledger, each of its fluxes times `share`: the samples of one light to the light's own.
void add(Ledger& sum, const Ledger& other, double share);

// What one branch's passes hold.
struct BranchImages {
  Branch branch;
  Image landing, flux, fresnel, absorbed;
  Image cell_flux;  // without values where landings are splatted one by one
  Image medium;     // without values where there is no medium
};

// What a light's passes hold, of all its branches; what the search on the farthest receivers found stands in the place
// of what had not landed before; `read` gives a texture by its full name, and `has` tells
// whether the frame holds it.
std::vector<BranchImages> branch_images(int light, const std::vector<Branch>& branches,
                                        const std::function<bool(const std::string&)>& has,
                                        const std::function<Image(const std::string&)>& read);

// The share of a grid vertex's flux that is splatted by itself: what no cell around it has taken. 1 where landings are
// not joined to cells: `cell_flux` without values.
double share_of_points(const Image& cell_flux, int x, int y);

// Adds up, in double precision and texel order, what the landing passes of all branches and the caustic map
// hold. `far_map`: that of the farthest receivers, where there is one.
Ledger make_ledger(const std::vector<BranchImages>& branches, const Image& caustic_map, const Image& far_map,
                   const Frame& caustic_frame, const Settings& settings);

}  // namespace caustics
