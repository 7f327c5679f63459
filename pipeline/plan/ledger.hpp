// The flux ledger: where the light that entered a caster grid went.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "pipeline/gpu/image.hpp"
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

// Adds up, in double precision and texel order, what the landing pass and the caustic map hold.
Ledger make_ledger(const Image& landing, const Image& flux, const Image& fresnel,
                   const Image& absorbed, const Image& caustic_map, const Frame& caustic_frame,
                   const Settings& settings);

}  // namespace caustics
