#include "pipeline/scene/load_gltf.hpp"

#include <algorithm>
#include <map>
#include <new>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/gltf/check.hpp"
#include "pipeline/scene/gltf/lights.hpp"
#include "pipeline/scene/gltf/materials.hpp"
#include "pipeline/scene/gltf/medium.hpp"
#include "pipeline/scene/gltf/nodes.hpp"
#include "pipeline/scene/gltf/primitive.hpp"
#include "pipeline/scene/gltf/resources.hpp"
#include "pipeline/scene/gltf/surface.hpp"
#include "pipeline/scene/gltf/topology.hpp"

namespace caustics {

namespace {

using gltf::Context;
using gltf::Document;
using gltf::Shape;

// Everything that the meshes are made from.
struct Source {
  Context& context;
  const Document& document;
  const tinygltf::Model& model;
  const gltf::Materials& materials;
};

// One node's primitives: read, cleaned, joined by material, with normals and tangents.
std::vector<Shape> shapes_of(const Source& source, const gltf::Placement& placement, int object,
                             gltf::GeometryBudget& budget, std::size_t& degenerate) {
  const auto& primitives =
      source.model.meshes[static_cast<std::size_t>(placement.index)].primitives;
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const int material =
        primitives[i].material < 0 ? source.materials.fallback() : primitives[i].material;
    const int uv_set = source.materials.uv_sets[static_cast<std::size_t>(material)];
    auto shape = gltf::read_primitive(source.context, source.document, source.model, placement, i,
                                      uv_set, budget);
    if (!shape) continue;
    shape->material = material;
    shape->object = object;
    degenerate += gltf::drop_degenerate(*shape);
    if (!shape->triangles.empty()) shapes.push_back(std::move(*shape));
  }
  std::map<int, std::vector<Shape*>> groups;
  for (Shape& shape : shapes) groups[shape.material].push_back(&shape);
  for (const auto& [material, group] : groups) {
    const Material& m = source.materials.list[static_cast<std::size_t>(material)];
    gltf::join_group(source.context, group, m.transmission > 0);
  }
  for (Shape& shape : shapes) {
    const Material& m = source.materials.list[static_cast<std::size_t>(shape.material)];
    gltf::finish_normals(source.context, shape);
    if (m.normal_texture.present()) {
      gltf::finish_tangents(source.context, shape, m.normal_texture.uv_transform);
    } else {
      shape.tangents.clear();
    }
    const bool textured = m.normal_texture.present() || m.base_color_texture.present();
    if (textured && shape.uvs.empty()) {
      source.context.note(shape.name + " has no texture coordinates for its textures.");
    }
  }
  return shapes;
}

glm::dvec3 centre_of(const std::vector<Shape>& shapes) {
  Bounds bounds;
  for (const Shape& shape : shapes) {
    for (const auto& triangle : shape.triangles) {
      for (const std::uint32_t corner : triangle) bounds.add(shape.positions[corner]);
    }
  }
  return bounds.empty() ? glm::dvec3(0) : bounds.centre();
}

// The meshes in scene space; sets the scene's origin.
void build_meshes(const Source& source, const std::vector<gltf::Placement>& placements,
                  Scene& scene) {
  std::vector<Shape> shapes;
  gltf::GeometryBudget budget;
  std::size_t degenerate = 0;
  int object = 0;
  for (const gltf::Placement& placement : placements) {
    for (Shape& shape : shapes_of(source, placement, object, budget, degenerate)) {
      shapes.push_back(std::move(shape));
    }
    ++object;
  }
  if (degenerate > 0) {
    source.context.note(std::to_string(degenerate) + " triangles without area were dropped.");
  }
  if (shapes.empty()) source.context.note("The scene has no triangles.");
  scene.origin = centre_of(shapes);
  for (Shape& shape : shapes) {
    scene.meshes.push_back(gltf::finish_mesh(shape, scene.origin));
    shape = Shape();  // its memory is no longer needed
  }
}

Scene load(Context& context) {
  Document document = gltf::read_document(context);
  gltf::check_extensions(context, document);
  gltf::check_structure(context, document);
  const tinygltf::Model model =
      gltf::build_model(context, document, gltf::read_buffers(context, document));
  document.bin = {};
  document.bytes = {};
  Scene scene;
  scene.file = context.path().string();
  const gltf::Placements placements = gltf::place_nodes(context, document, model);
  gltf::Textures textures(context, document, model);
  const gltf::Materials materials = gltf::read_materials(context, document, textures);
  build_meshes({context, document, model, materials}, placements.meshes, scene);
  scene.lights = gltf::read_lights(context, document, placements.lights, scene.origin);
  scene.cameras = gltf::read_cameras(context, document, placements.cameras, scene.origin);
  scene.medium = gltf::read_medium(context, document);
  if (document.root(context).member("animations").size() > 0) {
    context.note("Animations are not played: the scene stands as at rest.");
  }
  scene.materials = materials.list;
  const bool needs_fallback =
      std::any_of(scene.meshes.begin(), scene.meshes.end(),
                  [&](const Mesh& mesh) { return mesh.material == materials.fallback(); });
  if (!needs_fallback) scene.materials.pop_back();
  scene.images = std::move(textures.images());
  scene.notes = std::move(context.notes());
  return scene;
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options) {
  Context context(path, options);
  try {
    return load(context);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    context.fail("", "needs more memory than there is", "simplify the scene");
  } catch (const std::exception& problem) {
    // Whatever a library throws on a file is the file's fault here: nothing else came in.
    context.fail("", std::string("cannot be read: ") + problem.what(), "export it again");
  }
}

}  // namespace caustics
