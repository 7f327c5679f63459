// The flux ledger: where the light that entered a caster grid went.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "pipeline/gpu/image_view.hpp"
#include "pipeline/measure/landing_images.hpp"
#include "pipeline/measure/splat_counts.hpp"
#include "pipeline/scene/view.hpp"
#include "pipeline/shader/constants.hpp"

namespace caustics {

struct Settings;

// How a grid vertex ended; `landing`'s alpha channel holds the number.
enum class LandingStatus : std::uint8_t {
  Empty = STATUS_EMPTY,  // no caster in this texel
  Landed = STATUS_LANDED,
  Missed = STATUS_MISSED,                     // leaves the scene: no receiver on its way
  Outside = STATUS_OUTSIDE,                   // leaves the receiver or the caustic map
  TotalReflection = STATUS_TOTAL_REFLECTION,  // cannot leave the caster at its second surface
  Absorbed = STATUS_ABSORBED,                 // less than a millionth is left
  NotConverged = STATUS_NOT_CONVERGED,        // the estimator did not close in on a receiver
  ExitNotFound = STATUS_EXIT_NOT_FOUND,       // nor on the caster's second surface: it may lie behind another
  GivenUp = STATUS_GIVEN_UP,  // too weak, through too many surfaces or bodies, or astray, to be followed on
  Stopped = STATUS_STOPPED,   // not converged; drawn where it stopped all the same, as was asked for
};
inline constexpr int kLandingStatuses = 10;
// Is its light drawn into the caustic map?
constexpr bool is_drawn(LandingStatus status) {
  return status == LandingStatus::Landed || status == LandingStatus::Stopped;
}
std::string_view name_of(LandingStatus status);

using FluxRgb = std::array<double, 3>;

// One light's ledger, per colour channel. Flux is relative to the light's own intensity: square
// metres (lumen per lux) for directional lights, steradians (lumen per candela) for the others.
struct Ledger {
  FluxRgb entered{};   // onto the casters
  FluxRgb fresnel{};   // reflected at the surfaces
  FluxRgb absorbed{};  // in the material, and what ended as Absorbed
  FluxRgb total_reflection{};
  FluxRgb medium{};  // absorbed and scattered by the medium, before and after the casters
  FluxRgb missed{};
  FluxRgb outside{};
  FluxRgb not_converged{};
  FluxRgb exit_not_found{};
  FluxRgb given_up{};
  FluxRgb kernel_edge{};  // parts of splats beyond the map's edge
  FluxRgb in_map{};       // the sum over the caustic map
  FluxRgb rounding{};  // splatted less in_map: what the map's single-precision sums lost (gained: negative)
  // The most that rounding can take of sums in single precision: n 2^-24 of a texel's flux where n splats may
  // have touched it (Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 4.2), over all
  // texels. 0 where splats are not counted: lights that see all around.
  FluxRgb rounding_bound{};
  // |entered - everything else| / entered, the largest of the channels; 0 for an empty grid. `rounding`
  // counts as booked as far as its bound allows; what it has beyond that is a residual.
  double residual() const;
  std::array<std::uint64_t, kLandingStatuses> vertices{};  // by LandingStatus
};

// Adds another ledger, each of its fluxes times `share`: the samples of one light to the light's own.
void add(Ledger& sum, const Ledger& other, double share);

// Adds up, in double precision and texel order, what a light's passes hold, branch by branch, so that no more
// than one branch's images need be there.
class LedgerSum {
 public:
  // The view is the caustic map's, of `map` texels a side; it must outlive this.
  LedgerSum(const View& caustic_view, const Settings& settings, int map);
  void add(const BranchImages& images, const CellImages& cells);
  // With what the maps hold. `far_map`: that of the farthest receivers, without values where there is none.
  Ledger with_maps(const ImageView& caustic_map, const ImageView& far_map) const;

 private:
  const View& view_;
  SplatKernel kernel_;
  int map_;
  Ledger ledger_;
  std::optional<SplatCounts> counts_;  // none where the light sees all around
};

// The same of all branches at once; `cells` by branch.
Ledger make_ledger(const std::vector<BranchImages>& branches, const std::vector<CellImages>& cells,
                   const ImageView& caustic_map, const ImageView& far_map, const View& caustic_view,
                   const Settings& settings);

}  // namespace caustics
