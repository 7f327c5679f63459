#include "pipeline/renderer/scene_on_device.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>

#include "pipeline/effects/optics.hpp"
#include "pipeline/effects/textured_casters.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/material_optics.hpp"
#include "pipeline/scene/mip_levels.hpp"
#include "pipeline/scene/uv_density.hpp"

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
bool receivers_are_dressed(const Effects& effects) {
  return effects.seen_casters.active && effects.textured_receivers.active;
}

// Of a caster (passes/shared/caster_material.glsl, Material).
std::array<glm::vec4, kTexelsOfMaterial> texels_of_caster(const Material& material, bool mirror, bool thin,
                                                          bool two_interfaces) {
  const glm::vec3 absorption = mirror || thin ? glm::vec3(0.0f) : absorption_of(material);
  const glm::vec3 color = mirror ? metal_reflectance(material) : glm::vec3(material.base_color);
  const float cutoff = material.alpha_mode == AlphaMode::Mask ? material.alpha_cutoff : 0.0f;
  return {glm::vec4(material.ior, main_dispersion(material), 1.0f - material.fresnel_factor,
                    mirror ? 1.0f
                    : thin ? -1.0f
                           : 0.0f),
          {absorption, two_interfaces ? 1.0f : 0.0f},
          {color, material.roughness},
          {mirror ? grey_reflectance(material) : transmission_factor(material), material.normal_scale,
           material.base_color.a, cutoff}};
}

// What of a receiver is shown by glass alone (passes/shared/caster_material.glsl, ReceiverMaterial).
std::array<glm::vec4, kTexelsOfMaterial> texels_of_receiver(const Material& m) {
  const float cutoff = m.alpha_mode == AlphaMode::Mask ? m.alpha_cutoff : 0.0f;
  return {glm::vec4(m.emissive, 0.0f),
          {m.fade.centre, m.fade.from},
          {glm::vec3(m.base_color), m.fade.to},
          {0.0f, m.normal_scale, m.base_color.a, cutoff}};
}

void add_once(std::vector<int>& images, const TextureUse& use) {
  if (use.present() && std::find(images.begin(), images.end(), use.image) == images.end())
    images.push_back(use.image);
}

MeshData mesh_data(const Scene& scene, std::size_t index) {
  const Mesh& mesh = scene.meshes[index];
  MeshData data;
  data.layout = {{"position", 3}, {"normal", 3}, {"tangent", 4}, {"uv", 2}, {"uv_density", 2}};
  data.vertices.reserve(mesh.vertices.size() * 14);
  // Of what moves they are asked for in each frame.
  const bool asked = mesh.has_uv && has_mip_map(scene.materials[static_cast<std::size_t>(mesh.material)]);
  const std::vector<glm::vec2> densities = asked ? uv_densities(mesh) : std::vector<glm::vec2>{};
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    const Vertex& v = mesh.vertices[vertex];
    for (int i = 0; i < 3; ++i) data.vertices.push_back(v.position[i]);
    for (int i = 0; i < 3; ++i) data.vertices.push_back(v.normal[i]);
    // Where there are colours, there is no normal texture that would need tangents.
    const glm::vec4& tangent_or_color = mesh.colors.empty() ? v.tangent : mesh.colors[vertex];
    for (int i = 0; i < 4; ++i) data.vertices.push_back(tangent_or_color[i]);
    for (int i = 0; i < 2; ++i) data.vertices.push_back(v.uv[i]);
    for (int i = 0; i < 2; ++i) data.vertices.push_back(densities.empty() ? 0.0f : densities[vertex][i]);
  }
  data.indices = mesh.indices;
  return data;
}

}  // namespace

SceneOnDevice::SceneOnDevice(const Scene& scene, const Effects& effects, Device& device)
    : scene_(scene), device_(device) {
  // Each has its owner before the list may fail to grow.
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    meshes_.push_back(OwnedMesh(device, device.create_mesh(mesh_data(scene, i))));
  for (const Image& image : scene.images) images_.push_back(OwnedTexture(device, device.share(image)));
  for (std::size_t i = 0; i < scene.coarser.size(); ++i)
    if (!scene.coarser[i].values.empty())
      coarser_[static_cast<int>(i)] = {device, device.share(scene.coarser[i])};
  upload_caster_materials(effects);
  number_triangles(effects);
  for (std::size_t i = 0; i < scene.waters.size(); ++i)
    externals_[water_texture(kWaterBefore, i)] = {device, device.upload(scene.waters[i].before)};
  if (scene.environment.image) externals_[kEnvironment] = {device, device.share(*scene.environment.image)};
}

void SceneOnDevice::renew_waters(bool with_state) {
  for (std::size_t i = 0; i < scene_.waters.size(); ++i) {
    const auto mesh = static_cast<std::size_t>(scene_.waters[i].mesh);
    meshes_[mesh] = {device_, device_.create_mesh(mesh_data(scene_, mesh))};
    if (!with_state) continue;
    externals_[water_texture(kWaterBefore, i)] = {device_, device_.upload(scene_.waters[i].before)};
  }
}

void SceneOnDevice::update(const std::vector<int>& meshes) {
  for (const int mesh : meshes) {
    const auto i = static_cast<std::size_t>(mesh);
    device_.update(meshes_[i].id(), mesh_data(scene_, i));
  }
  if (!meshes.empty()) externals_.erase(kHierarchyNodes);
}

TextureId SceneOnDevice::image(int index) const {
  return index < 0 ? TextureId::None : images_[static_cast<std::size_t>(index)].id();
}

TextureId SceneOnDevice::coarser(int index) const {
  const auto found = coarser_.find(index);
  return found == coarser_.end() ? TextureId::None : found->second.id();
}

