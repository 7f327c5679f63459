#include "pipeline/scene/emitter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/low_discrepancy.hpp"

namespace caustics {

namespace {

constexpr double kBrightest = 1e12;  // candela, as of the lights in files

struct Corners {
  glm::dvec3 a, b, c;
  // Along the outward normal, twice the triangle's area long.
  glm::dvec3 normal() const { return exact::cross(b - a, c - a); }
};

Corners corners_of(const Mesh& mesh, std::size_t triangle) {
  const auto at = [&](std::size_t i) {
    return glm::dvec3(mesh.vertices[mesh.indices[3 * triangle + i]].position);
  };
  return {at(0), at(1), at(2)};
}

constexpr int kMeanPoints = 4096;  // that a texture is averaged by

std::size_t texel_along(double coordinate, Wrap wrap, int texels) {
  const double turns = coordinate * 0.5 - std::floor(coordinate * 0.5);
  double place = coordinate - std::floor(coordinate);
  if (wrap == Wrap::Clamp) place = std::clamp(coordinate, 0.0, 1.0);
  if (wrap == Wrap::Mirror) place = 2.0 * std::min(turns, 1.0 - turns);
  return static_cast<std::size_t>(std::clamp(static_cast<int>(place * texels), 0, texels - 1));
}

glm::dvec3 texel_at(const Image& image, const TextureUse& use, const glm::dvec2& uv) {
  const glm::dmat3 to_texture(use.uv_transform);
  const double u = (to_texture[0].x * uv.x + to_texture[1].x * uv.y) + to_texture[2].x;
  const double v = (to_texture[0].y * uv.x + to_texture[1].y * uv.y) + to_texture[2].y;
  const auto x = static_cast<int>(texel_along(u, use.wrap_u, image.width()));
  const auto y = static_cast<int>(texel_along(v, use.wrap_v, image.height()));
  glm::dvec3 color;
  for (int c = 0; c < 3; ++c)
    color[c] = static_cast<double>(image.at(x, y, std::min(c, image.channels() - 1)));
  return color;
}

// A point that may be chosen, with what makes it near to another: place and normal.
struct Candidate {
  SurfacePoint point;
  std::array<double, 6> near;
  int number;
};

constexpr int kCandidates = 64;  // a chosen point
// Opposite normals are as far apart as half the mesh.
constexpr double kTurn = 0.25;

std::vector<Candidate> candidates_of(const std::vector<SurfacePoint>& points, const Mesh& mesh) {
  const double size = 2.0 * std::max(bounds_of(mesh).radius(), 1e-30);
  std::vector<Candidate> candidates;
  for (const SurfacePoint& p : points) {
    const glm::dvec3 place = p.position / size, turn = kTurn * p.normal;
    candidates.push_back(
        {p, {place.x, place.y, place.z, turn.x, turn.y, turn.z}, static_cast<int>(candidates.size())});
  }
  return candidates;
}

std::size_t widest_axis(const Candidate* first, const Candidate* last) {
  std::size_t widest = 0;
  double most = -1.0;
  for (std::size_t axis = 0; axis < 6; ++axis) {
    double lower = first->near[axis], upper = lower;
    for (const Candidate* c = first; c != last; ++c) {
      lower = std::min(lower, c->near[axis]);
      upper = std::max(upper, c->near[axis]);
    }
    if (upper - lower > most) {
      most = upper - lower;
      widest = axis;
    }
  }
  return widest;
}

// The candidate that looks most as all do on the mean, so that the light has the right strength in
// every direction; anywhere among those that look alike, because the middles of cells would line
// up.
SurfacePoint typical(const Candidate* first, const Candidate* last) {
  glm::dvec3 sum(0.0);
  for (const Candidate* c = first; c != last; ++c) sum += c->point.normal;
  const glm::dvec3 mean = exact::normalise(sum, first->point.normal);
  // As a float, so that the normals of a flat mesh are all alike.
  const auto alike = [&](const Candidate& c) { return static_cast<float>(exact::dot(c.point.normal, mean)); };
  return std::min_element(first, last,
                          [&](const Candidate& a, const Candidate& b) {
                            if (alike(a) != alike(b)) return alike(a) > alike(b);
                            return stepped(a.number, kGoldenStep) < stepped(b.number, kGoldenStep);
                          })
      ->point;
}

// Halves the candidates across their widest extent until there is a cell for each point wanted.
void choose(Candidate* first, Candidate* last, int count, std::vector<SurfacePoint>& chosen) {
  if (count == 1) {
    chosen.push_back(typical(first, last));
    return;
  }
  const std::size_t axis = widest_axis(first, last);
  std::sort(first, last, [axis](const Candidate& a, const Candidate& b) {
    return a.near[axis] != b.near[axis] ? a.near[axis] < b.near[axis] : a.number < b.number;
  });
  const int half = count / 2;
  Candidate* middle = first + (last - first) * half / count;
  choose(first, middle, half, chosen);
  choose(middle, last, count - half, chosen);
}

// The candidate nearest to the mean place.
SurfacePoint middle_of(const std::vector<Candidate>& all) {
  glm::dvec3 mean(0.0);
  for (const Candidate& c : all) mean += c.point.position / static_cast<double>(all.size());
  const auto distance = [&](const Candidate& c) { return exact::length(c.point.position - mean); };
  return std::min_element(all.begin(), all.end(),
                          [&](const Candidate& a, const Candidate& b) { return distance(a) < distance(b); })
      ->point;
}

// The smallest rectangle along an edge that holds a flat mesh; nothing where that has two normals.
struct FlatRectangle {
  glm::dvec3 middle{0.0}, width{0.0}, height{0.0}, normal{0.0};
  double area() const { return exact::length(exact::cross(width, height)); }
};

std::optional<FlatRectangle> rectangle_along(const Mesh& mesh, const glm::dvec3& edge,
                                             const glm::dvec3& normal) {
  constexpr double kFlat = 1e-4;
  const glm::dvec3 x = exact::normalise(edge, {1.0, 0.0, 0.0}), y = exact::cross(normal, x);
  const glm::dvec3 origin = corners_of(mesh, 0).a;
  glm::dvec3 lower(0.0), upper(0.0);
  for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
    const Corners corners = corners_of(mesh, t);
    const glm::dvec3 across = corners.normal();
    if (exact::dot(across, normal) < (1.0 - kFlat) * exact::length(across)) return {};
    for (const glm::dvec3& p : {corners.a, corners.b, corners.c}) {
      const glm::dvec3 q = p - origin, at{exact::dot(q, x), exact::dot(q, y), exact::dot(q, normal)};
      lower = glm::min(lower, at);
      upper = glm::max(upper, at);
    }
  }
  const glm::dvec3 size = upper - lower, middle = 0.5 * (lower + upper);
  if (size.z > kFlat * std::max(size.x, size.y)) return {};
  return FlatRectangle{origin + x * middle.x + y * middle.y + normal * middle.z, x * size.x, y * size.y,
                       normal};
}

double outside(double x, float lower, float upper) {
  return std::max({static_cast<double>(lower) - x, x - static_cast<double>(upper), 0.0});
}

bool box_is_near(const glm::vec3& lower, const glm::vec3& upper, const glm::dvec3& p, double radius) {
  const glm::dvec3 way{outside(p.x, lower.x, upper.x), outside(p.y, lower.y, upper.y),
                       outside(p.z, lower.z, upper.z)};
  return exact::length(way) < radius;
}

// A cautious test of whether a mesh comes nearer to a point than `radius`: both the box and the plane of one
// of its triangles do.
bool may_reach(const Mesh& mesh, const glm::dvec3& p, double radius) {
  if (!box_is_near(mesh.lower, mesh.upper, p, radius)) return false;
  for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
    const Corners corners = corners_of(mesh, t);
    const glm::vec3 lower(glm::min(glm::min(corners.a, corners.b), corners.c));
    const glm::vec3 upper(glm::max(glm::max(corners.a, corners.b), corners.c));
    if (!box_is_near(lower, upper, p, radius)) continue;
    const glm::dvec3 normal = exact::normalise(corners.normal(), glm::dvec3(0.0));
    if (std::fabs(exact::dot(p - corners.a, normal)) < radius) return true;
  }
  return false;
}

}  // namespace

