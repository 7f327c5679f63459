#include "pipeline/effects/textured_casters.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/effects/surface_role.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// Does a transmission texture tint it texel by texel?
bool partly_opaque(const Material& material, const SurfaceRole& surface) {
  return surface.role != Role::Mirror && material.transmission_texture.present();
}

bool colored(const Material& material, const SurfaceRole& surface) {
  return material.base_color_texture.present() || partly_opaque(material, surface);
}

bool normal_mapped(const Material& material, const SurfaceRole& surface) {
  return is_caster(surface.role) && material.normal_texture.present() && material.normal_scale != 0.0f;
}

bool cut_out(const Material& material, const SurfaceRole& surface) {
  if (surface.role == Role::Receiver && surface.blended) return material.base_color_texture.present();
  return material.alpha_mode == AlphaMode::Mask &&
         (material.base_color_texture.present() || material.base_color.a < material.alpha_cutoff);
}

// Texels of a texture that cover a mesh, repeats counted.
double texels_on(const Mesh& mesh, const TextureUse& use, const Image& image) {
  const glm::mat3& m = use.uv_transform;
  double squares = 0.0;  // of texture space, twice
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec2 a = mesh.vertices[mesh.indices[i]].uv;
    const glm::dvec2 b = glm::dvec2(mesh.vertices[mesh.indices[i + 1]].uv) - a;
    const glm::dvec2 c = glm::dvec2(mesh.vertices[mesh.indices[i + 2]].uv) - a;
    squares += std::fabs(b.x * c.y - b.y * c.x);
  }
  const double stretch = std::fabs(static_cast<double>(m[0][0]) * static_cast<double>(m[1][1]) -
                                   static_cast<double>(m[1][0]) * static_cast<double>(m[0][1]));
  return 0.5 * squares * stretch * image.width() * image.height();
}

// How fine the normals are beside the grid, which has no more vertices on the mesh than it has in all.
// Textures are interpolated but not filtered, so what is finer than the grid is sampled, not averaged.
std::string fineness(const Scene& scene, const Mesh& mesh, const TextureUse& use, const Settings& settings) {
  const Image& image = scene.images[static_cast<std::size_t>(use.image)];
  const double ratio = std::sqrt(texels_on(mesh, use, image)) / settings.grid;
  if (!(ratio > 1.0)) return {};
  return "; its texels are finer than the grid, " + rounded_text(ratio, 3) +
         " or more to a grid vertex each way: the caustic is a sample of theirs, and noisy (--grid makes it "
         "finer)";
}

struct Use {
  std::size_t meshes = 0;
  std::string first;           // name of the first material
  std::string fineness;        // of the first normal texture that is finer than the grid
  bool partly_opaque = false;  // a transmission texture is among them
};

template <class Has>
Use use_of(const Scene& scene, const Settings& settings, const Effects& effects, Has has) {
  Use use;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const SurfaceRole& surface = effects.surfaces[i];
    const Mesh& mesh = scene.meshes[i];
    const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    if (!has(material, surface)) continue;
    if (use.meshes++ == 0)
      use.first = quoted_name("material", material.name, static_cast<std::size_t>(mesh.material));
    use.partly_opaque |= partly_opaque(material, surface);
    if (use.fineness.empty() && material.normal_texture.present())
      use.fineness = fineness(scene, mesh, material.normal_texture, settings);
  }
  return use;
}

Effect effect_of(const Use& use, const std::string& what) {
  const std::string others =
      use.meshes > 1 ? " and " + std::to_string(use.meshes - 1) + " more" : std::string{};
  return {use.meshes > 0, use.meshes > 0 ? use.first + others + ": " + what : "none in the scene"};
}

}  // namespace

CasterDetail caster_detail(const Effects& effects) {
  if (effects.textured_casters.active) return CasterDetail::Colors;
  return detailed_exits(effects) ? CasterDetail::Normals : CasterDetail::None;
}

bool detailed_exits(const Effects& effects) {
  return effects.normal_mapped_casters.active || effects.cut_out_casters.active;
}

bool light_meets_textures(const Effects& effects) {
  return effects.further_surfaces.active &&
         (caster_detail(effects) != CasterDetail::None || effects.cut_out_receivers.active);
}

bool receivers_are_dressed(const Effects& effects) {
  return effects.cut_out_receivers.active ||
         (effects.seen_casters.active && effects.textured_receivers.active);
}

bool sight_meets_textures(const Effects& effects) {
  return effects.seen_casters.active &&
         (effects.textured_receivers.active || caster_detail(effects) != CasterDetail::None);
}

void add_textured_casters(const Scene& scene, const Settings& settings, Effects& effects) {
  const auto found = [&](auto has) {
    return use_of(scene, settings, effects, [&](const Material& material, const SurfaceRole& surface) {
      return is_on_the_way(surface) && has(material, surface);
    });
  };
  const Use colors = found(colored);
  effects.textured_casters = effect_of(
      colors, std::string("a texture tints what passes or is mirrored") +
                  (colors.partly_opaque
                       ? "; what a transmission texture holds back counts as absorbed, and looks black"
                       : ""));
  const Use normals = found(normal_mapped);
  effects.normal_mapped_casters = effect_of(normals, "a normal texture bends light" + normals.fineness);
  effects.cut_out_casters =
      effect_of(found(cut_out), "an alpha mask cuts holes, which let light straight through");
  const Use receivers =
      use_of(scene, settings, effects, [](const Material& material, const SurfaceRole& surface) {
        return is_diffuse(surface.role) &&
               (material.base_color_texture.present() || material.emissive_texture.present());
      });
  const Use holes =
      use_of(scene, settings, effects, [](const Material& material, const SurfaceRole& surface) {
        return surface.role == Role::Receiver && cut_out(material, surface);
      });
  effects.cut_out_receivers = effect_of(
      holes,
      "what an alpha mask cuts out, or alphaMode BLEND does not cover whole, lets followed light through");
  effects.textured_receivers = effect_of(receivers, "glass shows its texture where the picture does not");
  for (std::size_t i = 0; i < scene.meshes.size() && !effects.textured_receivers.active; ++i)
    if (is_diffuse(effects.surfaces[i].role) && !scene.meshes[i].colors.empty())
      effects.textured_receivers = {true,
                                    quoted_name("mesh", scene.meshes[i].name, i) +
                                        ": glass shows its vertices' colours where the picture does not"};
}

}  // namespace caustics
