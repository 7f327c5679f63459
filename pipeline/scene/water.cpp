#include "pipeline/scene/water.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics {

namespace {

constexpr double kCourant = 0.5;
constexpr double kMostStepsPerSecond = 20'000.0;
// Room for waves above and below the level: plops' heights, or shares of the shorter side, so that the
// bounds of calm water have a depth too.
constexpr double kHighestOverPlop = 4.0, kLeastRoom = 1e-3;
constexpr int kMostRows = 4096;
// A sheet rises and falls at rest by at most this share of its shorter side; and its normals' least
// upward part.
constexpr double kFlatness = 0.25, kLeastUpward = 0.5;

// splitmix64 (Steele, Lea, Flood, OOPSLA 2014): a bijection of 64 bits that scatters them.
std::uint64_t scattered(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

// The k-th of the n-th plop's random numbers, from 0 to below 1.
double uniform(std::uint64_t seed, std::int64_t n, std::uint64_t k) {
  const std::uint64_t bits = scattered(scattered(seed) + 4u * static_cast<std::uint64_t>(n) + k);
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

// Somewhere on a side, a radius away from its ends where there is room.
double place(double side, double radius, double u) {
  const double room = std::max(side - 2.0 * radius, 0.0);
  return 0.5 * (side - room) + room * u;
}

struct Rectangle {
  glm::dvec2 lower{1e300}, upper{-1e300};
  double lowest = 1e300, highest = -1e300;
};

Rectangle rectangle_of(const Mesh& mesh, const Water& water) {
  Rectangle r;
  for (const Vertex& v : mesh.vertices) {
    const glm::dvec3 p(v.position);
    const glm::dvec2 q(exact::dot(p, water.right), exact::dot(p, water.across));
    r.lower = glm::min(r.lower, q);
    r.upper = glm::max(r.upper, q);
    r.lowest = std::min(r.lowest, p.y);
    r.highest = std::max(r.highest, p.y);
  }
  return r;
}

// Every triangle becomes four, its edges halved.
void split(Mesh& mesh) {
  mesh.colors.clear();
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, fresh] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                    static_cast<std::uint32_t>(mesh.vertices.size()));
    if (!fresh) return found->second;
    const Vertex &p = mesh.vertices[std::min(a, b)], &q = mesh.vertices[std::max(a, b)];
    Vertex v = p;
    v.position = (p.position + q.position) * 0.5f;
    v.normal = glm::vec3(exact::normalise(glm::dvec3(p.normal) + glm::dvec3(q.normal), glm::dvec3(p.normal)));
    v.uv = (p.uv + q.uv) * 0.5f;
    mesh.vertices.push_back(v);
    return found->second;
  };
  std::vector<std::uint32_t> finer;
  finer.reserve(mesh.indices.size() * 4);
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const std::uint32_t a = mesh.indices[t], b = mesh.indices[t + 1], c = mesh.indices[t + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const std::uint32_t i : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) finer.push_back(i);
  }
  mesh.indices = std::move(finer);
}

double longest_edge(const Mesh& mesh) {
  double longest = 0.0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k)
      longest =
          std::max(longest, exact::length(glm::dvec3(mesh.vertices[mesh.indices[t + k]].position) -
                                          glm::dvec3(mesh.vertices[mesh.indices[t + (k + 1) % 3]].position)));
  return longest;
}

void refine(Mesh& mesh, double longest_allowed, std::size_t most_triangles) {
  double edge = longest_edge(mesh);
  while (edge > longest_allowed && mesh.indices.size() / 3 * 4 <= most_triangles) {
    split(mesh);
    edge *= 0.5;
  }
}

bool within(double value, double least, double most) { return value >= least && value <= most; }

std::string range_problem(const WaterSettings& s) {
  if (!within(s.speed, 0.001, 100.0)) return "speed must be 0.001 to 100 metres a second";
  if (!within(s.damping, 0.0, 1000.0)) return "damping must be 0 to 1000 a second";
  if (s.cells < 8 || s.cells > 2048) return "cells must be 8 to 2048";
  if (!within(s.start, 0.0, 3600.0)) return "start must be 0 to 3600 seconds";
  if (!within(s.interval, 0.01, 1e4)) return "plops.interval must be 0.01 to 10000 seconds";
  return {};
}

std::string shape_problem(const Mesh& mesh, const Rectangle& r) {
  if (mesh.closed()) return "its mesh is closed; water needs an open sheet, the surface alone";
  const glm::dvec2 size = r.upper - r.lower;
  const double shorter = std::min(size.x, size.y);
  if (!(shorter > 1e-6) || r.highest - r.lowest > kFlatness * shorter) {
    return "its mesh is no horizontal sheet (up is +y of the world)";
  }
  for (const Vertex& v : mesh.vertices)
    if (!(static_cast<double>(v.normal.y) >= kLeastUpward)) {
      return "its mesh is no horizontal sheet that faces up (+y of the world); turn its faces over or lay it "
             "flat";
    }
  return {};
}

