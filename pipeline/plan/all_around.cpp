#include "pipeline/plan/all_around.hpp"

#include <cmath>

#include "pipeline/plan/check_settings.hpp"
#include "pipeline/plan/surface_role.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// The point of a triangle nearest to the origin (Ericson, Real-Time Collision Detection, 5.1.5).
glm::dvec3 nearest_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a;
  const double d1 = -exact::dot(ab, a), d2 = -exact::dot(ac, a);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const double d3 = -exact::dot(ab, b), d4 = -exact::dot(ac, b);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + ab * (d1 / std::max(d1 - d3, 1e-300));
  const double d5 = -exact::dot(ab, c), d6 = -exact::dot(ac, c);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + ac * (d2 / std::max(d2 - d6, 1e-300));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return b + (c - b) * ((d4 - d3) / std::max((d4 - d3) + (d5 - d6), 1e-300));
  const double sum = std::max(va + vb + vc, 1e-300);
  return a + ab * (vb / sum) + ac * (vc / sum);
}

bool is_receiver(const Effects& effects, std::size_t mesh) {
  return effects.surfaces[mesh].role == Role::Receiver;
}

void add_impostors(const Scene& scene, const Settings& settings, Effects& effects) {
  const bool wanted = settings.estimator == Estimator::Impostor;
  const bool active = wanted && effects.active("caustics");
  effects.list.push_back({"distance impostors", active,
                          active   ? "the estimator asked for looks landings up around the casters"
                          : wanted ? "there is no caustic"
                                   : "the estimator does not use them"});
  if (!active) return;
  Bounds casters;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (is_caster(effects.surfaces[i].role)) casters.add(bounds_of(scene.meshes[i]));
  const Distances distances =
      distances_from(casters.centre(), scene, [&](std::size_t i) { return is_receiver(effects, i); });
  effects.impostors = cube_frame(casters.centre(), distances);
}

// A window through which a light looks at its casters is at most this wide to be preferred to a cube, as wide as
// framing.cpp makes any: tan 71.6 degrees. Its texels are then as large as those of a cube's tiles.
constexpr double kWidestTangent = 3.0;

// Do the casters that this light reaches fit a window towards their middle?
bool casters_fit(const Scene& scene, const Light& light, const std::vector<std::size_t>& casters) {
  Bounds bounds;
  for (const std::size_t i : casters) bounds.add(bounds_of(scene.meshes[i]));
  const Frame axes = frame_along(
      light.position, exact::normalise(bounds.centre() - light.position, light.direction));
  for (const std::size_t i : casters)
    for (const Vertex& v : scene.meshes[i].vertices) {
      const glm::dvec3 q = axes.coordinates(glm::dvec3(v.position));
      if (!(std::max(std::fabs(q.x), std::fabs(q.y)) <= kWidestTangent * q.z)) return false;
    }
  return true;
}

// Do receivers stand on all sides of a point?
bool enclosed(const Scene& scene, const Effects& effects, const glm::dvec3& p) {
  Bounds bounds;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (is_receiver(effects, i)) bounds.add(bounds_of(scene.meshes[i]));
  if (bounds.empty()) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] > bounds.lower[axis] && p[axis] < bounds.upper[axis])) return false;
  return true;
}

// Why a light is to see all around by itself, or nothing.
std::string calls_for_cube(const Scene& scene, const Settings& settings, const Effects& effects, int index) {
  const Light& light = scene.lights[static_cast<std::size_t>(index)];
  if (light.type != LightType::Point || light.lambertian) return {};
  std::vector<std::size_t> casters;
  bool any_way = settings.reflections;
  for (const Expectation& e : effects.expectations) {
    if (e.light != index || !e.expected) continue;
    casters.push_back(static_cast<std::size_t>(e.mesh));
    any_way |= effects.surfaces[casters.back()].role == Role::Mirror;
  }
  if (casters.empty()) return {};
  if (!casters_fit(scene, light, casters)) return "its casters stand all around it";
  if (any_way && enclosed(scene, effects, light.position))
    return "what mirrors send its light to stands all around it";
  return {};
}

