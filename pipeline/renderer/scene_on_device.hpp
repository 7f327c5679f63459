// A scene's meshes, material textures and tables on a device.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "pipeline/effects/ray_tables.hpp"
#include "pipeline/gpu/owned.hpp"

namespace caustics {

// Uploads on construction, releases on destruction; the scene and the device must outlive it. Images and
// environment are shared with the device.
// Meshes carry the attributes "position" 3, "normal" 3, "tangent" 4 (or Mesh::colors), "uv" 2,
// "uv_density" 2.
class SceneOnDevice {
 public:
  SceneOnDevice(const Scene& scene, const Effects& effects, Device& device);
  SceneOnDevice(const SceneOnDevice&) = delete;
  SceneOnDevice& operator=(const SceneOnDevice&) = delete;

  // After the scene has changed: uploads these meshes anew (indices into Scene::meshes). They must have
  // kept their numbers of vertices and indices; nothing else of the scene that is here may have changed.
  void update(const std::vector<int>& meshes);

  const Scene& scene() const { return scene_; }
  Device& device() const { return device_; }
  MeshId mesh(int index) const { return meshes_[static_cast<std::size_t>(index)].id(); }
  // Takes the scene's waters as they stand now: their meshes, and if asked for Water::before.
  void renew_waters(bool with_state);
  // As RayTables has it.
  void meet_waters(const Effects& effects) { tables_.meet_waters(effects); }
  TextureId image(int index) const;                   // None for index -1
  TextureId coarser(int index) const;                 // its mip levels but for the first; None: it has none
  TextureId external(const std::string& name) const;  // kCasterMaterials, kEnvironment, a water's, or None
  // What rays read of it.
  const RayTables& tables() const { return tables_; }

 private:
  const Scene& scene_;
  Device& device_;
  RayTables tables_;
  std::vector<OwnedMesh> meshes_;
  std::vector<OwnedTexture> images_;
  std::map<int, OwnedTexture> coarser_;
  std::map<std::string, OwnedTexture> externals_;
};

}  // namespace caustics
