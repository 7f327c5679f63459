#include "pipeline/effects/smooth_shading.hpp"

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// Normals that turn by more than a thousandth within a triangle.
bool is_smooth(const Mesh& mesh) {
  const auto turns = [&](std::uint32_t a, std::uint32_t b) {
    const glm::dvec3 turn = glm::dvec3(mesh.vertices[a].normal) - glm::dvec3(mesh.vertices[b].normal);
    return exact::dot(turn, turn) > 1e-6;
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    if (turns(mesh.indices[i], mesh.indices[i + 1]) || turns(mesh.indices[i], mesh.indices[i + 2]))
      return true;
  }
  return false;
}

}  // namespace

void add_smooth_shading(const Scene& scene, Effects& effects) {
  bool smooth = false;
  for (std::size_t m = 0; m < scene.meshes.size() && !smooth; ++m)
    smooth = has_diffuse(effects.surfaces[m]) && is_smooth(scene.meshes[m]);
  effects.smooth_shading = {effects.occluders.active && smooth,
                            !effects.occluders.active ? effects.occluders.reason
                            : smooth ? "shadows end by diffuse surfaces' normals, not by their triangles"
                                     : "diffuse surfaces are as flat as their triangles"};
}

}  // namespace caustics
