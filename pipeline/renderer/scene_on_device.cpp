#include "pipeline/renderer/scene_on_device.hpp"

#include <cstddef>

#include "pipeline/gpu/device.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/scene/mip_levels.hpp"
#include "pipeline/scene/uv_density.hpp"

namespace caustics {

namespace {

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
    : scene_(scene), device_(device), tables_(scene, effects, device) {
  // Each has its owner before the list may fail to grow.
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    meshes_.push_back(OwnedMesh(device, device.create_mesh(mesh_data(scene, i))));
  for (const Image& image : scene.images) images_.push_back(OwnedTexture(device, device.share(image)));
  for (std::size_t i = 0; i < scene.coarser.size(); ++i)
    if (!scene.coarser[i].values.empty())
      coarser_[static_cast<int>(i)] = {device, device.share(scene.coarser[i])};
  for (std::size_t i = 0; i < scene.waters.size(); ++i)
    externals_[water_texture(kWaterBefore, i)] = {device, device.upload(scene.waters[i].before)};
  if (scene.environment.image) externals_[kEnvironment] = {device, device.share(*scene.environment.image)};
}

void SceneOnDevice::renew_waters(bool with_state) {
  if (tables_.meets_waters()) tables_.renew();
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
  if (!meshes.empty()) tables_.renew();
}

TextureId SceneOnDevice::image(int index) const {
  return index < 0 ? TextureId::None : images_[static_cast<std::size_t>(index)].id();
}

TextureId SceneOnDevice::coarser(int index) const {
  const auto found = coarser_.find(index);
  return found == coarser_.end() ? TextureId::None : found->second.id();
}

TextureId SceneOnDevice::external(const std::string& name) const {
  if (name == kCasterMaterials) return tables_.materials();
  if (name == kCasterTexels) return tables_.texels();
  if (name == kHierarchyNodes) return tables_.nodes();
  if (name == kHierarchyTriangles) return tables_.triangles();
  if (name == kHierarchyNormals) return tables_.normals();
  const auto found = externals_.find(name);
  return found == externals_.end() ? TextureId::None : found->second.id();
}

}  // namespace caustics
