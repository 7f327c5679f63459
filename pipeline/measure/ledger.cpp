#include "pipeline/measure/ledger.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/settings/splat_kernel.hpp"
#include "pipeline/shader/constants.hpp"

namespace caustics {

std::string_view name_of(LandingStatus status) {
  switch (status) {
    case LandingStatus::Empty:
      return "empty";
    case LandingStatus::Landed:
      return "landed";
    case LandingStatus::Missed:
      return "missed";
    case LandingStatus::Outside:
      return "outside";
    case LandingStatus::TotalReflection:
      return "total_reflection";
    case LandingStatus::Absorbed:
      return "absorbed";
    case LandingStatus::NotConverged:
      return "not_converged";
    case LandingStatus::ExitNotFound:
      return "exit_not_found";
    case LandingStatus::Stopped:
      return "stopped";
    case LandingStatus::GivenUp:
      return "given_up";
  }
  return "?";
}

namespace {

FluxRgb rgb(const ImageView& image, int x, int y) {
  if (image.channels() == 1) {
    const double grey = image.at(x, y, 0);
    return {grey, grey, grey};
  }
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

void add(FluxRgb& sum, const FluxRgb& value, double factor = 1.0) {
  for (std::size_t c = 0; c < 3; ++c) sum[c] += value[c] * factor;
}

// Share of a splat's kernel that lies on the map, from its centre in texels.
double share_on_map(const SplatKernel& kernel, double x, double y, int map) {
  if (kernel.radius == 0.0) return 1.0;
  return kernel.share(-x, map - x) * kernel.share(-y, map - y);
}

FluxRgb* account_of(Ledger& ledger, LandingStatus status) {
  switch (status) {
    case LandingStatus::Missed:
      return &ledger.missed;
    case LandingStatus::Outside:
      return &ledger.outside;
    case LandingStatus::TotalReflection:
      return &ledger.total_reflection;
    case LandingStatus::Absorbed:
      return &ledger.absorbed;
    case LandingStatus::NotConverged:
      return &ledger.not_converged;
    case LandingStatus::ExitNotFound:
      return &ledger.exit_not_found;
    case LandingStatus::GivenUp:
      return &ledger.given_up;
    case LandingStatus::Empty:
    case LandingStatus::Landed:
    case LandingStatus::Stopped:
      return nullptr;
  }
  return nullptr;
}

}  // namespace

double Ledger::residual() const {
  double worst = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    if (entered[c] <= 0.0) continue;
    const double booked = fresnel[c] + absorbed[c] + total_reflection[c] + missed[c] + outside[c] +
                          not_converged[c] + exit_not_found[c] + given_up[c] + kernel_edge[c] + medium[c] +
                          in_map[c] + std::clamp(rounding[c], -rounding_bound[c], rounding_bound[c]);
    worst = std::max(worst, std::fabs(entered[c] - booked) / entered[c]);
  }
  return worst;
}

void add(Ledger& sum, const Ledger& other, double share) {
  for (FluxRgb Ledger::*account :
       {&Ledger::entered, &Ledger::fresnel, &Ledger::absorbed, &Ledger::total_reflection, &Ledger::missed,
        &Ledger::outside, &Ledger::not_converged, &Ledger::exit_not_found, &Ledger::given_up,
        &Ledger::kernel_edge, &Ledger::medium, &Ledger::in_map, &Ledger::rounding, &Ledger::rounding_bound})
    add(sum.*account, other.*account, share);
  for (std::size_t s = 0; s < sum.vertices.size(); ++s) sum.vertices[s] += other.vertices[s];
}

namespace {

void add_vertex(const BranchImages& images, int x, int y, const std140::View& view, const SplatKernel& kernel,
                int map, Ledger& ledger) {
  const auto status = static_cast<LandingStatus>(static_cast<int>(images.landing.at(x, y, 3)));
  const double flux = images.fresnel.at(x, y, 3);
  // The guard vertices of a cube's grid belong to other faces: they carry nothing.
  const bool cube = view.kind == VIEW_CUBE;
  const bool guard = cube && flux == 0.0 && images.branch.leads();
  // A vertex without a caster is counted once, not by every branch that parts from the first.
  if (images.branch.leads() || status != LandingStatus::Empty)
    ++ledger.vertices[static_cast<std::size_t>(guard ? LandingStatus::Empty : status)];
  if (status == LandingStatus::Empty || guard) return;
  const glm::vec3& color = images.branch.color;
  const FluxRgb entered{flux * double(color.x), flux * double(color.y), flux * double(color.z)};
  // What was mirrored has entered with the light that was let in, and is booked there as Fresnel's.
  if (images.branch.reflected) {
    add(ledger.fresnel, entered, -1.0);
  } else {
    add(ledger.entered, entered);
  }
  add(ledger.fresnel, rgb(images.fresnel, x, y));
  add(ledger.absorbed, rgb(images.absorbed, x, y));
  if (!images.medium.values.empty()) add(ledger.medium, rgb(images.medium, x, y));
  const FluxRgb carried = rgb(images.flux, x, y);
  if (FluxRgb* account = account_of(ledger, status)) return add(*account, carried);
  add(ledger.rounding, carried);
  // A tile's guard holds every splat whole, and a footprint ends at the map's edge.
  if (cube || (!images.footprint.values.empty() && !images.cell_flux.values.empty())) return;
  const glm::dvec2 texel = texel_of(images, x, y, view, map);
  const double beyond =
      (1.0 - share_on_map(kernel, texel.x, texel.y, map)) * share_of_points(images.cell_flux, x, y);
  add(ledger.kernel_edge, carried, beyond);
  add(ledger.rounding, carried, -beyond);
}

constexpr double kUnitRoundoff = 0x1p-24;  // of single precision, to nearest

// `counts` by texel of a map that is so wide; none where splats are not counted.
void add_map(const ImageView& map, const std::vector<std::uint32_t>& counts, int side, Ledger& ledger) {
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) {
      const FluxRgb flux = rgb(map, x, y);
      add(ledger.in_map, flux);
      add(ledger.rounding, flux, -1.0);
      const std::size_t texel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
      if (!counts.empty())
        add(ledger.rounding_bound, flux, static_cast<double>(counts[texel]) * kUnitRoundoff);
    }
}

}  // namespace

