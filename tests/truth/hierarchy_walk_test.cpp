// The walk through the hierarchy that shaders do in single precision, against the light tracer's own walk in
// double precision, and against Embree.
#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/scene/triangle_tree.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"
#include "tests/support/ray_queries.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Scenes are 2 m wide. Single precision has 24 bits: coordinates have a rounding error of 6e-8 m, differences
// and products of a few of them 10 times as much, in all three axes.
constexpr double kRounding = 2e-6;  // metres
// What boxes are larger by, as in a frame (pipeline/renderer/scene_on_device.cpp): a ray that rounding puts
// on a triangle must meet the box around it too.
constexpr float kTouch = 4e-6f;

HierarchyTables tables_of(const Mesh& mesh, float touch = kTouch) {
  HierarchyBench bench;
  bench.touch = touch;
  return bench.caster(mesh).tables();
}

// The same numbers from every standard library.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  float between(float lower, float upper) {
    return lower + (upper - lower) * (static_cast<float>(random_() >> 8) / 16777216.0f);
  }
  glm::vec3 in_box(float half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  glm::vec3 direction() {
    glm::vec3 way = in_box(1.0f);
    while (glm::length(way) < 0.1f || glm::length(way) > 1.0f) way = in_box(1.0f);
    return glm::normalize(way);
  }

 private:
  std::mt19937 random_;
};

// A closed ball of 1280 triangles with bumps of a tenth of its radius.
Mesh bumpy_ball() {
  Mesh mesh = sphere({0.0, 0.0, 0.0}, 0.9, 3, 0);
  for (Vertex& vertex : mesh.vertices) {
    const glm::vec3 p = 7.0f * vertex.position;
    vertex.position *= 1.0f + 0.1f * std::sin(p.x) * std::sin(p.y + 1.0f) * std::sin(p.z + 2.0f);
  }
  return mesh;
}

// Triangles of at most 0.2 m anywhere in a cube of 2 m.
Mesh soup(int triangles) {
  Numbers numbers(1);
  std::vector<Corners> corners;
  for (int i = 0; i < triangles; ++i) {
    const glm::vec3 middle = numbers.in_box(0.9f);
    corners.push_back(
        {middle + numbers.in_box(0.1f), middle + numbers.in_box(0.1f), middle + numbers.in_box(0.1f)});
  }
  return mesh_of(corners);
}

Corners corners_of(const Mesh& mesh, std::size_t triangle) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.vertices[mesh.indices[3 * triangle + k]].position;
  return corners;
}

// How near a ray comes to a triangle's border, metres: as the ray sees them.
double metres_from_border(const AimedRay& ray, const Corners& corners) {
  const auto axes = axes_across(glm::normalize(glm::dvec3(ray.direction)));
  std::array<glm::dvec2, 3> seen;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 way = glm::dvec3(corners[k]) - glm::dvec3(ray.start);
    seen[k] = {glm::dot(way, axes[0]), glm::dot(way, axes[1])};
  }
  double nearest = 1e30;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 a = seen[k], edge = seen[(k + 1) % 3] - a;
    const double t = std::clamp(-glm::dot(a, edge) / std::max(glm::dot(edge, edge), 1e-300), 0.0, 1.0);
    nearest = std::min(nearest, glm::length(a + edge * t));
  }
  return nearest;
}

// How far a distance along a ray is off a triangle's plane, metres across the plane.
double metres_off_plane(const AimedRay& ray, const Corners& corners, double distance) {
  const glm::dvec3 a(corners[0]), b(corners[1]), c(corners[2]);
  const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
  return std::fabs(glm::dot(glm::dvec3(ray.start) + glm::dvec3(ray.direction) * distance - a, normal));
}

// What a walk meets; triangle -1: nothing.
struct Met {
  int triangle = -1;
  double distance = 1e30;
  Met() = default;
  explicit Met(const glm::vec4& found) : triangle(static_cast<int>(found.w) - 1) {
    if (triangle >= 0) distance = static_cast<double>(found.z);
  }
  explicit Met(const std::optional<TriangleHit>& hit) {
    if (hit) *this = Met(hit->id.triangle, hit->distance);
  }
  explicit Met(const std::optional<tracer::SurfaceHit>& hit) {
    if (hit) *this = Met(hit->triangle, hit->distance);
  }

 private:
  Met(int number, double metres) : triangle(number), distance(metres) {}
};

