#include "pipeline/plan/ledger.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/plan/frame_plan.hpp"
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
                          not_converged[c] + kernel_edge[c] + medium[c] + in_map[c];
    worst = std::max(worst, std::fabs(entered[c] - booked) / entered[c]);
  }
  return worst;
}

void add(Ledger& sum, const Ledger& other, double share) {
  for (FluxRgb Ledger::*account :
       {&Ledger::entered, &Ledger::fresnel, &Ledger::absorbed, &Ledger::total_reflection,
        &Ledger::missed, &Ledger::outside, &Ledger::not_converged, &Ledger::kernel_edge,
        &Ledger::medium, &Ledger::in_map})
    add(sum.*account, other.*account, share);
  for (std::size_t s = 0; s < sum.vertices.size(); ++s) sum.vertices[s] += other.vertices[s];
}

double share_of_points(const Image& cell_flux, int x, int y) {
  if (cell_flux.values.empty()) return 1.0;
  double share = 1.0;
  for (int dy = 0; dy < 2; ++dy)
    for (int dx = 0; dx < 2; ++dx)
      if (x >= dx && y >= dy) share -= 0.25 * static_cast<double>(cell_flux.at(x - dx, y - dy, 3));
  return share;
}

namespace {

void add_vertex(const BranchImages& images, int x, int y, const Frame& frame,
                const SplatKernel& kernel, int map, Ledger& ledger) {
  const auto status = static_cast<LandingStatus>(static_cast<int>(images.landing.at(x, y, 3)));
  const double flux = images.fresnel.at(x, y, 3);
  // The guard vertices of a cube's grid belong to other faces: they carry nothing.
  const bool guard = frame.cube && flux == 0.0;
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
  if (frame.cube) return;  // a tile's guard holds every splat whole
  const glm::dvec3 p{images.landing.at(x, y, 0), images.landing.at(x, y, 1),
                     images.landing.at(x, y, 2)};
  const glm::dvec2 uv = (frame.window(frame.coordinates(p)) - frame.window_lower) /
                        (frame.window_upper - frame.window_lower);
  const double inside = share_on_map(kernel, uv.x * map, uv.y * map, map);
  add(ledger.kernel_edge, carried, (1.0 - inside) * share_of_points(images.cell_flux, x, y));
}

}  // namespace

namespace {

void copy_texel(Image& to, const Image& from, std::size_t texel) {
  const auto channels = static_cast<std::size_t>(to.channels());
  std::copy_n(from.values.begin() + static_cast<std::ptrdiff_t>(texel * channels), channels,
              to.values.begin() + static_cast<std::ptrdiff_t>(texel * channels));
}

// Where the farther landing has a status, its values; cells of both, which never overlap.
void merge_far(BranchImages& images, const BranchImages& far) {
  for (std::size_t i = 0; 4 * i < images.landing.values.size(); ++i) {
    if (far.landing.values[4 * i + 3] != 0.0f) {
      copy_texel(images.landing, far.landing, i);
      copy_texel(images.flux, far.flux, i);
      copy_texel(images.fresnel, far.fresnel, i);
      copy_texel(images.absorbed, far.absorbed, i);
    }
    if (!far.cell_flux.values.empty() && far.cell_flux.values[4 * i + 3] != 0.0f)
      copy_texel(images.cell_flux, far.cell_flux, i);
  }
}

}  // namespace

std::vector<BranchImages> branch_images(int light, const std::vector<Branch>& branches,
                                        const std::function<bool(const std::string&)>& has,
                                        const std::function<Image(const std::string&)>& read) {
  std::vector<BranchImages> result;
  for (const Branch& branch : branches) {
    const auto own = [&](const char* name) { return read(branch_texture(name, light, branch)); };
    const auto if_any = [&](const char* name) {
      return has(branch_texture(name, light, branch)) ? own(name) : Image{};
    };
    result.push_back({branch, own(kLanding), own(kLandingFlux), own(kLandingFresnel),
                      own(kLandingAbsorbed), if_any(kCellFlux), if_any(kLandingMedium)});
    if (!has(branch_texture(far_texture(kLanding), light, branch))) continue;
    const auto far = [&](const char* name) { return own(far_texture(name).c_str()); };
    const bool cells = has(branch_texture(far_texture(kCellFlux), light, branch));
    merge_far(result.back(), {branch, far(kLanding), far(kLandingFlux), far(kLandingFresnel), far(kLandingAbsorbed),
                              cells ? far(kCellFlux) : Image{}, Image{}});
  }
  return result;
}

Ledger make_ledger(const std::vector<BranchImages>& branches, const Image& caustic_map, const Image& far_map,
                   const Frame& caustic_frame, const Settings& settings) {
  Ledger ledger;
  const SplatKernel kernel = splat_kernel(settings);
  for (const BranchImages& images : branches)
    for (int y = 0; y < images.landing.height(); ++y)
      for (int x = 0; x < images.landing.width(); ++x)
        add_vertex(images, x, y, caustic_frame, kernel, caustic_map.width(), ledger);
  for (const Image* map : {&caustic_map, &far_map})
    for (int y = 0; y < map->height(); ++y)
      for (int x = 0; x < map->width(); ++x) add(ledger.in_map, rgb(*map, x, y));
  return ledger;
}

}  // namespace caustics
