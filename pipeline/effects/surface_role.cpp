#include "pipeline/effects/surface_role.hpp"

#include <algorithm>

#include "pipeline/gpu/text.hpp"
#include "pipeline/scene/material_optics.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

std::string rounded_text(double value, int digits) {
  const std::string result = significant(value, digits);
  return result.find_first_not_of("-0123456789") == std::string::npos ? result + ".0" : result;
}

std::string quoted_name(const std::string& kind, const std::string& name, std::size_t index) {
  return kind + " " + (name.empty() ? std::to_string(index) : "'" + name + "'");
}

namespace {

// A material that lets less than this share of the light through is drawn as a diffuse surface alone; one
// that keeps less than this share, as glass alone.
constexpr float kLeastRoleShare = 0.01f;

Judgement diffuse(const std::string& material, const std::string& why) {
  return {{Role::Receiver, false, material + ": " + why}, false, {}};
}

// Looks like something that throws caustics, but is drawn as a diffuse surface.
Judgement diffuse_instead(const std::string& material, const std::string& why) {
  return {{Role::Receiver, false, material + ": " + why + "; drawn as a diffuse surface"}, true, why};
}

struct InterfaceChoice {
  bool two = false;
  std::string reason;
};

InterfaceChoice interfaces_of(const Mesh& mesh, const Settings& settings) {
  if (settings.interfaces == Interfaces::One) {
    return {false, "one interface as asked for: light bends where it enters only"};
  }
  if (settings.interfaces == Interfaces::Two) {
    return {true, "two interfaces as asked for: light enters and leaves"};
  }
  const double holes = 1.0 - static_cast<double>(mesh.closedness);
  if (holes <= 0.0) return {true, "closed mesh: light enters and leaves"};
  const std::string share = " (holes of " + rounded_text(std::max(holes * 100.0, 0.001)) + "% of its area)";
  if (!mesh.closed()) {
    return {false, "open mesh" + share + ": one interface, as a water surface"};
  }
  return {true, "nearly closed mesh" + share +
                    ": taken as closed, light enters and leaves; rays through the holes may be "
                    "lost"};
}

std::string spread_by(float roughness, const Settings& settings) {
  return "roughness " + rounded_text(roughness) + " above " + rounded_text(settings.glass_roughness) +
         ": spreads light";
}

// No KHR_materials_volume: light passes straight through, or leaves a rough wall in a lobe.
Judgement judge_wall(const Mesh& mesh, const Material& material, const std::string& glass,
                     const Settings& settings) {
  if (!(material.roughness > settings.glass_roughness)) {
    const std::string why =
        "thin wall (no KHR_materials_volume thickness): bends nothing; --assume-solid makes it solid";
    return {{Role::ThinPane, false, glass + ", " + why}, true, why};
  }
  const InterfaceChoice interfaces = interfaces_of(mesh, settings);
  const std::string reason = glass + ", thin wall (no KHR_materials_volume thickness), " +
                             spread_by(material.roughness, settings) + ", " + interfaces.reason;
  return {{.role = Role::Refractor,
           .two_interfaces = interfaces.two,
           .reason = reason,
           .rough = true,
           .thin = true},
          true,
          {}};
}

Judgement judge_glass(const Mesh& mesh, const Material& material, const std::string& name,
                      const Settings& settings) {
  const std::string glass = name + ": transmission " + rounded_text(material.transmission);
  if (material.ior == 0.0f) {
    return diffuse_instead(name, "ior 0 never refracts (all light is reflected)");
  }
  if (!(material.thickness > 0.0f) && !settings.assume_solid)
    return judge_wall(mesh, material, glass, settings);
  const InterfaceChoice interfaces = interfaces_of(mesh, settings);
  std::string reason = glass + ", IOR " + rounded_text(material.ior);
  if (material.ior == 1.0f) reason += " (bends nothing)";
  if (material.ior < 1.0f) reason += " (thinner than its surroundings, as a bubble)";
  if (!(material.thickness > 0.0f)) reason += ", --assume-solid";
  const bool rough = material.roughness > settings.glass_roughness;
  if (rough) reason += ", " + spread_by(material.roughness, settings);
  reason += ", " + interfaces.reason;
  return {{.role = Role::Refractor, .two_interfaces = interfaces.two, .reason = reason, .rough = rough},
          true,
          {}};
}

Judgement judge_unblended(const Mesh& mesh, const Material& material, const Settings& settings) {
  const std::string name = quoted_name("material", material.name, static_cast<std::size_t>(mesh.material));
  if (material.unlit) {
    return diffuse(name, "unlit: shows its colour as it is, and casts a shadow");
  }
  if (material.metallic >= settings.mirror_metallic && material.roughness <= settings.mirror_roughness) {
    return {{Role::Mirror, false,
             name + ": metallic " + rounded_text(material.metallic) + ", roughness " +
                 rounded_text(material.roughness) + ": a mirror"},
            true,
            {}};
  }
  // Metal lets nothing through, so only the other part transmits (KHR_materials_transmission).
  const float transmissive = transmitted_share(material);
  if (transmissive >= kLeastRoleShare) {
    Judgement judged = judge_glass(mesh, material, name, settings);
    if (judged.role.role == Role::Receiver || transmissive > 1.0f - kLeastRoleShare) return judged;
    judged.role.partly_diffuse = true;
    judged.role.reason += ", " + percent(1.0 - static_cast<double>(transmissive)) +
                          (material.metallic > 0.0f ? " diffuse or metal" : " diffuse");
    return judged;
  }
  if (material.transmission > 0.0f) {
    const std::string left = "transmission " + rounded_text(transmissive);
    return diffuse_instead(name, material.metallic > 0.0f
                                     ? left + " is left beside the metal, below 0.01: glass has metallic 0"
                                     : left + " is below 0.01");
  }
  return diffuse(name, "diffuse");
}

// What alphaMode BLEND makes of it: coverage, of what is diffuse.
void blend(const Mesh& mesh, const Material& material, const std::string& name, Judgement& judged) {
  SurfaceRole& surface = judged.role;
  float least = mesh.colors.empty() ? 1.0f : mesh.colors.front().a, most = least;
  for (const glm::vec4& color : mesh.colors) {
    least = std::min(least, color.a);
    most = std::max(most, color.a);
  }
  least *= material.base_color.a * material.least_alpha;
  most *= material.base_color.a * material.most_alpha;
  if (surface.role == Role::ThinPane) {
    if (least < kCoversAll) {
      surface.partly_diffuse = true;
      surface.reason += ", alphaMode BLEND: alpha " + rounded_text(most) + " of it is there";
    }
  } else if (surface.role != Role::Receiver) {
    surface.reason += ", alphaMode BLEND ignored";
  } else if (least >= kCoversAll) {
    surface.reason += ", alphaMode BLEND with alpha 1 all over: opaque";
  } else {
    const std::string range =
        least < most ? rounded_text(least) + " to " + rounded_text(most) : rounded_text(most);
    surface.blended = true;
    if (most < kCoversAll) surface.role = Role::Blended;
    surface.reason = name + ": alphaMode BLEND, alpha " + range +
                     ": coverage, not glass (KHR_materials_transmission and KHR_materials_volume make glass)";
    judged.looks_specular = true;
    judged.no_caustic =
        "alphaMode BLEND is coverage, not glass; KHR_materials_transmission and "
        "KHR_materials_volume make glass";
  }
}

}  // namespace

Judgement judge(const Mesh& mesh, const Material& material, const Settings& settings) {
  Judgement judged = judge_unblended(mesh, material, settings);
  if (material.alpha_mode == AlphaMode::Blend)
    blend(mesh, material, quoted_name("material", material.name, static_cast<std::size_t>(mesh.material)),
          judged);
  return judged;
}

}  // namespace caustics