// Are two walks apart by no more than rounding? They meet the same triangle, or such as are equally far, or
// the nearer of both is met at its border, or at the ray's start, so that it may as well lie behind.
bool equal_but_for_rounding(const Mesh& mesh, const AimedRay& ray, const Met& a, const Met& b) {
  if (a.triangle == b.triangle || std::fabs(a.distance - b.distance) <= kRounding) return true;
  if (std::min(a.distance, b.distance) <= kRounding) return true;
  const int nearer = a.distance <= b.distance ? a.triangle : b.triangle;
  return metres_from_border(ray, corners_of(mesh, static_cast<std::size_t>(nearer))) <= kRounding;
}

struct Comparison {
  int met = 0;       // rays that meet something, by the walk in double precision
  int others = 0;    // of all rays: those that meet another triangle, or only one of both walks meets one
  int wrong = 0;     // of these: more than rounding apart
  double off = 0.0;  // the largest distance from the plane of the triangle that is met
};

Comparison compare(const Mesh& mesh, const std::vector<AimedRay>& rays) {
  HierarchyBench bench;
  bench.caster(mesh);
  const std::vector<glm::vec4> found = walk(tables_of(mesh), rays);
  const TriangleTree tree(bench.scene, {0});
  Comparison result;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Met own(tree.nearest(glm::dvec3(rays[i].start), glm::dvec3(rays[i].direction))), other(found[i]);
    result.met += own.triangle >= 0;
    if (other.triangle >= 0)
      result.off = std::max(
          result.off, metres_off_plane(rays[i], corners_of(mesh, static_cast<std::size_t>(other.triangle)),
                                       other.distance));
    result.others += own.triangle != other.triangle;
    result.wrong += !equal_but_for_rounding(mesh, rays[i], own, other);
  }
  return result;
}

struct EmbreeComparison {
  std::int64_t met = 0;     // rays that meet something, by the walk
  std::int64_t others = 0;  // of all rays: those that meet another triangle than Embree's
  // Of these: more than rounding away from the walk in double precision.
  std::int64_t walk_wrong = 0, embree_wrong = 0;
};

EmbreeComparison compare_with_embree(const Mesh& mesh, const std::vector<AimedRay>& rays) {
  HierarchyBench bench;
  bench.caster(mesh);
  const tracer::RaySet embree(bench.scene, {0});
  const std::vector<glm::vec4> found = walk(tables_of(mesh), rays);
  const TriangleTree tree(bench.scene, {0});
  EmbreeComparison result;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const glm::dvec3 start(rays[i].start), direction(rays[i].direction);
    const Met walked(found[i]), other(embree.nearest({start, direction}, 0.0, 1e30));
    result.met += walked.triangle >= 0;
    if (walked.triangle == other.triangle) continue;
    ++result.others;
    const Met right(tree.nearest(start, direction));
    result.walk_wrong += !equal_but_for_rounding(mesh, rays[i], right, walked);
    result.embree_wrong += !equal_but_for_rounding(mesh, rays[i], right, other);
  }
  return result;
}

std::vector<AimedRay> random_rays(int count, float half, unsigned seed) {
  Numbers numbers(seed);
  std::vector<AimedRay> rays;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 start = numbers.in_box(half);
    rays.push_back({.start = start, .direction = numbers.direction()});
  }
  return rays;
}

// Each towards a place on an edge.
std::vector<AimedRay> onto_edges(const Mesh& mesh, int count, float half, unsigned seed) {
  Numbers numbers(seed);
  std::vector<AimedRay> rays;
  for (int i = 0; i < count; ++i) {
    const auto triangle = static_cast<std::size_t>(i) % (mesh.indices.size() / 3);
    const Corners corners = corners_of(mesh, triangle);
    const auto k = static_cast<std::size_t>(numbers.between(0.0f, 3.0f)) % 3;
    const glm::vec3 at = corners[k] + (corners[(k + 1) % 3] - corners[k]) * numbers.between(0.0f, 1.0f);
    const glm::vec3 start = numbers.in_box(half);
    rays.push_back({.start = start, .direction = glm::normalize(at - start)});
  }
  return rays;
}

}  // namespace