void add_lights(const Scene& scene, const Settings& settings, Effects& effects) {
  const std::string small = effects.active("scattering") ? "a medium that scatters allows one window only"
                                                         : too_small_for_cubes(settings);
  std::string first, refused;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    std::string reason;
    if (settings.cube == Cube::Auto) reason = calls_for_cube(scene, settings, effects, static_cast<int>(i));
    if (settings.cube == Cube::On && light.type != LightType::Directional) reason = "as asked for";
    if (!small.empty() && !reason.empty()) {
      refused = small;
      reason.clear();
    }
    if (first.empty() && !reason.empty())
      first = quoted_name("light", source_of(scene, static_cast<int>(i)).name, i) + ": " + reason;
    effects.all_around.push_back(std::move(reason));
  }
  const auto count = static_cast<std::size_t>(
      std::count_if(effects.all_around.begin(), effects.all_around.end(),
                    [](const std::string& reason) { return !reason.empty(); }));
  if (count > 1) first += ", and " + std::to_string(count - 1) + " more";
  effects.list.push_back({"all around", count > 0,
                          count > 0                     ? first
                          : !refused.empty()            ? refused + " for a light among its casters"
                          : settings.cube == Cube::Off  ? "lights look one way, as asked for"
                                                        : "no light stands among its casters"});
}

}  // namespace

LightFrames frames_all_around(const Scene& scene, const Effects& effects, const Settings& settings,
                              const Light& light) {
  const auto shone_on = [&](std::size_t i) { return light.emitter != static_cast<int>(i); };
  const Frame all = cube_frame(light.position, distances_from(light.position, scene, shone_on));
  const Distances casters = distances_from(light.position, scene, [&](std::size_t i) {
    return shone_on(i) && is_caster(effects.surfaces[i].role);
  });
  const Frame map = with_atlas(all, settings.map), shadow = with_atlas(all, settings.shadow);
  // The landings' maps alike: what reaches over an edge must be as wide in both tiles.
  Frame grid = with_atlas(all, settings.grid);
  Frame caustic = with_atlas(all, settings.map, caustic_guard(settings));
  grid.cube->square = caustic.cube->square = true;
  LightFrames frames{.caster = grid,
                     .receiver = map,
                     .caustic = caustic,
                     .shadow = shadow,
                     .panes = shadow,
                     .column = map,
                     .cascade = {}};
  // Mirrored light can land on what stands nearer than all casters; refracted light goes on.
  const bool comes_back = effects.active("mirrors") || effects.active("reflections");
  frames.casters_nearest = casters.empty() || comes_back ? 0.0 : casters.nearest * 0.999;
  return frames;
}

Distances distances_from(const glm::dvec3& point, const Mesh& mesh) {
  Distances result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto corner = [&](std::size_t i) {
    return glm::dvec3(mesh.vertices[mesh.indices[i]].position) - point;
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
    result.nearest = std::min(result.nearest, exact::length(nearest_of(a, b, c)));
    result.farthest =
        std::max({result.farthest, exact::length(a), exact::length(b), exact::length(c)});
  }
  return result;
}

Frame cube_frame(const glm::dvec3& origin, const Distances& distances) {
  Frame frame;
  frame.origin = origin;
  frame.perspective = true;
  frame.cube = CubeAtlas{};
  if (distances.empty()) return frame;
  frame.far = std::max(distances.farthest * 1.001, 1e-9);
  // In its face's direction a point is at least its distance over sqrt 3 away, a little less in the guard.
  frame.near = std::clamp(0.5 * distances.nearest, frame.far * 1e-5, frame.far * 0.5);
  return frame;
}

Frame with_atlas(Frame frame, int side, int guard) {
  frame.cube = CubeAtlas{.side = side, .guard = guard};
  return frame;
}

bool face_sees(const Frame& frame, int face, const Mesh& mesh) {
  const CubeAtlas& atlas = *frame.cube;
  const double wide = static_cast<double>(atlas.tile_width()) / atlas.face_width();
  const double high = static_cast<double>(atlas.tile_height()) / atlas.face_height();
  bool right = true, left = true, above = true, below = true;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p{corner & 1 ? mesh.upper.x : mesh.lower.x, corner & 2 ? mesh.upper.y : mesh.lower.y,
                       corner & 4 ? mesh.upper.z : mesh.lower.z};
    const glm::dvec3 q = turned_to_face(frame.coordinates(p), face);
    right &= q.x > q.z * wide;
    left &= q.x < -q.z * wide;
    above &= q.y > q.z * high;
    below &= q.y < -q.z * high;
  }
  return !(right || left || above || below);
}

void add_all_around(const Scene& scene, const Settings& settings, Effects& effects) {
  add_impostors(scene, settings, effects);
  add_lights(scene, settings, effects);
}

}  // namespace caustics
