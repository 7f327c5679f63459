// What became of one light's flux on each caster: why a caustic that was to be expected is not there.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "pipeline/measure/ledger.hpp"

namespace caustics {

struct Outcome {
  int mesh = 0;  // the caster
  // Flux onto the caster, mean of the channels, relative to the light's intensity as in the ledger.
  double entered = 0.0;
  // The part of it whose way ended so, by LandingStatus; of Landed, what is left of it where it lands.
  std::array<double, kLandingStatuses> ended{};

  double share(LandingStatus status) const {
    return entered > 0.0 ? ended[static_cast<std::size_t>(status)] / entered : 0.0;
  }
};

// One for each mesh of `mesh_of_row` (by the row of caster_normal's fourth channel), in that order. Where a
// light's way ends otherwise than on a receiver, all that is left of its flux there is booked.
std::vector<Outcome> outcomes_of(const std::vector<BranchImages>& branches, const ImageView& caster_normal,
                                 const std::vector<int>& mesh_of_row);

// Adds `share` of another's flux on the same caster.
void add(Outcome& sum, const Outcome& other, double share);

// Of a caster that no flux enters; what stands before it, meshes_in_the_way.hpp finds.
inline constexpr char kNoLightReachesIt[] = "no light reaches it: something stands before it";

// Why (nearly) nothing of the flux landed: less than a thousandth. Empty where more did. `over_added_ground`:
// there is one already, so none is proposed.
std::string why_no_caustic(const Outcome& outcome, bool over_added_ground);

}  // namespace caustics