TEST_CASE("hierarchy walk: 100,000 rays from within a bumpy ball meet what they meet in double precision") {
  // From a cube of 0.8 m, whose corners are 0.7 m off the middle; the ball's surface is 0.8 m off, or more.
  const Comparison all = compare(bumpy_ball(), random_rays(100'000, 0.4f, 2));
  CHECK(all.met == 100'000);
  CHECK(all.wrong == 0);
  CHECK(all.others < 10);
  CHECK(all.off < kRounding);
}

TEST_CASE("hierarchy walk: 100,000 rays into a soup of triangles meet what they meet in double precision") {
  const Comparison all = compare(soup(2000), random_rays(100'000, 1.0f, 3));
  CHECK(all.met > 40'000);
  CHECK(all.wrong == 0);
  CHECK(all.others < 10);
  CHECK(all.off < kRounding);
}

TEST_CASE("hierarchy walk: of a million rays at most 100 meet another triangle than with Embree") {
  // By rounding, which moves a ray by 1e-7 m. Edges that it may cross unnoticed make up, seen from anywhere,
  // at most 1e-7 m times their length over the area: 2000 triangles of 0.2 m have 600 m of them on the 8 m^2
  // that a ray crosses, so that 8 of a million rays are in doubt.
  need_ray_queries();
  for (const auto& [mesh, half] : {std::pair{bumpy_ball(), 0.4f},
                                   {ring(0.7, 0.8, 1.2, 192, 0), 0.9f},
                                   {soup(2000), 1.0f},
                                   {sphere({0.0, 0.0, 0.0}, 0.9, 5, 0), 1.0f}}) {
    INFO(mesh.name << ", " << mesh.indices.size() / 3 << " triangles");
    const EmbreeComparison all = compare_with_embree(mesh, random_rays(250'000, half, 7));
    CHECK(all.met > 50'000);
    CHECK(all.others <= 25);
    CHECK(all.walk_wrong == 0);
  }
}

TEST_CASE(
    "hierarchy walk: rays onto edges meet one of the triangles there, or pass where rounding has it so") {
  const Mesh ball = bumpy_ball(), triangles = soup(2000);
  const Comparison closed = compare(ball, onto_edges(ball, 30'000, 0.4f, 5));
  CHECK(closed.met == 30'000);
  CHECK(closed.wrong == 0);
  CHECK(closed.off < kRounding);
  const Comparison open = compare(triangles, onto_edges(triangles, 30'000, 1.0f, 6));
  CHECK(open.wrong == 0);
  CHECK(open.off < kRounding);
  // Rounding decides often here: of rays onto an edge a third meet the other triangle.
  CHECK(closed.others > 1000);
  CHECK(open.others > 1000);
}

TEST_CASE("hierarchy walk: no ray from within a closed ball slips through an edge or a corner") {
  // Onto the first end of each triangle's edges, and three places between; from its middle and two places
  // beside it.
  const Mesh mesh = bumpy_ball();
  Numbers numbers(4);
  std::vector<AimedRay> rays;
  std::vector<float> metres;
  for (const glm::vec3& start : {glm::vec3(0.0f), numbers.in_box(0.4f), numbers.in_box(0.4f)})
    for (std::size_t t = 0; 3 * t < mesh.indices.size(); ++t) {
      const Corners corners = corners_of(mesh, t);
      for (std::size_t k = 0; k < 3; ++k)
        for (const float part : {0.0f, 0.3f, 0.5f, 1.0f / 7.0f}) {
          const glm::vec3 at = corners[k] + (corners[(k + 1) % 3] - corners[k]) * part;
          rays.push_back({.start = start, .direction = glm::normalize(at - start)});
          metres.push_back(glm::length(at - start));
        }
    }
  const std::vector<glm::vec4> found = walk(tables_of(mesh), rays);
  int lost = 0, elsewhere = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    lost += !(found[i].w > 0.0f);
    // A bump may stand before the place that a ray is aimed at, nothing behind it may be met.
    elsewhere += found[i].z > metres[i] + static_cast<float>(kRounding);
  }
  CHECK(lost == 0);
  CHECK(elsewhere == 0);
}

TEST_CASE("hierarchy walk: a tree as deep as it may be is walked to its end") {
  // Each triangle is half as large and half as far from x = 0 as the one before, from 2^60 m to 2^-60 m:
  // every split parts few from the rest, and the last of them is there 4096 times. Rays straight down onto
  // each of them.
  std::vector<Corners> deep;
  std::vector<AimedRay> rays;
  for (int i = 60; i >= -60; --i) {
    const float x = std::ldexp(1.0f, i);
    deep.push_back({{{x, 0.0f, -x}, {x, 0.0f, x}, {1.5f * x, 0.0f, 0.0f}}});
    rays.push_back({.start = {1.125f * x, 1.0f, 0.0f}});
  }
  deep.insert(deep.end(), 4095, Corners(deep.back()));
  const std::vector<glm::vec4> found = walk(tables_of(mesh_of(deep), 0.0f), rays);
  int wrong = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) wrong += found[i].w != static_cast<float>(i + 1);
  CHECK(wrong == 0);
}