LedgerSum::LedgerSum(const View& caustic_view, const Settings& settings, int map)
    : view_(caustic_view), kernel_(splat_kernel(settings)), map_(map) {
  if (!view_.cube) counts_.emplace(kernel_, view_, map_);
}

void LedgerSum::add(const BranchImages& images, const CellImages& cells) {
  const std140::View uniforms = shader_view(view_);
  for (int y = 0; y < images.landing.height(); ++y)
    for (int x = 0; x < images.landing.width(); ++x)
      add_vertex(images, x, y, uniforms, kernel_, map_, ledger_);
  if (counts_) counts_->add(images, cells);
}

Ledger LedgerSum::with_maps(const ImageView& caustic_map, const ImageView& far_map) const {
  Ledger ledger = ledger_;
  const std::vector<std::uint32_t> counts = counts_ ? counts_->by_texel() : std::vector<std::uint32_t>{};
  for (const ImageView* map : {&caustic_map, &far_map}) add_map(*map, counts, map_, ledger);
  return ledger;
}

Ledger make_ledger(const std::vector<BranchImages>& branches, const std::vector<CellImages>& cells,
                   const ImageView& caustic_map, const ImageView& far_map, const View& caustic_view,
                   const Settings& settings) {
  LedgerSum sum(caustic_view, settings, caustic_map.width());
  for (std::size_t b = 0; b < branches.size(); ++b)
    sum.add(branches[b], b < cells.size() ? cells[b] : CellImages{});
  return sum.with_maps(caustic_map, far_map);
}

}  // namespace caustics