Emitter::Emitter(const Scene& scene, int mesh)
    : scene_(scene),
      mesh_(scene.meshes[static_cast<std::size_t>(mesh)]),
      material_(scene.materials[static_cast<std::size_t>(mesh_.material)]) {
  const std::size_t triangles = mesh_.indices.size() / 3;
  // The inner side of a closed mesh lights nothing outside.
  if (material_.double_sided && !mesh_.closed()) sides_ = 2;
  double sum = 0.0;
  sums_.reserve(sides_ * triangles);
  for (std::size_t i = 0; i < sides_ * triangles; ++i) {
    sum += 0.5 * exact::length(corners_of(mesh_, i % triangles).normal());
    sums_.push_back(sum);
  }
}

glm::vec3 Emitter::radiance() const {
  if (!material_.emissive_texture.present()) return material_.emissive;
  const Image& image = scene_.images[static_cast<std::size_t>(material_.emissive_texture.image)];
  glm::dvec3 sum(0.0);
  for (const SurfacePoint& p : even(kMeanPoints)) sum += texel_at(image, material_.emissive_texture, p.uv);
  return material_.emissive * glm::vec3(sum / static_cast<double>(kMeanPoints));
}

SurfacePoint Emitter::point(double along, double u, double v) const {
  const std::size_t triangles = mesh_.indices.size() / 3;
  const auto found = std::upper_bound(sums_.begin(), sums_.end(), along * area());
  const std::size_t side = std::min(static_cast<std::size_t>(found - sums_.begin()), sums_.size() - 1);
  const Corners t = corners_of(mesh_, side % triangles);
  // Uniform on a triangle: the square's far half is folded back.
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const auto uv = [&](std::size_t corner) {
    return glm::dvec2(mesh_.vertices[mesh_.indices[3 * (side % triangles) + corner]].uv);
  };
  return {t.a + (t.b - t.a) * u + (t.c - t.a) * v,
          exact::normalise(side < triangles ? t.normal() : -t.normal(), {0, -1, 0}),
          uv(0) + (uv(1) - uv(0)) * u + (uv(2) - uv(0)) * v};
}

