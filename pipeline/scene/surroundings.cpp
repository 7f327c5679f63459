#include "pipeline/scene/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/triangle_tree.hpp"

namespace caustics {

namespace {

constexpr int kPlacesBeside = 16, kEnough = 12;  // around the thing, where a floor is looked for
constexpr double kLevel = 0.7;                   // the least cosine of a floor to the vertical
constexpr double kFlat = 0.8,
                 kSame = 0.98;  // so much of a flat mesh's area has, but for its sign, one normal

double extent(const Bounds& bounds) {
  const glm::dvec3 size = bounds.upper - bounds.lower;
  return std::max({size.x, size.y, size.z});
}

// On the outline of the thing's rectangle seen from above, made larger by so much of its extent.
glm::dvec3 place_beside(const Bounds& thing, double beyond, int place) {
  const double more = beyond * extent(thing);
  const glm::dvec3 half = 0.5 * (thing.upper - thing.lower) + glm::dvec3(more, 0.0, more);
  const double along = (place % 4 + 0.5) / 2.0 - 1.0;
  const glm::dvec2 sides[] = {{along, 1.0}, {1.0, along}, {along, -1.0}, {-1.0, along}};
  const glm::dvec2 side = sides[place / 4];
  return thing.centre() + glm::dvec3(side.x * half.x, 0.0, side.y * half.z);
}

bool is_floor(const Scene& scene, const TriangleTree& tree, const Bounds& thing, double beyond) {
  const glm::dvec3 middle = thing.centre();
  int found = 0;
  for (int place = 0; place < kPlacesBeside; ++place) {
    glm::dvec3 way = place_beside(thing, beyond, place) - middle;
    const auto wall = tree.nearest(middle, way);
    if (wall && wall->distance < 1.0) way = way * (0.5 * wall->distance);
    const auto below = tree.nearest(middle + way, {0.0, -1.0, 0.0});
    if (!below) continue;
    // The inside of a solid is no floor.
    const bool outside = below->front || !scene.meshes[static_cast<std::size_t>(below->id.mesh)].closed();
    if (outside && std::fabs(plane_normal(scene, below->id).y) >= kLevel) ++found;
  }
  return found >= kEnough;
}

bool is_flat(const Mesh& mesh) {
  std::vector<glm::dvec3> faces;  // normals as long as twice their areas
  double area = 0.0, flat = 0.0, largest = 0.0;
  glm::dvec3 normal(0.0);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) {
      return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position);
    };
    const glm::dvec3 face = exact::cross(corner(1) - corner(0), corner(2) - corner(0));
    const double size = exact::length(face);
    area += size;
    faces.push_back(face);
    if (size > largest) {
      largest = size;
      normal = face / size;
    }
  }
  for (const glm::dvec3& face : faces)
    if (std::fabs(exact::dot(face, normal)) >= kSame * exact::length(face)) flat += exact::length(face);
  return area > 0.0 && flat >= kFlat * area;
}

// Seen along its thinnest axis, does the mesh lie behind or before the thing's middle?
bool lies_behind(const Bounds& mesh, const Bounds& thing) {
  const glm::dvec3 size = mesh.upper - mesh.lower, middle = thing.centre();
  const int thinnest = size.y <= size.x && size.y <= size.z ? 1 : size.x <= size.z ? 0 : 2;
  for (int axis = 0; axis < 3; ++axis)
    if (axis != thinnest && !(middle[axis] > mesh.lower[axis] && middle[axis] < mesh.upper[axis]))
      return false;
  return true;
}

double beyond_of(const Mesh& mesh) { return mesh.closed() ? kFloorBeyond : 0.5 * kFloorBeyond; }

bool stands_around(const Scene& scene, int mesh, const Bounds& rest) {
  const Mesh& it = scene.meshes[static_cast<std::size_t>(mesh)];
  return (lies_behind(bounds_of(it), rest) && is_flat(it)) ||
         is_floor(scene, TriangleTree(scene, {mesh}), rest, beyond_of(it));
}

std::vector<int> widest_receivers_first(const Scene& scene) {
  std::vector<int> receivers;
  for (int m = 0; m < static_cast<int>(scene.meshes.size()); ++m) {
    const int material = scene.meshes[static_cast<std::size_t>(m)].material;
    if (is_receiver(scene.materials[static_cast<std::size_t>(material)])) receivers.push_back(m);
  }
  const auto width = [&](int m) { return extent(bounds_of(scene.meshes[static_cast<std::size_t>(m)])); };
  std::stable_sort(receivers.begin(), receivers.end(), [&](int a, int b) { return width(a) > width(b); });
  return receivers;
}

// How many of the widest receivers stand around; `rest`: of all meshes but the first so many of them.
std::size_t count_around(const Scene& scene, const std::vector<int>& receivers,
                         const std::vector<Bounds>& rest) {
  for (std::size_t count = receivers.size(); count > 0; --count) {
    const auto around = [&](int m) {
      const Mesh& mesh = scene.meshes[static_cast<std::size_t>(m)];
      return extent(bounds_of(mesh)) >= (1.0 + 2.0 * beyond_of(mesh)) * extent(rest[count]) &&
             stands_around(scene, m, rest[count]);
    };
    // The narrowest first, which fails soonest.
    const auto end = receivers.rend(), begin = end - static_cast<std::ptrdiff_t>(count);
    if (!rest[count].empty() && std::all_of(begin, end, around)) return count;
  }
  return 0;
}

}  // namespace

Surroundings surroundings_of(const Scene& scene) {
  const std::vector<int> receivers = widest_receivers_first(scene);
  std::vector<bool> receives(scene.meshes.size());
  for (const int m : receivers) receives[static_cast<std::size_t>(m)] = true;
  std::vector<Bounds> rest(receivers.size() + 1);
  for (std::size_t m = 0; m < scene.meshes.size(); ++m)
    if (!receives[m]) rest.back().add(bounds_of(scene.meshes[m]));
  for (std::size_t i = receivers.size(); i > 0; --i) {
    rest[i - 1] = rest[i];
    rest[i - 1].add(bounds_of(scene.meshes[static_cast<std::size_t>(receivers[i - 1])]));
  }
  const std::size_t count = count_around(scene, receivers, rest);
  Surroundings found{.around = std::vector<bool>(scene.meshes.size()), .thing = rest[count]};
  const std::vector<int> around(receivers.begin(), receivers.begin() + static_cast<std::ptrdiff_t>(count));
  for (const int m : around) found.around[static_cast<std::size_t>(m)] = true;
  found.has_floor =
      !around.empty() && is_floor(scene, TriangleTree(scene, around), found.thing, kFloorBeyond);
  return found;
}

}  // namespace caustics
