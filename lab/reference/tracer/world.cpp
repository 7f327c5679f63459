#include "lab/reference/tracer/world.hpp"

#include <algorithm>
#include <map>

#include "lab/reference/closed_forms.hpp"
#include "lab/reference/tracer/paths_common.hpp"
#include "lab/reference/tracer/touching.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics::tracer {

namespace {

std::vector<int> meshes_with(const std::vector<Optics>& optics, int without, bool (*wanted)(Role)) {
  std::vector<int> meshes;
  for (int m = 0; m < static_cast<int>(optics.size()); ++m)
    if (m != without && wanted(optics[static_cast<std::size_t>(m)].role)) meshes.push_back(m);
  return meshes;
}

bool is_receiver(Role role) { return role == Role::Receiver; }
bool is_pane(Role role) { return role == Role::ThinPane || role == Role::Blended; }
bool throws_light(Role role) { return is_caster(role); }

}  // namespace

World::World(const Scene& scene, const Effects& effects, const std::vector<ExactShape>& exact)
    : scene_(scene),
      effects_(effects),
      exact_(exact),
      optics_(optics_of(scene, effects)),
      panes_(scene, {}),
      walls_(scene, {}) {
  Bounds everything = bounds_of(scene);
  for (const Light& light : scene.sources)
    if (light.type != LightType::Directional) everything.add(light.position);
  for (const Camera& camera : scene.cameras) everything.add(camera.position);
  size_ = everything.empty() ? 1.0 : std::max(2.0 * everything.radius(), 1e-6);
  nearest_ = 2e-6 * size_;
  if (scene.medium.present()) medium_ = medium_bounds(scene);
  overlapping_ = with_overlaps(scene, optics_, 2.0 * nearest_);
  std::vector<int> panes = meshes_with(optics_, -1, is_pane);
  for (int m = 0; m < static_cast<int>(optics_.size()); ++m)
    if (optics(m).role == Role::Receiver && effects.surfaces[static_cast<std::size_t>(m)].blended)
      panes.push_back(m);
  panes_ = RaySet(scene, panes, {}, true);
  walls_ =
      RaySet(scene, meshes_with(optics_, -1, [](Role role) { return role == Role::ThinPane; }), {}, true);
  sets_.push_back(set_without(-1));
  std::map<int, std::size_t> by_emitter{{-1, 0}};
  for (const Light& light : scene.sources) {
    const auto [found, fresh] = by_emitter.try_emplace(light.emitter, sets_.size());
    if (fresh) sets_.push_back(set_without(light.emitter));
    set_of_.push_back(found->second);
  }
  throws_.resize(scene.sources.size());
  for (const Expectation& e : effects.expectations) {
    const int source = scene.lights[static_cast<std::size_t>(e.light)].source;
    if (e.expected) throws_[static_cast<std::size_t>(source)] = true;
  }
}

Optics World::optics_at(const SurfaceHit& hit) const {
  const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(hit.mesh)];
  const Material& material = scene_.materials[static_cast<std::size_t>(mesh.material)];
  return is_dressed(material) && hit.triangle >= 0 ? dressed(scene_, material, optics(hit.mesh), hit.uv)
                                                   : optics(hit.mesh);
}

glm::dvec3 World::through_panes(const Ray& ray, double distance) const {
  glm::dvec3 left(1.0);
  double from = nearest_;
  for (int i = 0; i < 64; ++i) {
    const auto hit = panes_.nearest(ray, from, distance);
    if (!hit) break;
    const Material& m =
        scene_
            .materials[static_cast<std::size_t>(scene_.meshes[static_cast<std::size_t>(hit->mesh)].material)];
    from = std::max(hit->distance, from) * (1.0 + 1e-6) + nearest_;
    const Optics pane = optics_at(*hit);
    if (is_diffuse(pane.role)) {
      left *= 1.0 - opacity_at(scene_, m, hit->uv);
      continue;
    }
    const double r =
        fresnel(std::fabs(exact::dot(hit->normal, ray.direction)), 1.0, pane.ior).mean() * pane.fresnel;
    left *= (1.0 - pane.there) + pane.color * (pane.there * (1.0 - r) / (1.0 + r));
  }
  return left;
}

glm::dvec3 World::through_air(const Ray& ray, double distance) const {
  if (medium_.empty()) return glm::dvec3(1.0);
  double from = 0.0, to = distance;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis], p = ray.origin[axis];
    if (d == 0.0) continue;
    const double lower = (medium_.lower[axis] - p) / d, upper = (medium_.upper[axis] - p) / d;
    from = std::max(from, std::min(lower, upper));
    to = std::min(to, std::max(lower, upper));
  }
  return after(glm::dvec3(scene_.medium.extinction()), std::max(to - from, 0.0));
}

LitSet World::set_without(int emitter) const {
  std::vector<int> casters = meshes_with(optics_, emitter, throws_light);
  Bounds bounds;
  for (const int m : casters) bounds.add(bounds_of(scene_.meshes[static_cast<std::size_t>(m)]));
  for (const ExactShape& shape : exact_)
    if (std::find(casters.begin(), casters.end(), shape.mesh) != casters.end()) bounds.add(shape.bounds());
  return {RaySet(overlapping_ ? *overlapping_ : scene_, casters, exact_, true),
          RaySet(scene_, meshes_with(optics_, emitter, is_receiver), exact_), std::move(casters), bounds};
}

glm::dvec3 facing_normal(const glm::dvec3& normal, const glm::dvec3& direction, bool flip) {
  const glm::dvec3 oriented = flip ? -normal : normal;
  const double along = exact::dot(oriented, direction);
  if (along < -1e-4) return oriented;
  return exact::normalise(oriented - direction * (along + 1e-3), -direction);
}

}  // namespace caustics::tracer
