#include "lab/metrics/flip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lab/metrics/flip_color.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

using flip::Color;

constexpr double kColorExponent = 0.7, kFeatureExponent = 0.5;
// The colour difference at 0.4 of the largest becomes 0.95.
constexpr double kKnee = 0.4, kKneeValue = 0.95;
// From peak to trough of the eye's edge detector, degrees.
constexpr double kFeatureWidth = 0.082;

// Values a pixel, row by row.
struct Field {
  int width = 0, height = 0;
  std::vector<double> values;

  Field(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  double* row(int y) { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
  const double* row(int y) const { return const_cast<Field*>(this)->row(y); }
};

// Weights at -radius..radius.
using Kernel = std::vector<double>;

int radius_of(const Kernel& kernel) { return static_cast<int>(kernel.size() / 2); }

Kernel sampled(int radius, const auto& weight) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(weight(static_cast<double>(x)));
  return kernel;
}

double sum_of(const Kernel& kernel) {
  double sum = 0.0;
  for (const double weight : kernel) sum += weight;
  return sum;
}

// Rows, pixels beyond the border being those on it.
Field along_rows(const Field& field, const Kernel& kernel) {
  const int radius = radius_of(kernel);
  Field result(field.width, field.height);
  std::vector<double> padded(static_cast<std::size_t>(field.width) + kernel.size() - 1);
  for (int y = 0; y < field.height; ++y) {
    const double* from = field.row(y);
    for (int x = -radius; x < field.width + radius; ++x) {
      const int at = x + radius;
      padded[static_cast<std::size_t>(at)] = from[std::clamp(x, 0, field.width - 1)];
    }
    double* to = result.row(y);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      for (int x = 0; x < field.width; ++x) {
        to[x] += kernel[k] * padded[static_cast<std::size_t>(x) + k];
      }
    }
  }
  return result;
}

Field along_columns(const Field& field, const Kernel& kernel) {
  const int radius = radius_of(kernel);
  Field result(field.width, field.height);
  for (int y = 0; y < field.height; ++y) {
    double* to = result.row(y);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const double* from = field.row(std::clamp(y + static_cast<int>(k) - radius, 0, field.height - 1));
      for (int x = 0; x < field.width; ++x) to[x] += kernel[k] * from[x];
    }
  }
  return result;
}

Field convolved(const Field& field, const Kernel& across, const Kernel& down) {
  return along_columns(along_rows(field, across), down);
}

// One of the Gaussians that a contrast sensitivity function is made of (table 1 of the paper):
// a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees.
struct Sensitivity {
  double a, b;
};

// The filter of one opponent channel: a sum of round Gaussians, whose weights add up to 1.
Field blurred(const Field& field, const std::vector<Sensitivity>& gaussians, double per_degree) {
  // All filters are as wide as the widest one: three standard deviations of b = 0.04.
  const int radius =
      static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * exact::kPi * exact::kPi)) * per_degree));
  Field result(field.width, field.height);
  double total = 0.0;
  for (const Sensitivity& each : gaussians) {
    const Kernel kernel = sampled(radius, [&](double x) {
      return std::exp(-exact::kPi * exact::kPi * (x / per_degree) * (x / per_degree) / each.b);
    });
    const double weight = each.a * std::sqrt(exact::kPi / each.b), sum = sum_of(kernel);
    const Field part = convolved(field, kernel, kernel);
    for (std::size_t i = 0; i < part.values.size(); ++i) {
      result.values[i] += weight * part.values[i];
    }
    total += weight * sum * sum;
  }
  for (double& value : result.values) value /= total;
  return result;
}

using Opponent = std::array<Field, 3>;

Opponent opponent_of(const Image& picture) {
  const Field empty(picture.width(), picture.height());
  Opponent fields = {empty, empty, empty};
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      Color linear;
      for (int c = 0; c < 3; ++c) {
        linear[static_cast<std::size_t>(c)] =
            flip::linear_from_srgb(static_cast<double>(picture.at(x, y, c)));
      }
      const Color color = flip::ycxcz_from_linear(linear);
      for (std::size_t c = 0; c < 3; ++c) fields[c].row(y)[x] = color[c];
    }
  }
  return fields;
}

// What the eye is left with: blurred, then Hunt-adjusted L*a*b*, pixel by pixel.
std::vector<Color> seen(const Opponent& picture, double per_degree) {
  const Opponent soft = {blurred(picture[0], {{1.0, 0.0047}}, per_degree),
                         blurred(picture[1], {{1.0, 0.0053}}, per_degree),
                         blurred(picture[2], {{34.1, 0.04}, {13.5, 0.025}}, per_degree)};
  std::vector<Color> colors(soft[0].values.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    Color linear = flip::linear_from_ycxcz({soft[0].values[i], soft[1].values[i], soft[2].values[i]});
    for (double& channel : linear) channel = std::clamp(channel, 0.0, 1.0);
    colors[i] = flip::hunt_lab_from_linear(linear);
  }
  return colors;
}

