#include "lab/reference/tracer/optics.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/effects/bodies.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/material_optics.hpp"

namespace caustics::tracer {

namespace {

Optics optics_of_surface(const Material& material, const SurfaceRole& surface) {
  Optics o{.role = surface.role, .solid = surface.two_interfaces, .ior = static_cast<double>(material.ior)};
  if (surface.role == Role::Mirror) {
    o.color = glm::dvec3(metal_reflectance(material));
    return o;
  }
  o.spread = static_cast<double>(main_dispersion(material));
  o.color = glm::dvec3(glm::vec3(material.base_color) * transmitted_share(material));
  if (surface.role == Role::Refractor && surface.rough)
    o.alpha = static_cast<double>(material.roughness) * static_cast<double>(material.roughness);
  o.fresnel = static_cast<double>(material.fresnel_factor);
  o.thin = surface.thin || surface.role == Role::ThinPane;
  if (surface.role == Role::ThinPane && material.alpha_mode == AlphaMode::Blend)
    o.there = static_cast<double>(material.base_color.a);
  if (surface.role == Role::Refractor && !surface.thin) o.absorption = glm::dvec3(absorption_of(material));
  return o;
}

// The texel that a whole number means beyond the picture's sides too (glTF 2.0, 5.26).
int wrapped(std::int64_t i, int side, Wrap mode) {
  if (mode == Wrap::Clamp) return static_cast<int>(std::clamp<std::int64_t>(i, 0, side - 1));
  const std::int64_t period = mode == Wrap::Mirror ? 2 * std::int64_t{side} : side;
  const std::int64_t within = ((i % period) + period) % period;
  return static_cast<int>(within < side ? within : period - 1 - within);
}

glm::dvec4 texel(const Image& image, const TextureUse& use, std::int64_t x, std::int64_t y) {
  const int column = wrapped(x, image.width(), use.wrap_u), row = wrapped(y, image.height(), use.wrap_v);
  glm::dvec4 value(0.0, 0.0, 0.0, 1.0);
  for (int c = 0; c < image.channels(); ++c) value[c] = static_cast<double>(image.at(column, row, c));
  return value;
}

glm::dvec4 sampled(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, bool nearest) {
  if (!use.present()) return glm::dvec4(1.0);
  const Image& image = scene.images[static_cast<std::size_t>(use.image)];
  const glm::dvec3 place = glm::dmat3(use.uv_transform) * glm::dvec3(uv, 1.0);
  const double x = place.x * image.width(), y = place.y * image.height();
  if (nearest || use.nearest)
    return texel(image, use, static_cast<std::int64_t>(std::floor(x)),
                 static_cast<std::int64_t>(std::floor(y)));
  const double left = std::floor(x - 0.5), low = std::floor(y - 0.5);
  const double s = x - 0.5 - left, t = y - 0.5 - low;
  const auto at = [&](int dx, int dy) {
    return texel(image, use, static_cast<std::int64_t>(left) + dx, static_cast<std::int64_t>(low) + dy);
  };
  return (at(0, 0) * (1.0 - s) + at(1, 0) * s) * (1.0 - t) + (at(0, 1) * (1.0 - s) + at(1, 1) * s) * t;
}

}  // namespace

std::vector<Optics> optics_of(const Scene& scene, const Effects& effects) {
  const std::vector<int> bodies = bodies_of(scene);
  std::vector<Optics> all;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const auto material = static_cast<std::size_t>(scene.meshes[i].material);
    all.push_back(optics_of_surface(scene.materials[material], effects.surfaces[i]));
    all.back().body = bodies[i];
  }
  return all;
}

bool is_dressed(const Material& material) {
  return material.base_color_texture.present() || material.transmission_texture.present() ||
         material.normal_texture.present() || material.alpha_mode == AlphaMode::Mask;
}

bool is_cut_out(const Scene& scene, const Material& material, const glm::dvec2& uv) {
  const float opaque = opaque_from(material);
  const double opacity =
      static_cast<double>(material.base_color.a) * sampled(scene, material.base_color_texture, uv, true).w;
  return opaque > 0.0f && opacity < static_cast<double>(opaque);
}

double opacity_at(const Scene& scene, const Material& material, const glm::dvec2& uv) {
  return static_cast<double>(material.base_color.a) *
         sampled(scene, material.base_color_texture, uv, false).w;
}

glm::dvec3 leaned(const Scene& scene, const Material& material, const glm::dvec3& n,
                  const glm::dvec4& tangent, const glm::dvec2& uv) {
  if (!material.normal_texture.present()) return n;
  const glm::dvec3 raw(tangent);
  const glm::dvec3 t = exact::normalise(raw - n * exact::dot(n, raw), exact::perpendicular(n));
  const glm::dvec3 b = exact::cross(n, t) * tangent.w;
  const glm::dvec4 stored = sampled(scene, material.normal_texture, uv, false);
  const double scale = static_cast<double>(material.normal_scale);
  const double x = (2.0 * stored.x - 1.0) * scale, y = (2.0 * stored.y - 1.0) * scale;
  return exact::normalise(t * x + b * y + n * std::max(2.0 * stored.z - 1.0, 0.01), n);
}

Optics dressed(const Scene& scene, const Material& material, const Optics& plain, const glm::dvec2& uv) {
  Optics optics = plain;
  const glm::dvec3 base =
      glm::dvec3(material.base_color) * glm::dvec3(sampled(scene, material.base_color_texture, uv, false));
  const double metallic = static_cast<double>(material.metallic);
  if (optics.role == Role::ThinPane && material.alpha_mode == AlphaMode::Blend)
    optics.there = opacity_at(scene, material, uv);
  if (optics.role == Role::Mirror)
    optics.color = glm::dvec3(0.04 * (1.0 - metallic)) + base * metallic;
  else
    optics.color = base * (static_cast<double>(transmission_factor(material)) *
                           sampled(scene, material.transmission_texture, uv, false).x);
  return optics;
}

}  // namespace caustics::tracer
