#include "pipeline/effects/ray_tables.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <tuple>

#include "pipeline/effects/bodies.hpp"
#include "pipeline/effects/textured_casters.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/material_optics.hpp"
#include "pipeline/scene/triangle_tree.hpp"

namespace caustics {

namespace {

// Casters that get a row each in kCasterMaterials: as many as any device's textures are high.
constexpr std::ptrdiff_t kMostOwnRows = 4096;
// A material with textures has three more for each of its pictures (passes/shared/dressed_meeting.glsl).
constexpr int kTexelsOfMaterial = 4, kTexelsOfDressed = 4 + 3 * 4;

// A picture's place in kCasterTexels, and how texture coordinates lead there.
std::array<glm::vec4, 3> picture_texels(const TextureUse& use, const CasterTexels& texels) {
  const auto found = texels.places.find(use.image);
  if (found == texels.places.end()) return {};
  const CasterTexels::Place& place = found->second;
  const glm::mat3& m = use.uv_transform;
  const float nearest = use.nearest ? 4.0f : 0.0f;
  return {glm::vec4(place.x, place.y, place.width, place.height),
          {m[0][0], m[1][0], m[2][0], static_cast<float>(use.wrap_u)},
          {m[0][1], m[1][1], m[2][1], static_cast<float>(use.wrap_v) + nearest}};
}

void put_texels(Image& table, int row, int column, std::span<const glm::vec4> texels) {
  for (const glm::vec4& texel : texels) {
    for (int c = 0; c < 4; ++c) table.at(column, row, c) = texel[c];
    ++column;
  }
}

bool are_dressed(const Effects& effects) { return caster_detail(effects) != CasterDetail::None; }

// Opacity below which a surface has a hole, 0: there are none; -1: a pane that covers its opacity's share of
// what lies behind. Of what is glass or metal alphaMode BLEND is ignored.
float cutoff_of(const Material& material, Role role) {
  if (role == Role::Receiver || material.alpha_mode == AlphaMode::Mask) return opaque_from(material);
  return role == Role::ThinPane && material.alpha_mode == AlphaMode::Blend ? -1.0f : 0.0f;
}

// Of a caster (passes/shared/caster_material.glsl, Material).
std::array<glm::vec4, kTexelsOfMaterial> texels_of_caster(const Material& material, Role role, bool thin,
                                                          bool two_interfaces) {
  const bool mirror = role == Role::Mirror;
  const glm::vec3 absorption = mirror || thin ? glm::vec3(0.0f) : absorption_of(material);
  const glm::vec3 color = mirror ? metal_reflectance(material) : glm::vec3(material.base_color);
  return {glm::vec4(material.ior, main_dispersion(material), 1.0f - material.fresnel_factor,
                    mirror ? 1.0f
                    : thin ? -1.0f
                           : 0.0f),
          {absorption, two_interfaces ? 1.0f : 0.0f},
          {color, material.roughness},
          {mirror ? grey_reflectance(material) : transmission_factor(material), material.normal_scale,
           material.base_color.a, cutoff_of(material, role)}};
}

// Receivers of one material that differ in this have rows of their own.
constexpr int kColored = 1, kInsideOut = 2;
int kind_of_receiver(const Mesh& mesh) {
  return (mesh.colors.empty() ? 0 : kColored) + (mesh.inside_out ? kInsideOut : 0);
}

// What of a receiver is shown by glass alone (passes/shared/caster_material.glsl, ReceiverMaterial).
std::array<glm::vec4, kTexelsOfMaterial> texels_of_receiver(const Material& m, int kind) {
  const bool one_sided = !m.double_sided && (kind & kInsideOut) == 0;
  return {glm::vec4(m.emissive, one_sided ? 1.0f : 0.0f),
          {m.fade.centre, m.fade.from},
          {glm::vec3(m.base_color), m.fade.to},
          {static_cast<float>((kind & kColored) + (m.alpha_mode == AlphaMode::Blend ? 2 : 0)), m.normal_scale,
           m.base_color.a, cutoff_of(m, Role::Receiver)}};
}

void add_once(std::vector<int>& images, const TextureUse& use) {
  if (use.present() && std::find(images.begin(), images.end(), use.image) == images.end())
    images.push_back(use.image);
}

}  // namespace

RayTables::RayTables(const Scene& scene, const Effects& effects, Device& device)
    : scene_(scene), device_(device) {
  upload_materials(effects);
  number_triangles(effects);
}

void RayTables::meet_waters(const Effects& effects) {
  if (scene_.waters.empty() || may_be_followed(effects) == meets_waters_) return;
  meshes_ = {};
  media_.clear();
  renew();
  number_triangles(effects);
}

int RayTables::mesh_of(int number) const {
  const bool caster = number < first_receiver_;
  const std::vector<int>& meshes = caster ? meshes_.casters : meshes_.receivers;
  const auto behind = std::upper_bound(meshes.begin(), meshes.end(), number, [this](int wanted, int mesh) {
    return wanted < first_triangle(mesh);
  });
  return behind == meshes.begin() ? -1 : *(behind - 1);
}

int RayTables::first_point(int source) const {
  const auto lamp = std::find(lamps_.begin(), lamps_.end(), source);
  if (lamp == lamps_.end()) return -1;
  return caustics::first_point(scene_, meshes_, static_cast<std::size_t>(lamp - lamps_.begin()));
}

glm::dvec3 RayTables::plane_of(int number) const {
  const int mesh = mesh_of(number);
  return plane_normal(scene_, {mesh, number - first_triangle(mesh)});
}

glm::vec4 RayTables::bodies_around(const glm::dvec3& p) const {
  if (around_ && around_->first == p) return around_->second;
  const glm::dvec3 up{0.0, 1.0, 0.0};
  std::map<int, TriangleHit> first;  // by body
  for (const int mesh : media_) {
    const Mesh& m = scene_.meshes[static_cast<std::size_t>(mesh)];
    const bool beside = p.x < static_cast<double>(m.lower.x) || p.x > static_cast<double>(m.upper.x) ||
                        p.z < static_cast<double>(m.lower.z) || p.z > static_cast<double>(m.upper.z);
    if (beside || p.y > static_cast<double>(m.upper.y)) continue;
    const auto hit = TriangleTree(scene_, {mesh}).nearest(p, up);
    if (!hit) continue;
    const auto [found, fresh] = first.try_emplace(meshes_.bodies[static_cast<std::size_t>(mesh)], *hit);
    if (!fresh && hit->distance < found->second.distance) found->second = *hit;
  }
  std::vector<std::pair<double, int>> around;
  for (const auto& [body, hit] : first)
    if (!hit.front) around.emplace_back(hit.distance, body);
  std::sort(around.begin(), around.end());
  glm::vec4 media(0.0f);
  for (int i = 0; i < static_cast<int>(std::min<std::size_t>(around.size(), 4)); ++i)
    media[i] = static_cast<float>(around[static_cast<std::size_t>(i)].second + 1);
  around_ = {p, media};
  return media;
}

void RayTables::renew() {
  hierarchy_.reset();
  around_.reset();
  list_lamps();
}

void RayTables::list_lamps() {
  lamps_ = lamps_of_points(scene_);
  meshes_.lamps.clear();
  for (const int lamp : lamps_)
    meshes_.lamps.push_back(scene_.sources[static_cast<std::size_t>(lamp)].emitter);
}

void RayTables::number_triangles(const Effects& effects) {
  meets_waters_ = may_be_followed(effects);
  const std::vector<int> bodies = bodies_of(scene_);
  std::map<int, int> row_of_body;
  for (int m = 0; m < static_cast<int>(bodies.size()); ++m) {
    const auto index = static_cast<std::size_t>(m);
    const SurfaceRole& surface = effects.surfaces[index];
    const bool is_water = std::any_of(scene_.waters.begin(), scene_.waters.end(),
                                      [m](const Water& water) { return water.mesh == m; });
    const bool met = meets_waters_ || !is_water;
    if (is_on_the_way(surface) && met) meshes_.casters.push_back(m);
    if (surface.role == Role::Refractor && !surface.thin && met) media_.push_back(m);
    if (is_diffuse(surface.role) && met) meshes_.receivers.push_back(m);
    const int body = row_of_body.try_emplace(bodies[index], material_row(m)).first->second;
    meshes_.bodies.push_back(surface.role == Role::Blended ? kSheet : body);
  }
  first_triangles_ = first_triangles(scene_, meshes_);
  first_receiver_ = static_cast<int>(caster_triangles(scene_, meshes_));
  meshes_.dressed = are_dressed(effects);
  // The camera's rays ask for every triangle's texture coordinates, where they meet any texture.
  meshes_.receivers_dressed = sight_meets_textures(effects) || receivers_are_dressed(effects);
  first_uv_ = caustics::first_uv(scene_, meshes_);
  list_lamps();
  const Bounds bounds = bounds_of(scene_);
  if (!bounds.empty()) touch_ = static_cast<float>(4e-6 * std::max(bounds.radius(), 1e-6));
}

const RayTables::Hierarchy& RayTables::hierarchy() const {
  if (hierarchy_) return *hierarchy_;
  HierarchyTables tables = hierarchy_tables(scene_, meshes_, rows_, touch_);
  const auto uploaded = [this](Image& table) {
    OwnedTexture texture{device_, device_.upload(table)};
    table = {};  // of a million triangles each is some 50 MB
    return texture;
  };
  Hierarchy made;
  made.triangles = uploaded(tables.triangles);
  made.normals = uploaded(tables.normals);
  made.nodes = uploaded(tables.nodes);
  return hierarchy_.emplace(std::move(made));
}

void RayTables::upload_materials(const Effects& effects) {
  // A row for each caster, so that a grid vertex tells which one it lies on; where there are too many for
  // that, a row for each distinct material, number of interfaces, role and wall. Then one for each receivers'
  // material.
  const auto casters = std::count_if(effects.surfaces.begin(), effects.surfaces.end(), is_on_the_way);
  std::map<std::tuple<int, int, bool, Role, bool>, int> row_of;
  rows_.resize(scene_.meshes.size(), 0);
  const auto give_row = [&](std::size_t mesh, int own, const SurfaceRole& role) {
    rows_[mesh] =
        row_of
            .try_emplace({own, scene_.meshes[mesh].material, role.two_interfaces, role.role, is_wall(role)},
                         static_cast<int>(row_of.size()))
            .first->second;
  };
  for (std::size_t i = 0; i < scene_.meshes.size(); ++i)
    if (is_on_the_way(effects.surfaces[i]))
      give_row(i, casters <= kMostOwnRows ? static_cast<int>(i) : 0, effects.surfaces[i]);
  for (std::size_t i = 0; i < scene_.meshes.size(); ++i)
    if (is_diffuse(effects.surfaces[i].role))
      give_row(i, kind_of_receiver(scene_.meshes[i]), {.role = Role::Receiver});
  const bool dressed = are_dressed(effects) || receivers_are_dressed(effects);
  const CasterTexels texels = upload_texels(effects);
  Image table(Format::RGBA32F, dressed ? kTexelsOfDressed : kTexelsOfMaterial,
              std::max(1, static_cast<int>(row_of.size())));
  for (const auto& [key, row] : row_of) {
    const auto& [own, index, two_interfaces, role, thin] = key;
    const Material& material = scene_.materials[static_cast<std::size_t>(index)];
    put_texels(table, row, 0,
               role == Role::Receiver ? texels_of_receiver(material, own)
                                      : texels_of_caster(material, role, thin, two_interfaces));
    if (!dressed) continue;
    put_texels(table, row, 4, picture_texels(material.base_color_texture, texels));
    put_texels(table, row, 7, picture_texels(material.transmission_texture, texels));
    put_texels(table, row, 10, picture_texels(material.normal_texture, texels));
    put_texels(table, row, 13, picture_texels(material.emissive_texture, texels));
  }
  materials_ = {device_, device_.upload(table)};
}

CasterTexels RayTables::upload_texels(const Effects& effects) {
  if (!are_dressed(effects) && !receivers_are_dressed(effects)) return {};
  std::vector<int> images, coarse;
  for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
    const Role role = effects.surfaces[i].role;
    const Material& material = scene_.materials[static_cast<std::size_t>(scene_.meshes[i].material)];
    if (is_on_the_way(effects.surfaces[i])) {
      add_once(images, material.base_color_texture);
      add_once(images, material.transmission_texture);
      if (is_caster(role)) add_once(images, material.normal_texture);
    } else if (is_diffuse(role) && receivers_are_dressed(effects)) {
      const bool cut = effects.cut_out_receivers.active &&
                       (material.alpha_mode == AlphaMode::Mask || effects.surfaces[i].blended);
      add_once(cut ? images : coarse, material.base_color_texture);
      add_once(coarse, material.emissive_texture);
    }
  }
  CasterTexels texels = caster_texels(scene_, images, coarse);
  texels_ = {device_, device_.upload(texels.image)};
  texels.image = {};
  return texels;
}

}  // namespace caustics