std::string lay_grid(const Rectangle& r, Water& water) {
  const WaterSettings& s = water.settings;
  const glm::dvec2 size = r.upper - r.lower;
  water.columns = s.cells;
  water.dx = size.x / s.cells;
  const double rows = size.y / water.dx + 0.5;
  if (!(rows < kMostRows))
    return "its sheet is too long for its width: more than 4095 rows of cells; lower cells";
  water.rows = std::max(static_cast<int>(rows), 2);
  water.dz = size.y / water.rows;
  water.corner = water.right * r.lower.x + water.across * r.lower.y;
  const double cell = std::max(water.dx, water.dz), shorter = std::min(size.x, size.y);
  const double half = 0.5 * shorter, least = std::min(3.0 * cell, half);
  water.radius = s.radius.value_or(std::max(shorter / 20.0, least));
  if (!within(water.radius, least * (1.0 - 1e-9), half)) {
    return "plops.radius must be at least 3 cells and at most half the sheet's shorter side";
  }
  water.height = s.height.value_or(water.radius / 5.0);
  if (!within(water.height, 0.0, water.radius)) return "plops.height must be 0 to the plops' radius";
  return {};
}

std::string lay_steps(Water& water) {
  const WaterSettings& s = water.settings;
  const double longest = kCourant * std::min(water.dx, water.dz) / s.speed;
  if (!(longest * kMostStepsPerSecond >= 1.0)) {
    return "its waves need more than 20000 steps a second; lower speed or cells";
  }
  water.steps_per_plop = static_cast<std::int64_t>(std::ceil(s.interval / longest));
  water.step = s.interval / static_cast<double>(water.steps_per_plop);
  const double rise = std::min(water.radius / s.speed, s.interval) / water.step;
  water.plop_steps = std::clamp(static_cast<std::int64_t>(rise), std::int64_t{1}, water.steps_per_plop);
  return {};
}

std::string cost_problem(const Water& water, const WaterLimits& limits) {
  const double cells = static_cast<double>(water.columns) * water.rows;
  if (!(cells <= limits.cells)) return "it has more cells than all waters together may have; lower cells";
  if (!(cells * static_cast<double>(water.steps_until(0.0)) <= limits.updates)) {
    return "its cells have to make too many steps before time 0; lower start, speed or cells";
  }
  return {};
}

}  // namespace

double Water::since_rest(double seconds) const { return std::max(settings.start + seconds, 0.0); }

std::int64_t Water::steps_until(double seconds) const {
  return static_cast<std::int64_t>(std::floor(since_rest(seconds) / step)) + 1;
}

Plop Water::plop(std::int64_t n) const {
  const double size = 0.5 + 0.5 * uniform(settings.seed, n, 2);
  const bool dip = uniform(settings.seed, n, 3) < 0.5;
  return {{place(dx * columns, radius, uniform(settings.seed, n, 0)),
           place(dz * rows, radius, uniform(settings.seed, n, 1))},
          dip ? -height * size : height * size};
}

std::optional<Plop> Water::plop_in_step(std::int64_t number) const {
  if (number < steps_per_plop || number % steps_per_plop >= plop_steps) return {};
  return plop(number / steps_per_plop - 1);
}

std::string add_water(Scene& scene, int index, const glm::dvec3& axis, const WaterSettings& settings,
                      const WaterLimits& limits) {
  Mesh& mesh = scene.meshes[static_cast<std::size_t>(index)];
  Water water{.name = mesh.name, .mesh = index, .settings = settings};
  water.right = exact::normalise({axis.x, 0.0, axis.z}, {1.0, 0.0, 0.0});
  water.across = exact::cross(water.right, {0.0, 1.0, 0.0});
  const Rectangle rectangle = rectangle_of(mesh, water);
  for (const std::string& problem : {range_problem(settings), shape_problem(mesh, rectangle)})
    if (!problem.empty()) return problem;
  if (std::string problem = lay_grid(rectangle, water); !problem.empty()) return problem;
  if (std::string problem = lay_steps(water); !problem.empty()) return problem;
  if (std::string problem = cost_problem(water, limits); !problem.empty()) return problem;
  const glm::dvec2 size = rectangle.upper - rectangle.lower;
  water.highest = std::max(kHighestOverPlop * water.height, kLeastRoom * std::min(size.x, size.y));
  water.before = Image(Format::RG32F, water.columns, water.rows);
  refine(mesh, 1.5 * std::max(water.dx, water.dz), limits.triangles);
  mesh.lower.y -= static_cast<float>(water.highest);
  mesh.upper.y += static_cast<float>(water.highest);
  scene.waters.push_back(std::move(water));
  return {};
}

}  // namespace caustics
