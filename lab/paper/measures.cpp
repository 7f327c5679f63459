#include "lab/paper/measures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pipeline/shader/constants.hpp"

namespace caustics::paper {

namespace {

double distance(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto place = static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
  return values[place];
}

bool has_landed(const std::array<double, 4>& landing) {
  return landing[3] == STATUS_LANDED || landing[3] == STATUS_STOPPED;
}

std::vector<double> slab_errors(const Slab& slab, const Texels& entry, const Texels& landing) {
  const double refracted = *refraction_angle(slab.incidence, 1.0, slab.index);
  const double inside = slab.thickness * std::tan(refracted), edge = slab.half - slab.margin;
  double top = -1e30;
  for (const auto& p : entry.values)
    if (p[3] != 0.0) top = std::max(top, p[1]);
  std::vector<double> errors;
  for (std::size_t i = 0; i < landing.values.size(); ++i) {
    const auto &p = entry.values[i], &q = landing.values[i];
    if (!has_landed(q) || p[1] < top - 1e-3 || p[3] == 0.0) continue;
    if (p[0] < -edge || p[0] + inside > edge || std::fabs(p[2]) > edge) continue;
    const double expected = p[0] + inside + slab.height * std::tan(slab.incidence);
    errors.push_back(std::hypot(q[0] - expected, q[2] - p[2]));
  }
  return errors;
}

std::vector<double> sphere_errors(const GlassSphere& sphere, const Texels& entry, const Texels& landing) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < landing.values.size(); ++i) {
    const auto &p = entry.values[i], &q = landing.values[i];
    const double b = std::hypot(p[0], p[2]);
    if (!has_landed(q) || !(b > 0.0) || b >= sphere.largest_impact()) continue;
    const double r = sphere.landing(b) / b;
    errors.push_back(std::hypot(q[0] - r * p[0], q[2] - r * p[2]));
  }
  return errors;
}

std::vector<double> distances(const Texels& a, const Texels& b) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    if (has_landed(a.values[i]) && has_landed(b.values[i]))
      result.push_back(distance(a.values[i], b.values[i]));
  return result;
}

double worst_tint(const Texels& flux, const std::vector<double>& way,
                  const std::array<double, 3>& absorption) {
  double worst = 0.0;
  for (std::size_t i = 0; i < flux.values.size(); ++i) {
    const auto& f = flux.values[i];
    if (way[i] < 0.0 || !(f[0] > 0.0)) continue;
    for (std::size_t c = 1; c < 3; ++c)
      worst =
          std::max(worst, std::fabs(f[c] / f[0] / std::exp(-(absorption[c] - absorption[0]) * way[i]) - 1.0));
  }
  return worst;
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

VertexWeights weights_under_lamp(double distance) {
  constexpr int kVertices = 20'000;
  const double sine = 1.0 / (distance * distance), tangent = sine / (1.0 - sine);  // of the rim, squared
  VertexWeights weights;
  for (int i = 0; i < kVertices; ++i) {
    const double t = (i + 0.5) / kVertices * tangent;
    weights.flux.push_back(1.0 / ((1.0 + t) * std::sqrt(1.0 + t)));
    weights.literal.push_back(std::sqrt(std::max(0.0, 1.0 - t / ((1.0 + t) * sine))));
  }
  const double mean = sum_of(weights.flux) / kVertices;
  for (double& literal : weights.literal) literal *= mean;
  return weights;
}

WeightErrors weight_errors(const VertexWeights& weights) {
  const auto apart = [](const std::vector<double>& a, const std::vector<double>& b) {
    const double all_a = sum_of(a), all_b = sum_of(b);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::fabs(a[i] / all_a - b[i] / all_b);
    return sum;
  };
  std::vector<double> with_cosine;
  for (std::size_t i = 0; i < weights.flux.size(); ++i)
    with_cosine.push_back(weights.flux[i] * weights.literal[i]);
  return {apart(weights.literal, with_cosine), apart(weights.literal, weights.flux)};
}

double worst_of_lattice(const Texels& t) {
  const auto at = [&](int x, int y) -> const std::array<double, 4>& {
    return t.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(t.width) +
                    static_cast<std::size_t>(x)];
  };
  double height = 0.0, worst = 0.0;
  for (const auto& p : t.values) height += p[1] / static_cast<double>(t.values.size());
  const auto &first = at(0, 0), &last = at(t.width - 1, t.height - 1), &right = at(t.width - 1, 0);
  for (int y = 0; y < t.height; ++y)
    for (int x = 0; x < t.width; ++x) {
      const double across = x / (t.width - 1.0), down = y / (t.height - 1.0);
      for (const std::size_t c : {0, 2}) {
        const double expected = first[c] + across * (right[c] - first[c]) + down * (last[c] - right[c]);
        worst = std::max(worst, std::fabs(at(x, y)[c] - expected));
      }
      worst = std::max(worst, std::fabs(at(x, y)[1] - height));
    }
  return worst;
}

}  // namespace caustics::paper
