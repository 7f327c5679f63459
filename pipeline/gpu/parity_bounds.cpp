#include "pipeline/gpu/parity_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace caustics {

namespace {

template <std::size_t N, class Enum>
std::string_view named(const std::string_view (&names)[N], Enum value) {
  return names[static_cast<std::size_t>(value)];
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

ParityVerdict beyond(std::string reason) { return {Verdict::Beyond, {}, std::move(reason)}; }

// Do single texels decide between one thing and another?
bool has_edges(ImageKind kind) {
  return kind == ImageKind::Shading || kind == ImageKind::RasterizedMap || kind == ImageKind::RandomDraws;
}

// Why a difference is beyond whatever its bounds; empty: it is not.
std::string always_wrong(const ImageDifference& d) {
  if (!d.same_shape) return "another size or format";
  if (d.all.nan_only_a + d.all.nan_only_b > 0) return "a NaN on one side alone";
  if (d.all.infinite > 0) return "an infinity on one side alone";
  return {};
}

}  // namespace

std::string_view name_of(DriverClass driver) {
  static constexpr std::string_view names[] = {"llvmpipe, fused",         "llvmpipe, fused, other points",
                                               "llvmpipe, unfused",       "hardware",
                                               "hardware that contracts", "hardware with 4 sub-pixel bits"};
  return named(names, driver);
}

std::string_view name_of(ImageKind kind) {
  static constexpr std::string_view names[] = {"shading",  "rasterized map", "samples passed",
                                               "flux map", "intermediate",   "beauty",
                                               "picture",  "random draws"};
  return named(names, kind);
}

std::string_view name_of(Measure measure) {
  static constexpr std::string_view names[] = {
      "coverage", "jumps", "relative L1", "total flux", "p99.9 of relative", "share beyond 1/255"};
  return named(names, measure);
}

std::string_view name_of(Verdict verdict) {
  static constexpr std::string_view names[] = {"equal", "within", "BEYOND"};
  return named(names, verdict);
}

std::span<const ParityBound> parity_bounds() {
  using K = ImageKind;
  using M = Measure;
  // A few times the worst that was measured on the sample scenes, on emulated hardware for what is no
  // llvmpipe (docs/parity.md). By class: fused, other points, unfused, hardware, contracting, 4 bits.
  static constexpr ParityBound bounds[] = {
      {K::Shading,
       M::Jumps,
       {0, 0, 0, 0.1, 0.03, 0.1},
       "rays on an edge, which a quotient an ulp off or a contracted sum turns to its other side"},
      {K::Shading,
       M::RelativeL1,
       {0, 0, 0, 1.5e-4, 1e-4, 1.5e-4},
       "quotients and roots an ulp off, or contracted sums, most where rays graze a surface"},
      {K::RasterizedMap,
       M::Coverage,
       {0, 0, 2e-3, 2e-3, 2e-3, 0.1},
       "corners snapped to the sub-pixel grid from a viewport transform that rounds otherwise"},
      {K::RasterizedMap,
       M::Jumps,
       {0, 0, 2e-3, 2e-3, 2e-3, 0.15},
       "edges between triangles a pixel further, and fetches on borders between texels"},
      {K::RasterizedMap,
       M::RelativeL1,
       {0, 0, 4e-6, 4e-6, 4e-6, 6e-4},
       "interpolation: planes or weights with other roundings, from corners snapped otherwise"},
      {K::Samples,
       M::Coverage,
       {0, 1e-4, 2e-3, 2e-2, 2e-2, 2e-2},
       "coverage, also of what depth hides, points' edges, and holes whose borders lie between texels"},
      {K::FluxMap,
       M::RelativeL1,
       {0, 2e-6, 2e-5, 4e-5, 4e-5, 4e-5},
       "points a texel larger or smaller where kernels end, and quotients in the shares"},
      {K::FluxMap,
       M::TotalFlux,
       {0, 1e-6, 1e-6, 2e-6, 1e-6, 1.5e-5},
       "shares that add up to 1 but for roundings; of panes, with coarse corners, also edges"},
      {K::Intermediate,
       M::Jumps,
       {0, 1e-3, 0.05, 0.11, 0.05, 0.49},
       "rays on an edge, and dim texels of light maps, which are sums of few tails"},
      {K::Beauty,
       M::RelativeL1,
       {0, 6e-6, 1.5e-4, 2e-4, 2.5e-4, 1e-2},
       "all passes added up; one of N rays that lands elsewhere takes 1/N of the light along"},
      {K::Beauty,
       M::P999,
       {0, 2e-4, 0.02, 0.02, 0.04, 1.5},
       "pixels that see such a ray's light or focused light; with coarse corners, edges"},
      {K::Picture,
       M::RelativeL1,
       {0, 6e-6, 5e-5, 6e-5, 1e-4, 4e-3},
       "differences of the radiance, as far as 8 bits show them"},
      {K::Picture,
       M::BeyondAStep,
       {0, 1e-4, 1e-3, 1.5e-3, 2.5e-3, 0.03},
       "pixels that see a ray's other landing; with coarse corners, edges"},
      {K::RandomDraws,
       M::Coverage,
       {0, 1e-4, 1e-4, 2e-3, 2e-3, 0.1},
       "as of rasterized maps, in shapes that are little but edges"},
      {K::RandomDraws,
       M::Jumps,
       {0, 1e-4, 1e-4, 5e-3, 5e-3, 0.1},
       "which of two overlapping shapes is nearer, and which covers an edge"},
      {K::RandomDraws,
       M::RelativeL1,
       {0, 1e-6, 1e-6, 5e-5, 5e-5, 4e-3},
       "interpolation across slivers and triangles far larger than the target"},
  };
  return bounds;
}

double measured(Measure measure, ImageKind kind, const ImageDifference& d) {
  const auto share = [](std::size_t part, std::size_t of) {
    return part == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(of);
  };
  switch (measure) {
    case Measure::Coverage:
      return share(d.coverage_mismatches, d.covered);
    case Measure::Jumps:
      return share(d.jumps, d.texels);
    case Measure::RelativeL1:
      return (has_edges(kind) ? d.steady : d.sums).relative();
    case Measure::TotalFlux:
      return d.sums.relative_total();
    case Measure::P999:
      return d.all.relative.p999;
    case Measure::BeyondAStep:
      return share(d.beyond_a_step, d.all.values);
  }
  return 0.0;
}

const BoundCheck* ParityVerdict::closest() const {
  const auto ratio = [](const BoundCheck& c) { return c.found == 0.0 ? 0.0 : c.found / c.most; };
  const auto less = [&](const BoundCheck& a, const BoundCheck& b) {
    return a.within != b.within ? a.within : ratio(a) < ratio(b);
  };
  const auto found = std::max_element(checks.begin(), checks.end(), less);
  return found == checks.end() ? nullptr : &*found;
}

ParityVerdict judge(const ImageDifference& difference, ImageKind kind, DriverClass driver,
                    std::span<const ParityBound> bounds) {
  if (std::string why = always_wrong(difference); !why.empty()) return beyond(std::move(why));
  ParityVerdict verdict;
  for (const ParityBound& bound : bounds) {
    if (bound.kind != kind) continue;
    if (bound.cause.empty()) return beyond("a bound without a cause");
    const double most = bound.most[static_cast<std::size_t>(driver)];
    const double found = measured(bound.measure, kind, difference);
    const bool one_texel = (bound.measure == Measure::Coverage && difference.coverage_mismatches == 1) ||
                           (bound.measure == Measure::Jumps && difference.jumps == 1);
    const bool within = most == 0.0 ? difference.all.differing == 0 : found <= most || one_texel;
    verdict.checks.push_back({&bound, found, most, within});
  }
  const BoundCheck* closest = verdict.closest();
  if (!closest) return beyond("no bound for a " + std::string(name_of(kind)));
  if (difference.all.differing == 0) return verdict;
  verdict.verdict = closest->within ? Verdict::Within : Verdict::Beyond;
  verdict.reason = closest->within
                       ? std::string(closest->bound->cause)
                       : std::string(name_of(closest->bound->measure)) + " is " + number(closest->found) +
                             ", at most " + number(closest->most) + " on " + std::string(name_of(driver));
  return verdict;
}

bool samples_agree(std::uint64_t reference, std::uint64_t tested, DriverClass driver) {
  const std::uint64_t apart = reference > tested ? reference - tested : tested - reference;
  if (apart == 0) return true;
  for (const ParityBound& bound : parity_bounds()) {
    if (bound.kind != ImageKind::Samples) continue;
    const double most = bound.most[static_cast<std::size_t>(driver)];
    return most > 0.0 && static_cast<double>(apart) <= std::ceil(most * static_cast<double>(reference));
  }
  return false;
}

}  // namespace caustics