// The points lie evenly over the area; their order means nothing.
std::vector<SurfacePoint> Emitter::even(int count) const {
  std::vector<SurfacePoint> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    points.push_back(point(stratum(k, count), stepped(k, kPairStep1), stepped(k, kPairStep2)));
  return points;
}

std::vector<SurfacePoint> Emitter::spread(int count) const {
  std::vector<Candidate> cell = candidates_of(even(kCandidates * count), mesh_);
  if (count == 1) return {middle_of(cell)};
  std::vector<SurfacePoint> chosen;
  choose(cell.data(), cell.data() + cell.size(), count, chosen);
  return chosen;
}

std::vector<SurfacePoint> Emitter::list(int count) const {
  std::vector<Candidate> all = candidates_of(even(count), mesh_);
  std::vector<SurfacePoint> points;
  choose(all.data(), all.data() + all.size(), count, points);
  return points;
}

bool Emitter::make_rectangle(Light& light) const {
  constexpr double kFull = 1e-3;
  if (mesh_.closed() || mesh_.indices.size() < 6) return false;
  const Corners first = corners_of(mesh_, 0);
  const glm::dvec3 normal = exact::normalise(first.normal(), glm::dvec3(0.0));
  for (const glm::dvec3& edge : {first.b - first.a, first.c - first.b, first.a - first.c}) {
    const std::optional<FlatRectangle> found = rectangle_along(mesh_, edge, normal);
    const double side = area() / static_cast<double>(sides_);
    if (!found || !(std::fabs(found->area() - side) < kFull * side)) continue;
    light.position = found->middle;
    light.width = found->width;
    light.height = found->height;
    light.direction = normal;
    return true;
  }
  return false;
}

bool Emitter::make_ball(Light& light) const {
  constexpr double kRound = 0.01;
  if (!mesh_.closed() || mesh_.inside_out) return false;
  const glm::dvec3 middle = bounds_of(mesh_).centre();
  double nearest = exact::length(glm::dvec3(mesh_.vertices.front().position) - middle), farthest = nearest;
  for (const Vertex& v : mesh_.vertices) {
    const double distance = exact::length(glm::dvec3(v.position) - middle);
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  // Not a cube, whose corners are as far away.
  const double radius = std::sqrt(area() / (4.0 * exact::kPi));
  if (nearest < (1.0 - kRound) * farthest || radius < (1.0 - 2.0 * kRound) * farthest) return false;
  for (const Mesh& other : scene_.meshes)
    if (&other != &mesh_ && may_reach(other, middle, radius)) return false;
  light.position = middle;
  light.direction = {0.0, -1.0, 0.0};
  light.radius = radius;
  return true;
}

bool shines(const Scene& scene, const Mesh& mesh) {
  const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
  const float brightest = std::max({material.emissive.x, material.emissive.y, material.emissive.z});
  return brightest > 0.0f && !material.unlit && !mesh.indices.empty();
}

Light light_of_mesh(const Scene& scene, int number) {
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(number)];
  const Emitter emitter(scene, number);
  const glm::vec3 radiance = emitter.radiance();
  const float brightest = std::max({radiance.x, radiance.y, radiance.z});
  Light light;
  light.name = mesh.name.empty() ? "mesh " + std::to_string(number) : mesh.name;
  light.type = LightType::Point;
  light.shape = LightShape::Mesh;
  light.emitter = number;
  light.color = brightest > 0.0f ? radiance / brightest : glm::vec3(1.0f);
  // A Lambertian surface of luminance L and area A gives L A cos candela.
  light.intensity = static_cast<float>(std::min(static_cast<double>(brightest) * emitter.area(), kBrightest));
  light.position = bounds_of(mesh).centre();
  if (!emitter.make_ball(light)) emitter.make_rectangle(light);
  return light;
}

std::vector<int> lamps_of_points(const Scene& scene) {
  constexpr std::size_t kMostLamps = 64;  // of which each takes 130 kB
  std::vector<int> lamps;
  for (std::size_t i = 0; i < scene.sources.size() && lamps.size() < kMostLamps; ++i)
    if (scene.sources[i].is_lamp()) lamps.push_back(static_cast<int>(i));
  return lamps;
}

void add_emissive_lights(Scene& scene) {
  for (int i = 0; i < static_cast<int>(scene.meshes.size()); ++i) {
    if (!shines(scene, scene.meshes[static_cast<std::size_t>(i)])) continue;
    const Light light = light_of_mesh(scene, i);
    if (light.intensity > 0.0f) scene.lights.push_back(light);
  }
}

}  // namespace caustics
