// What rays that go from surface to surface read of a scene: tables on a device.
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/effects/effects.hpp"
#include "pipeline/gpu/owned.hpp"
#include "pipeline/scene/caster_texels.hpp"
#include "pipeline/scene/hierarchy_tables.hpp"

namespace caustics {

// The scene and the device must outlive it. Casters have rows of materials and pictures at once; the
// hierarchy over all casters and receivers is made when one of its textures is first asked for.
class RayTables {
 public:
  RayTables(const Scene& scene, const Effects& effects, Device& device);
  RayTables(const RayTables&) = delete;
  RayTables& operator=(const RayTables&) = delete;

  const Scene& scene() const { return scene_; }
  Device& device() const { return device_; }
  // Moving water is in the hierarchy, as it stands, where light may be followed. Else nothing meets it: a
  // tree of its waves would have to be made anew for each frame.
  void meet_waters(const Effects& effects);
  bool meets_waters() const { return meets_waters_; }
  // Meshes have moved, and what shines may have another shape.
  void renew();

  TextureId materials() const { return materials_.id(); }
  TextureId texels() const { return texels_.id(); }  // None where casters have no pictures
  TextureId nodes() const { return hierarchy().nodes.id(); }
  TextureId triangles() const { return hierarchy().triangles.id(); }
  TextureId normals() const { return hierarchy().normals.id(); }

  // The row of a mesh's material in materials(); 0 for meshes that rays do not meet.
  int material_row(int mesh) const { return rows_[static_cast<std::size_t>(mesh)]; }
  // The number of a mesh's first triangle; -1: none is in the hierarchy.
  int first_triangle(int mesh) const {
    return static_cast<int>(first_triangles_[static_cast<std::size_t>(mesh)]);
  }
  // The mesh of a triangle, by its number; an index into Scene::meshes.
  int mesh_of(int number) const;
  // The triangle's outward normal, unit.
  glm::dvec3 plane_of(int number) const;
  // The bodies that a point is in, as passes/shared/media.glsl has them: those whose surface is first met
  // from inside on the way up, the innermost first.
  glm::vec4 bodies_around(const glm::dvec3& p) const;
  int first_receiver() const { return first_receiver_; }
  int first_uv() const { return first_uv_; }
  // The first texel of a lamp's points in normals(), by Scene::sources; -1: it has none.
  int first_point(int source) const;
  // Metres: surfaces that are as near touch.
  float touch() const { return touch_; }

 private:
  struct Hierarchy {
    OwnedTexture nodes, triangles, normals;
  };
  const Hierarchy& hierarchy() const;
  void upload_materials(const Effects& effects);
  CasterTexels upload_texels(const Effects& effects);
  void number_triangles(const Effects& effects);
  void list_lamps();

  const Scene& scene_;
  Device& device_;
  OwnedTexture materials_, texels_;
  std::vector<int> rows_;
  HierarchyMeshes meshes_;
  std::vector<int> lamps_;  // whose points are in the table, indices into Scene::sources
  std::vector<int> media_;  // casters that light is in behind their surfaces, indices into Scene::meshes
  std::vector<std::int64_t> first_triangles_;
  int first_receiver_ = 0, first_uv_ = 0;
  float touch_ = 0.0f;
  bool meets_waters_ = false;
  mutable std::optional<Hierarchy> hierarchy_;
  mutable std::optional<std::pair<glm::dvec3, glm::vec4>> around_;  // what bodies_around() has found last
};

}  // namespace caustics