// 0..1, of a distance in Hunt-adjusted L*a*b*.
double color_error(double distance) {
  static const double largest = std::pow(
      flip::hyab(flip::hunt_lab_from_linear({0.0, 1.0, 0.0}), flip::hunt_lab_from_linear({0.0, 0.0, 1.0})),
      kColorExponent);
  const double power = std::pow(distance, kColorExponent), knee = kKnee * largest;
  if (power < knee) return kKneeValue / knee * power;
  return std::min(1.0, kKneeValue + (power - knee) / (largest - knee) * (1.0 - kKneeValue));
}

// Positive weights sum to 1, negative ones to -1.
Kernel balanced(Kernel kernel) {
  double positive = 0.0, negative = 0.0;
  for (const double weight : kernel) (weight > 0.0 ? positive : negative) += weight;
  for (double& weight : kernel) weight /= weight > 0.0 ? positive : -negative;
  return kernel;
}

// How strong an edge (or a point) stands at each pixel: the length of the responses across and
// down.
struct Features {
  Field edges, points;
};

Field strength(const Field& luma, const Kernel& detector, const Kernel& smooth) {
  Field across = convolved(luma, detector, smooth);
  const Field down = convolved(luma, smooth, detector);
  for (std::size_t i = 0; i < across.values.size(); ++i) {
    across.values[i] = std::sqrt(across.values[i] * across.values[i] + down.values[i] * down.values[i]);
  }
  return across;
}

Features features_of(const Field& y_channel, double per_degree) {
  Field luma = y_channel;
  for (double& value : luma.values) value = (value + 16.0) / 116.0;
  const double deviation = 0.5 * kFeatureWidth * per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  const auto gauss = [&](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
  Kernel smooth = sampled(radius, gauss);
  const double sum = sum_of(smooth);
  for (double& weight : smooth) weight /= sum;
  const Kernel edge = balanced(sampled(radius, [&](double x) { return -x * gauss(x); }));
  const Kernel point =
      balanced(sampled(radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gauss(x); }));
  return {strength(luma, edge, smooth), strength(luma, point, smooth)};
}

// 0..1: an edge or a point that only one picture has.
double feature_error(const Features& a, const Features& b, std::size_t i) {
  const double difference = std::max(std::abs(a.edges.values[i] - b.edges.values[i]),
                                     std::abs(a.points.values[i] - b.points.values[i]));
  return std::min(1.0, std::pow(difference / std::sqrt(2.0), kFeatureExponent));
}

}  // namespace

Image flip_map(const Image& test, const Image& reference, double pixels_per_degree) {
  const Opponent a = opponent_of(test), b = opponent_of(reference);
  const std::vector<Color> seen_a = seen(a, pixels_per_degree), seen_b = seen(b, pixels_per_degree);
  const Features of_a = features_of(a[0], pixels_per_degree);
  const Features of_b = features_of(b[0], pixels_per_degree);
  Image map(Format::R32F, test.width(), test.height());
  for (std::size_t i = 0; i < seen_a.size(); ++i) {
    const double color = color_error(flip::hyab(seen_a[i], seen_b[i]));
    if (color == 0.0) continue;
    map.values[i] = static_cast<float>(std::pow(color, 1.0 - feature_error(of_a, of_b, i)));
  }
  return map;
}

FlipFigures flip_figures(const Image& map, std::span<const std::uint8_t> mask) {
  std::vector<float> errors;
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (mask.empty() || mask[i] != 0) errors.push_back(map.values[i]);
  }
  std::sort(errors.begin(), errors.end());
  double sum = 0.0;
  for (const float error : errors) sum += static_cast<double>(error);
  FlipFigures figures;
  if (sum == 0.0) return figures;
  figures.mean = sum / static_cast<double>(errors.size());
  figures.largest = static_cast<double>(errors.back());
  const std::pair<double, double*> shares[] = {
      {0.25, &figures.first_quartile}, {0.5, &figures.median}, {0.75, &figures.third_quartile}};
  for (const auto& [share, figure] : shares) {
    double reached = 0.0;
    for (const float error : errors) {
      reached += static_cast<double>(error);
      *figure = static_cast<double>(error);
      if (reached >= share * sum) break;
    }
  }
  return figures;
}

}  // namespace caustics
