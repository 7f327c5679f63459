#include "pipeline/measure/model_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/measure/ledger.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

struct ModelError::Vertex {
  int x = 0, y = 0, half = 0;
  double times = 1.0;  // as many vertices it stands for
  bool lost = false;   // the passes have not found a landing of it
};

namespace {

double sum_of(const glm::dvec3& v) { return (v.x + v.y) + v.z; }

bool is_covered(const ImageView& landing, int x, int y) {
  return landing.at(x, y, 3) != static_cast<float>(LandingStatus::Empty);
}

glm::dvec3 texel_rgb(const ImageView& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

}  // namespace

ModelError::ModelError(const LightPaths& paths, const PictureBlocks& blocks, int rays)
    : paths_(paths), blocks_(blocks), rays_(rays) {
  for (Sums& half : surplus_) {
    half.values.assign(3 * blocks.count(), 0.0);
    half.sizes = half.values;
  }
}

// Every n-th vertex along both sides of the grid, so that about as many covered ones are left as asked for.
void ModelError::add(const Sample& sample) {
  const ImageView& landing = sample.branches.front().landing;
  std::size_t covered = 0;
  for (int y = 0; y < landing.height(); ++y)
    for (int x = 0; x < landing.width(); ++x) covered += is_covered(landing, x, y) ? 1u : 0u;
  const double wanted = std::max(1.0, static_cast<double>(rays_) / sample.samples);
  int step = 1;
  while (static_cast<double>(covered) > wanted * step * step) ++step;
  for (const BranchImages& images : sample.branches) any_drawn_ = any_drawn_ || images.branch.drawn;
  any_drawn_ = any_drawn_ || sample.points != nullptr;
  least_step_ = least_step_ == 0 ? step : std::min(least_step_, step);
  std::vector<Vertex> vertices;
  for (int y = step / 2; y < landing.height(); y += step)
    for (int x = step / 2; x < landing.width(); x += step)
      if (is_covered(landing, x, y))
        vertices.push_back(
            {x, y, (x / step + y / step) % 2, static_cast<double>(step) * step * sample.share});
  for (Vertex& vertex : vertices) compare(sample, vertex);
  const double before = landed_;
  follow(sample, vertices);
  unseen_ += (landed_ - before) * sample.unseen / std::max(1.0 - sample.unseen, 0.01);
}

bool ModelError::sees(const glm::dvec3& p) const {
  const View& camera = blocks_.camera();
  if (!camera.perspective) return !paths_.casters_block(p, -camera.forward, camera.coordinates(p).z);
  const glm::dvec3 way = camera.origin - p;
  return !paths_.casters_block(p, exact::normalise(way, -camera.forward), exact::length(way));
}

void ModelError::compare(const Sample& sample, Vertex& vertex) {
  for (const BranchImages& images : sample.branches) {
    const auto status = static_cast<LandingStatus>(images.landing.at(vertex.x, vertex.y, 3));
    vertex.lost = vertex.lost || status == LandingStatus::NotConverged || status == LandingStatus::Outside ||
                  status == LandingStatus::ExitNotFound;
    if (!is_drawn(status)) continue;
    const glm::dvec3 flux = texel_rgb(images.flux, vertex.x, vertex.y) * vertex.times;
    if (paths_.followed_by_passes()) followed_ += sum_of(flux);
    const glm::dvec3 p = texel_rgb(images.landing, vertex.x, vertex.y);
    const auto place = blocks_.find(p);
    if (!place || !sees(p)) continue;
    put(vertex.half, place->block, flux * place->pixels_per_area);
  }
}

LightRay ModelError::ray_onto(const Sample& sample, const Vertex& vertex) {
  const int side = sample.branches.front().landing.width();
  const LightRay ray = light_ray(sample.light, sample.caster, side, vertex.x, vertex.y);
  if (!sample.points) return ray;
  return sample.points->ray(ray, texel_rgb(sample.caster_position, vertex.x, vertex.y), vertex.x, vertex.y);
}

void ModelError::follow(const Sample& sample, const std::vector<Vertex>& vertices) {
  const int side = sample.branches.front().landing.width();
  std::vector<LightRay> rays(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    rays[i] = ray_onto(sample, vertices[i]);
    rays[i].key = static_cast<std::uint64_t>(vertices[i].y) * static_cast<std::uint64_t>(side) +
                  static_cast<std::uint64_t>(vertices[i].x);
  }
  std::uint64_t branch = 0;
  for (const BranchImages& images : sample.branches) {
    if (images.branch.reflected) continue;
    ++branch;
    std::vector<LightRay> of_branch = rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Vertex& vertex = vertices[i];
      const double flux = static_cast<double>(images.fresnel.at(vertex.x, vertex.y, 3)) * vertex.times;
      of_branch[i].flux = glm::dvec3(images.branch.color) * std::max(flux, 0.0);
      of_branch[i].key = (rays[i].key + branch) * 0x10001u;
    }
    std::vector<LightLanding> landings;
    paths_.follow(of_branch, landings, images.branch.bend);
    for (const LightLanding& landing : landings) take(landing, vertices[landing.ray]);
  }
}

