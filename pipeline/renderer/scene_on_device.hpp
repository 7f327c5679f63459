// A scene's meshes, material textures and tables on a device.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "pipeline/gpu/owned.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/scene/caster_texels.hpp"
#include "pipeline/scene/hierarchy_tables.hpp"

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
  TextureId image(int index) const;                   // None for index -1
  TextureId coarser(int index) const;                 // its mip levels but for the first; None: it has none
  TextureId external(const std::string& name) const;  // kCasterMaterials, kEnvironment, a water's, or None
  // The row of a caster's material in kCasterMaterials; 0 for meshes that are no casters.
  int material_row(int mesh) const { return rows_[static_cast<std::size_t>(mesh)]; }

  // Of the hierarchy over all casters and receivers (pipeline/scene/hierarchy_tables.hpp): it is made when
  // one of its textures is first asked for.
  int first_triangle(int mesh) const {
    return static_cast<int>(first_triangles_[static_cast<std::size_t>(mesh)]);
  }
  int first_receiver() const { return first_receiver_; }
  int first_uv() const { return first_uv_; }
  // Metres: surfaces that are as near touch.
  float touch() const { return touch_; }

 private:
  void upload_caster_materials(const Effects& effects);
  CasterTexels upload_caster_texels(const Effects& effects);
  void number_triangles(const Effects& effects);
  void upload_hierarchy() const;

  const Scene& scene_;
  Device& device_;
  std::vector<OwnedMesh> meshes_;
  std::vector<OwnedTexture> images_;
  std::map<int, OwnedTexture> coarser_;
  std::vector<int> rows_;
  HierarchyMeshes hierarchy_;
  std::vector<std::int64_t> first_triangles_;
  int first_receiver_ = 0, first_uv_ = 0;
  float touch_ = 0.0f;
  mutable std::map<std::string, OwnedTexture> externals_;
};

}  // namespace caustics
