#include "pipeline/measure/landing_images.hpp"

#include <algorithm>

#include "pipeline/plan/frame_plan.hpp"

namespace caustics {

double share_of_points(const ImageView& cell_flux, int x, int y) {
  if (cell_flux.values.empty()) return 1.0;
  double share = 1.0;
  for (int dy = 0; dy < 2; ++dy)
    for (int dx = 0; dx < 2; ++dx)
      if (x >= dx && y >= dy) share -= 0.25 * static_cast<double>(cell_flux.at(x - dx, y - dy, 3));
  return share;
}

namespace {

void copy_texel(Image& to, const ImageView& from, std::size_t texel) {
  const auto channels = static_cast<std::size_t>(to.channels());
  std::copy_n(from.values.begin() + static_cast<std::ptrdiff_t>(texel * channels), channels,
              to.values.begin() + static_cast<std::ptrdiff_t>(texel * channels));
}

// With the farther texels where the last channel of `where` is not 0; no copy where it is 0 everywhere.
ImageView merged(const ImageView& image, const ImageView& far, const ImageView& where) {
  const auto is_farther = [&](std::size_t texel) { return where.values[4 * texel + 3] != 0.0f; };
  const std::size_t texels = where.values.size() / 4;
  std::size_t first = 0;
  while (first < texels && !is_farther(first)) ++first;
  if (first == texels) return image;
  Image both = image.copy();
  for (std::size_t i = first; i < texels; ++i)
    if (is_farther(i)) copy_texel(both, far, i);
  return both;
}

// Where the farther landing has a status, its values; cells of both, which never overlap.
void merge_far(BranchImages& images, const BranchImages& far) {
  for (ImageView BranchImages::*image :
       {&BranchImages::flux, &BranchImages::fresnel, &BranchImages::absorbed, &BranchImages::landing})
    images.*image = merged(images.*image, far.*image, far.landing);
  if (!far.medium.values.empty()) images.medium = merged(images.medium, far.medium, far.landing);
  if (!far.cell_flux.values.empty())
    images.cell_flux = merged(images.cell_flux, far.cell_flux, far.cell_flux);
}

}  // namespace

BranchImages images_of_branch(int light, const Branch& branch, const HasTexture& has,
                              const ReadTexture& read) {
  const auto own = [&](const char* name) { return read(branch_texture(name, light, branch)); };
  const auto if_any = [&](const char* name) {
    return has(branch_texture(name, light, branch)) ? own(name) : ImageView{};
  };
  BranchImages images{branch,
                      own(kLanding),
                      own(kLandingFlux),
                      own(kLandingFresnel),
                      own(kLandingAbsorbed),
                      if_any(kCellFlux),
                      if_any(kLandingMedium),
                      if_any(kLandingFootprint)};
  if (!has(branch_texture(far_texture(kLanding), light, branch))) return images;
  const auto far = [&](const char* name) { return own(far_texture(name).c_str()); };
  const auto far_if_any = [&](const char* name) {
    return has(branch_texture(far_texture(name), light, branch)) ? far(name) : ImageView{};
  };
  merge_far(images, {branch, far(kLanding), far(kLandingFlux), far(kLandingFresnel), far(kLandingAbsorbed),
                     far_if_any(kCellFlux), far_if_any(kLandingMedium), ImageView{}});
  return images;
}

CellImages cells_of_branch(int light, const Branch& branch, const HasTexture& has, const ReadTexture& read) {
  const auto own = [&](const std::string& name) {
    const std::string full = branch_texture(name, light, branch);
    return has(full) ? read(full) : ImageView{};
  };
  CellImages cells{own(kCellNear), own(kCellFar)};
  const ImageView far_flux = own(far_texture(kCellFlux));
  if (far_flux.values.empty()) return cells;
  cells.near = merged(cells.near, own(far_texture(kCellNear)), far_flux);
  cells.far = merged(cells.far, own(far_texture(kCellFar)), far_flux);
  return cells;
}

std::vector<BranchImages> branch_images(int light, const std::vector<Branch>& branches, const HasTexture& has,
                                        const ReadTexture& read) {
  std::vector<BranchImages> result;
  result.reserve(branches.size());
  for (const Branch& branch : branches) result.push_back(images_of_branch(light, branch, has, read));
  return result;
}

std::vector<CellImages> cell_images(int light, const std::vector<Branch>& branches, const HasTexture& has,
                                    const ReadTexture& read) {
  std::vector<CellImages> result;
  result.reserve(branches.size());
  for (const Branch& branch : branches) result.push_back(cells_of_branch(light, branch, has, read));
  return result;
}

std::vector<std::string> ledger_textures() {
  std::vector<std::string> textures{kCasterPosition, kCasterNormal, kLandingFootprint, kCascadeMap,
                                    kViewPosition};
  for (const char* name : {kLanding, kLandingFlux, kLandingFresnel, kLandingAbsorbed, kLandingMedium,
                           kCellNear, kCellFar, kCellFlux, kCausticMap}) {
    textures.emplace_back(name);
    textures.push_back(far_texture(name));
  }
  return textures;
}

}  // namespace caustics