void SceneOnDevice::number_triangles(const Effects& effects) {
  const std::vector<Optics> optics = optics_of(scene_, effects);
  std::map<int, int> row_of_body;
  for (int m = 0; m < static_cast<int>(optics.size()); ++m) {
    const Optics& o = optics[static_cast<std::size_t>(m)];
    // Nothing walks through moving water; and a tree of its waves would have to be made anew for each frame.
    const bool is_water = std::any_of(scene_.waters.begin(), scene_.waters.end(),
                                      [m](const Water& water) { return water.mesh == m; });
    if (is_caster(o.role) && !is_water) hierarchy_.casters.push_back(m);
    if (o.role == Role::Receiver && !is_water) hierarchy_.receivers.push_back(m);
    hierarchy_.bodies.push_back(row_of_body.try_emplace(o.body, material_row(m)).first->second);
  }
  first_triangles_ = first_triangles(scene_, hierarchy_);
  first_receiver_ = static_cast<int>(caster_triangles(scene_, hierarchy_));
  hierarchy_.dressed = are_dressed(effects);
  // The camera's rays ask for every triangle's texture coordinates, where they meet any texture.
  hierarchy_.receivers_dressed = sight_meets_textures(effects);
  first_uv_ = caustics::first_uv(scene_, hierarchy_);
  const Bounds bounds = bounds_of(scene_);
  if (!bounds.empty()) touch_ = static_cast<float>(4e-6 * std::max(bounds.radius(), 1e-6));
}

void SceneOnDevice::upload_hierarchy() const {
  HierarchyTables tables = hierarchy_tables(scene_, hierarchy_, rows_, touch_);
  const auto upload = [this](const char* name, Image& table) {
    externals_[name] = {device_, device_.upload(table)};
    table = {};  // of a million triangles each is some 50 MB
  };
  upload(kHierarchyTriangles, tables.triangles);
  upload(kHierarchyNormals, tables.normals);
  upload(kHierarchyNodes, tables.nodes);
}

TextureId SceneOnDevice::external(const std::string& name) const {
  const bool of_hierarchy =
      name == kHierarchyNodes || name == kHierarchyTriangles || name == kHierarchyNormals;
  if (of_hierarchy && !externals_.contains(kHierarchyNodes)) upload_hierarchy();
  const auto found = externals_.find(name);
  return found == externals_.end() ? TextureId::None : found->second.id();
}

void SceneOnDevice::upload_caster_materials(const Effects& effects) {
  // A row for each caster, so that a grid vertex tells which one it lies on; where there are too many for
  // that, a row for each distinct material, number of interfaces, role and wall. Then one for each receivers'
  // material.
  const auto casters = std::count_if(effects.surfaces.begin(), effects.surfaces.end(),
                                     [](const SurfaceRole& s) { return is_caster(s.role); });
  std::map<std::tuple<int, int, bool, Role, bool>, int> row_of;
  rows_.resize(scene_.meshes.size(), 0);
  const auto give_row = [&](std::size_t mesh, int own, const SurfaceRole& role) {
    rows_[mesh] =
        row_of
            .try_emplace({own, scene_.meshes[mesh].material, role.two_interfaces, role.role, role.thin},
                         static_cast<int>(row_of.size()))
            .first->second;
  };
  for (std::size_t i = 0; i < scene_.meshes.size(); ++i)
    if (is_caster(effects.surfaces[i].role))
      give_row(i, casters <= kMostOwnRows ? static_cast<int>(i) : 0, effects.surfaces[i]);
  for (std::size_t i = 0; i < scene_.meshes.size(); ++i)
    if (effects.surfaces[i].role == Role::Receiver) give_row(i, 0, {.role = Role::Receiver});
  const bool dressed = are_dressed(effects) || receivers_are_dressed(effects);
  const CasterTexels texels = upload_caster_texels(effects);
  Image table(Format::RGBA32F, dressed ? kTexelsOfDressed : kTexelsOfMaterial,
              std::max(1, static_cast<int>(row_of.size())));
  for (const auto& [key, row] : row_of) {
    const auto& [own, index, two_interfaces, role, thin] = key;
    const Material& material = scene_.materials[static_cast<std::size_t>(index)];
    put_texels(table, row, 0,
               role == Role::Receiver
                   ? texels_of_receiver(material)
                   : texels_of_caster(material, role == Role::Mirror, thin, two_interfaces));
    if (!dressed) continue;
    put_texels(table, row, 4, picture_texels(material.base_color_texture, texels));
    put_texels(table, row, 7, picture_texels(material.transmission_texture, texels));
    put_texels(table, row, 10, picture_texels(material.normal_texture, texels));
    put_texels(table, row, 13, picture_texels(material.emissive_texture, texels));
  }
  externals_[kCasterMaterials] = {device_, device_.upload(table)};
}

CasterTexels SceneOnDevice::upload_caster_texels(const Effects& effects) {
  if (!are_dressed(effects) && !receivers_are_dressed(effects)) return {};
  std::vector<int> images, coarse;
  for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
    const Role role = effects.surfaces[i].role;
    const Material& material = scene_.materials[static_cast<std::size_t>(scene_.meshes[i].material)];
    if (is_caster(role)) {
      add_once(images, material.base_color_texture);
      add_once(images, material.transmission_texture);
      add_once(images, material.normal_texture);
    } else if (role == Role::Receiver && receivers_are_dressed(effects)) {
      add_once(coarse, material.base_color_texture);
      add_once(coarse, material.emissive_texture);
    }
  }
  CasterTexels texels = caster_texels(scene_, images, coarse);
  externals_[kCasterTexels] = {device_, device_.upload(texels.image)};
  texels.image = {};
  return texels;
}

}  // namespace caustics
