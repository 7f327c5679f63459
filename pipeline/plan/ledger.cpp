#include "pipeline/plan/ledger.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/plan/splat_kernel.hpp"

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
  }
  return "?";
}

namespace {

FluxRgb rgb(const Image& image, int x, int y) {
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
    case LandingStatus::Empty:
    case LandingStatus::Landed:
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
                          not_converged[c] + kernel_edge[c] + in_map[c];
    worst = std::max(worst, std::fabs(entered[c] - booked) / entered[c]);
  }
  return worst;
}

Ledger make_ledger(const Image& landing, const Image& flux, const Image& fresnel,
                   const Image& absorbed, const Image& caustic_map, const Frame& caustic_frame,
                   const Settings& settings) {
  Ledger ledger;
  const SplatKernel kernel = splat_kernel(settings);
  const glm::dvec2 size = caustic_frame.window_upper - caustic_frame.window_lower;
  for (int y = 0; y < landing.height(); ++y)
    for (int x = 0; x < landing.width(); ++x) {
      const auto status = static_cast<LandingStatus>(static_cast<int>(landing.at(x, y, 3)));
      ++ledger.vertices[static_cast<std::size_t>(status)];
      if (status == LandingStatus::Empty) continue;
      const double entered = fresnel.at(x, y, 3);
      add(ledger.entered, {entered, entered, entered});
      add(ledger.fresnel, rgb(fresnel, x, y));
      add(ledger.absorbed, rgb(absorbed, x, y));
      const FluxRgb carried = rgb(flux, x, y);
      if (FluxRgb* account = account_of(ledger, status)) {
        add(*account, carried);
        continue;
      }
      const glm::dvec3 p{landing.at(x, y, 0), landing.at(x, y, 1), landing.at(x, y, 2)};
      const glm::dvec2 uv =
          (caustic_frame.window(caustic_frame.coordinates(p)) - caustic_frame.window_lower) / size;
      const double inside =
          share_on_map(kernel, uv.x * caustic_map.width(), uv.y * caustic_map.height(),
                       caustic_map.width());
      add(ledger.kernel_edge, carried, 1.0 - inside);
    }
  for (int y = 0; y < caustic_map.height(); ++y)
    for (int x = 0; x < caustic_map.width(); ++x) add(ledger.in_map, rgb(caustic_map, x, y));
  return ledger;
}

}  // namespace caustics
