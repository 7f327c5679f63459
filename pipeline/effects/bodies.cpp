#include "pipeline/effects/bodies.hpp"

#include <map>
#include <utility>

namespace caustics {

namespace {

constexpr NamedEffect kNotInTriangles[] = {{"medium", &Effects::medium},
                                           {"water waves", &Effects::water_waves}};

}  // namespace

std::vector<int> bodies_of(const Scene& scene) {
  std::vector<int> bodies;
  std::map<std::pair<int, int>, int> numbers;
  for (const Mesh& mesh : scene.meshes)
    bodies.push_back(
        numbers.try_emplace({mesh.object, mesh.material}, static_cast<int>(numbers.size())).first->second);
  return bodies;
}

std::string not_in_triangles(const Scene& scene, const Effects& effects) {
  for (const NamedEffect& named : kNotInTriangles) {
    const Effect& effect = effects.*named.effect;
    if (effect.active) return std::string(named.name) + " (" + effect.reason + ")";
  }
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Material& m = scene.materials[static_cast<std::size_t>(scene.meshes[i].material)];
    const Role role = effects.surfaces[i].role;
    if (effects.surfaces[i].blended && m.base_color_texture.present())
      return "textured coverage (material '" + m.name + "' has it)";
    const bool textured = m.base_color_texture.present() || m.transmission_texture.present();
    if (role == Role::ThinPane && m.alpha_mode == AlphaMode::Blend && textured)
      return "textured coverage of panes (material '" + m.name + "' has it)";
  }
  return {};
}

}  // namespace caustics