void ModelError::take(const LightLanding& landing, const Vertex& vertex) {
  const bool simple = landing.followed && !paths_.followed_by_passes();
  landed_ += sum_of(landing.flux);
  if (simple) followed_ += sum_of(landing.flux);
  const auto place = blocks_.find(landing.position);
  if (!place || !sees(landing.position)) return;
  const glm::dvec3 light = landing.flux * place->pixels_per_area;
  lit_ += sum_of(light);
  if (vertex.lost && simple) {
    lost_ += sum_of(light);
    return;
  }
  put(vertex.half, place->block, -light);
}

void ModelError::put(int half, std::size_t block, const glm::dvec3& light) {
  for (int c = 0; c < 3; ++c) {
    const std::size_t i = 3 * block + static_cast<std::size_t>(c);
    surplus_[half].values[i] += light[c];
    surplus_[half].sizes[i] += std::fabs(light[c]);
  }
}

// What has more, frame or light, in each block and channel: 1, -1, or 0 where nothing tells. Where the rays
// have left a block empty, or tell of rounding alone, the next larger square of blocks tells that is not.
std::vector<double> ModelError::signs(const Sums& surplus) const {
  constexpr double kRounding = 1e-6;
  std::vector<double> signs(surplus.values.size(), 0.0);
  Sums sums = surplus;
  std::size_t across = blocks_.across(), upward = blocks_.upward();
  for (int level = 0; across > 0; ++level) {
    for (std::size_t i = 0; i < signs.size(); ++i) {
      if (signs[i] != 0.0) continue;
      const std::size_t block = i / 3, x = (block % blocks_.across()) >> level,
                        y = (block / blocks_.across()) >> level;
      const std::size_t at = 3 * (y * across + x) + i % 3;
      const double sum = sums.values[at];
      if (std::fabs(sum) > kRounding * sums.sizes[at]) signs[i] = sum > 0.0 ? 1.0 : -1.0;
    }
    if (across == 1 && upward == 1) break;
    const std::size_t half_across = (across + 1) / 2, half_upward = (upward + 1) / 2;
    Sums halves{std::vector<double>(3 * half_across * half_upward, 0.0),
                std::vector<double>(3 * half_across * half_upward, 0.0)};
    for (std::size_t y = 0; y < upward; ++y)
      for (std::size_t x = 0; x < across; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t to = 3 * (y / 2 * half_across + x / 2) + c, from = 3 * (y * across + x) + c;
          halves.values[to] += sums.values[from];
          halves.sizes[to] += sums.sizes[from];
        }
    sums = std::move(halves);
    across = half_across;
    upward = half_upward;
  }
  return signs;
}

Surplus ModelError::surplus() const {
  Surplus sum{blocks_.side(), blocks_.across(), surplus_[0].values};
  for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += surplus_[1].values[i];
  return sum;
}

void ModelError::complete(ErrorEstimate& estimate) const {
  estimate.judged = true;
  if (!(landed_ > 0.0)) return;
  // |surplus| summed over the blocks is too much, by the noise of few rays. The signs that one half of the
  // rays gives, put to the other half's surplus, sum to too little. The truth lies between; where ways are
  // drawn most of the noise is theirs, and all vertices together have less of it.
  const std::vector<double> signs_a = signs(surplus_[0]), signs_b = signs(surplus_[1]);
  double most = 0.0, least = 0.0;
  for (std::size_t i = 0; i < signs_a.size(); ++i) {
    const double a = surplus_[0].values[i], b = surplus_[1].values[i];
    most += std::fabs(a + b);
    least += signs_a[i] * b + signs_b[i] * a;
  }
  least = std::clamp(least, 0.0, most);
  estimate.landed = landed_ + unseen_;
  const double whole = lit_ > 0.0 ? landed_ / lit_ : 0.0;
  const double of_noise = any_drawn_ ? 1.0 / std::max(least_step_, 2) : 0.5;
  estimate.sampling = of_noise * (most - least) * whole;
  estimate.model = least * whole + estimate.sampling;
  estimate.missing = lost_ * whole + unseen_;
  estimate.not_followed = std::max(landed_ - followed_, 0.0);
}

}  // namespace caustics
