#include "pipeline/scene/gltf/load_gltf.hpp"

#include <algorithm>
#include <map>
#include <new>
#include <optional>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/gltf/check.hpp"
#include "pipeline/scene/gltf/compressed.hpp"
#include "pipeline/scene/gltf/lights.hpp"
#include "pipeline/scene/gltf/materials.hpp"
#include "pipeline/scene/gltf/medium.hpp"
#include "pipeline/scene/gltf/morph.hpp"
#include "pipeline/scene/gltf/motion.hpp"
#include "pipeline/scene/gltf/primitive.hpp"
#include "pipeline/scene/gltf/resources.hpp"
#include "pipeline/scene/gltf/stated_shape.hpp"
#include "pipeline/scene/gltf/surface.hpp"
#include "pipeline/scene/gltf/topology.hpp"
#include "pipeline/scene/gltf/water.hpp"
#include "pipeline/scene/mip_levels.hpp"

namespace caustics {

namespace {

using gltf::Context;
using gltf::Document;
using gltf::Json;
using gltf::Shape;

// Everything that the meshes are made from.
struct Source {
  Context& context;
  const Document& document;
  const gltf::Model& model;
  const gltf::Materials& materials;
  const gltf::Placements& placements;
  const std::vector<gltf::Skin>& skins;
  const gltf::Stance& rest;
  std::vector<bool> moving;  // by Placements::meshes
};

// A primitive in its place. Of one that moves, `body` is what is placed anew for each moment, and
// `shape` a copy at rest in its own coordinates, which is judged in its stead.
struct MeshPart {
  Shape shape;
  std::optional<gltf::Body> body;
};

// One primitive, read and placed.
std::optional<MeshPart> read_part(const Source& source, std::size_t placement, std::size_t primitive,
                                  int material, gltf::GeometryBudget& budget) {
  const gltf::Placement& place = source.placements.meshes[placement];
  const int uv_set = source.materials.uv_sets[static_cast<std::size_t>(material)];
  const std::size_t joints =
      place.skin < 0 ? 0 : source.skins[static_cast<std::size_t>(place.skin)].joints.size();
  auto body = gltf::read_primitive(source.context, source.document, source.model, place, primitive, uv_set,
                                   joints, budget);
  if (!body) return std::nullopt;
  std::vector<exact::Affine> matrices;
  gltf::Pose pose = gltf::pose_of(place, source.skins, source.rest, *body, matrices);
  MeshPart part;
  if (source.moving[placement]) {
    pose = {.to_world = {}, .morph = pose.morph};
    part.shape = gltf::posed(source.context, *body, pose);
    part.body = std::move(body);
  } else {
    part.shape = gltf::posed(source.context, std::move(*body), pose);
  }
  return part;
}

// Joins the parts of each material, which exporters split solid glass into.
void join_parts(const Source& source, std::vector<MeshPart>& parts) {
  std::map<int, std::vector<Shape*>> groups;
  for (MeshPart& part : parts) groups[part.shape.material].push_back(&part.shape);
  for (const auto& [material, group] : groups) {
    const Material& m = source.materials.list[static_cast<std::size_t>(material)];
    gltf::join_group(source.context, group, m.transmission > 0);
  }
}

// What was found out about the shape holds for the body at all times.
void hand_over(const Shape& shape, gltf::Body& body) {
  body.shape.triangles = shape.triangles;
  body.shape.closedness = shape.closedness;
  body.shape.inside_out = shape.inside_out;
  body.shape.material = shape.material;
  body.shape.object = shape.object;
}

// Vertex colours count where the camera sees a diffuse surface, and take the tangents' place.
void keep_colors(const Source& source, const Material& material, MeshPart& part) {
  const bool all_white = std::all_of(part.shape.colors.begin(), part.shape.colors.end(),
                                     [](const glm::vec4& color) { return color == glm::vec4(1); });
  const char* other = material.normal_texture.present() ? "beside a normal texture"
                      : !is_receiver(material)          ? "on glass and mirrors"
                                                        : nullptr;
  if (!all_white && !other) return;
  if (!all_white) source.context.note(part.shape.name + ": vertex colours are ignored " + other + ".");
  part.shape.colors.clear();
  if (part.body) part.body->shape.colors.clear();
}

// One node's primitives: read, cleaned, joined by material, with normals and tangents.
std::vector<MeshPart> parts_of(const Source& source, std::size_t placement, int object,
                               gltf::GeometryBudget& budget, std::size_t& degenerate) {
  const auto mesh = static_cast<std::size_t>(source.placements.meshes[placement].index);
  const auto& primitives = source.model.meshes[mesh].primitives;
  std::vector<MeshPart> parts;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const int material = primitives[i].material < 0 ? source.materials.fallback() : primitives[i].material;
    auto part = read_part(source, placement, i, material, budget);
    if (!part) continue;
    part->shape.material = material;
    part->shape.object = object;
    degenerate += gltf::drop_degenerate(part->shape);
    if (!part->shape.triangles.empty()) parts.push_back(std::move(*part));
  }
  join_parts(source, parts);
  for (MeshPart& part : parts) {
    Shape& shape = part.shape;
    const Material& m = source.materials.list[static_cast<std::size_t>(shape.material)];
    keep_colors(source, m, part);
    if (part.body) hand_over(shape, *part.body);
    gltf::finish_normals(source.context, shape);
    if (m.normal_texture.present()) {
      gltf::finish_tangents(source.context, shape, m.normal_texture.uv_transform);
    } else {
      shape.tangents.clear();
    }
    const bool textured = m.normal_texture.present() || m.base_color_texture.present() ||
                          m.metallic_roughness_texture.present() || m.occlusion_texture.present();
    if (textured && shape.uvs.empty()) {
      source.context.note(shape.name + " has no texture coordinates for its textures.");
    }
  }
  return parts;
}

void add_bounds(const Shape& shape, Bounds& bounds) {
  for (const auto& triangle : shape.triangles) {
    for (const std::uint32_t corner : triangle) bounds.add(shape.positions[corner]);
  }
}

// The primitives of the scene: those that stand still as shapes, the others as bodies. `order` says
// which comes next: a shape (false) or a body (true).
struct Geometry {
  std::vector<Shape> shapes;
  std::vector<gltf::MovingBody> bodies;
  std::vector<bool> order;
};

Geometry read_geometry(const Source& source) {
  Geometry geometry;
  gltf::GeometryBudget budget;
  std::size_t degenerate = 0;
  for (std::size_t i = 0; i < source.placements.meshes.size(); ++i) {
    for (MeshPart& part : parts_of(source, i, static_cast<int>(i), budget, degenerate)) {
      geometry.order.push_back(part.body.has_value());
      if (!part.body) {
        geometry.shapes.push_back(std::move(part.shape));
        continue;
      }
      const TextureUse& normals =
          source.materials.list[static_cast<std::size_t>(part.shape.material)].normal_texture;
      geometry.bodies.push_back({.body = std::move(*part.body),
                                 .placement = i,
                                 .tangents = normals.present(),
                                 .uv_transform = normals.uv_transform});
    }
  }
  if (degenerate > 0) {
    source.context.note(std::to_string(degenerate) + " triangles without area were dropped.");
  }
  if (geometry.order.empty()) source.context.note("The scene has no triangles.");
  return geometry;
}

// The meshes in scene space; sets the scene's origin. Moving ones are left empty for the motion.
void build_meshes(Geometry& geometry, gltf::GltfMotion* motion, Scene& scene) {
  Bounds bounds;
  for (const Shape& shape : geometry.shapes) add_bounds(shape, bounds);
  if (motion) {
    for (const Bounds& swept : motion->swept()) bounds.add(swept);
  }
  scene.origin = bounds.empty() ? glm::dvec3(0) : bounds.centre();
  std::vector<int> moving;
  auto shape = geometry.shapes.begin();
  for (const bool moves : geometry.order) {
    if (moves) {
      moving.push_back(static_cast<int>(scene.meshes.size()));
      scene.meshes.emplace_back();
      continue;
    }
    scene.meshes.push_back(gltf::finish_mesh(*shape, scene.origin));
    *shape++ = Shape();  // its memory is no longer needed
  }
  if (motion) motion->set_meshes(moving, scene.origin);
}

std::vector<std::vector<double>> read_rest_weights(const Context& context, const Document& document,
                                                   const gltf::Placements& placements) {
  std::vector<std::vector<double>> weights(placements.tree.size());
  for (const gltf::Placement& placement : placements.meshes) {
    weights[placement.place] = gltf::rest_weights(context, document, static_cast<std::size_t>(placement.node),
                                                  static_cast<std::size_t>(placement.index));
  }
  return weights;
}

// The skins that meshes use, by their numbers; the others stay empty.
std::vector<gltf::Skin> read_skins(const Context& context, const Document& document, const gltf::Model& model,
                                   const gltf::Placements& placements) {
  std::vector<gltf::Skin> skins(document.root(context).member("skins").size());
  std::vector<bool> read(skins.size(), false);
  for (const gltf::Placement& placement : placements.meshes) {
    if (placement.skin < 0) continue;
    const auto skin = static_cast<std::size_t>(placement.skin);
    if (!read[skin]) skins[skin] = gltf::read_skin(context, document, model, skin, placements);
    read[skin] = true;
  }
  return skins;
}

// The nodes that the animation moves, with all that hang on them; by Placements::tree.
std::vector<bool> moving_nodes(const gltf::Placements& placements, const gltf::Animation& animation) {
  std::vector<bool> moves(placements.tree.size(), false);
  for (const gltf::Channel& channel : animation.channels) {
    const int place = placements.place_of[channel.node];
    if (place >= 0 && channel.property != gltf::Property::Weights)
      moves[static_cast<std::size_t>(place)] = true;
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const int parent = placements.tree[i].parent;
    if (parent >= 0 && moves[static_cast<std::size_t>(parent)]) moves[i] = true;
  }
  return moves;
}

// By Placements::meshes.
std::vector<bool> moving_meshes(const gltf::Placements& placements, const std::vector<gltf::Skin>& skins,
                                const gltf::Animation& animation, const std::vector<bool>& nodes) {
  std::vector<bool> morphs(placements.tree.size(), false);
  for (const gltf::Channel& channel : animation.channels) {
    const int place = placements.place_of[channel.node];
    if (place >= 0 && channel.property == gltf::Property::Weights)
      morphs[static_cast<std::size_t>(place)] = true;
  }
  std::vector<bool> moves;
  for (const gltf::Placement& placement : placements.meshes) {
    bool any = nodes[placement.place] || morphs[placement.place];
    if (placement.skin >= 0) {
      for (const std::size_t joint : skins[static_cast<std::size_t>(placement.skin)].joints)
        any = any || nodes[joint];
    }
    moves.push_back(any);
  }
  return moves;
}

bool any_moves(const std::vector<gltf::Placement>& placements, const std::vector<bool>& nodes) {
  return std::any_of(placements.begin(), placements.end(),
                     [&](const gltf::Placement& p) { return nodes[p.place]; });
}

// The part of the document that places lights and cameras.
Document without_data(Document document) {
  document.bin = {};
  document.bytes = {};
  auto& members = document.json.as<Json::Object>();
  std::erase_if(members, [](const gltf::JsonMember& member) {
    return member.key != "nodes" && member.key != "cameras" && member.key != "extensions";
  });
  return document;
}

// Bytes of geometry at their most, measured: a primitive in its place, in double precision, with what finds
// out its holes and normals; and all meshes beside it.
constexpr std::uint64_t kBytesOfVertex = 190, kBytesOfIndex = 70;

std::uint64_t geometry_bytes(const gltf::Model& model, const gltf::Placements& placements) {
  std::uint64_t bytes = 0;
  const auto count = [&](int accessor) -> std::uint64_t {
    return accessor < 0 ? 0 : model.accessors[static_cast<std::size_t>(accessor)].count;
  };
  for (const gltf::Placement& placement : placements.meshes) {
    for (const gltf::Primitive& primitive :
         model.meshes[static_cast<std::size_t>(placement.index)].primitives) {
      const auto positions = primitive.attributes.find("POSITION");
      const std::uint64_t vertices = positions == primitive.attributes.end() ? 0 : count(positions->second);
      const std::uint64_t indices = primitive.indices < 0 ? vertices : count(primitive.indices);
      bytes += kBytesOfVertex * vertices + kBytesOfIndex * indices;
    }
  }
  return bytes;
}

struct Loaded {
  Scene scene;
  std::shared_ptr<gltf::GltfMotion> motion;  // null: nothing moves
  std::vector<std::filesystem::path> files;  // that the document refers to
};

Loaded load(Context& context) {
  Document document = gltf::read_document(context);
  gltf::check_extensions(context, document);
  const gltf::Used used = gltf::used_by_scene(context, document);
  gltf::check_structure(context, document, used);
  gltf::Model model = gltf::build_model(context, document, used, gltf::read_buffers(context, document, used));
  gltf::unpack_views(context, document, used, model);
  gltf::unpack_primitives(context, document, model);
  document.bin = {};
  document.bytes = {};
  Loaded loaded;
  loaded.files = gltf::referred_files(context, document);
  Scene& scene = loaded.scene;
  scene.file = context.path().string();
  gltf::Placements placements = gltf::place_nodes(context, document, model);
  context.need_memory(geometry_bytes(model, placements), "meshes");
  gltf::Textures textures(context, document, model);
  const gltf::Materials materials = gltf::read_materials(context, document, used, textures);
  std::vector<gltf::Skin> skins = read_skins(context, document, model, placements);
  std::vector<std::vector<double>> weights = read_rest_weights(context, document, placements);
  gltf::Animation animation = gltf::read_animation(context, document, model).value_or(gltf::Animation{});
  const std::vector<bool> nodes = moving_nodes(placements, animation);
  gltf::Stance rest(placements, weights);
  rest.finish(context);
  Geometry geometry = read_geometry({context, document, model, materials, placements, skins, rest,
                                     moving_meshes(placements, skins, animation, nodes)});
  if (!geometry.bodies.empty() || any_moves(placements.lights, nodes) ||
      any_moves(placements.cameras, nodes)) {
    loaded.motion = std::make_shared<gltf::GltfMotion>(gltf::MotionParts{context.path(),
                                                                         context.options(),
                                                                         {},
                                                                         placements,
                                                                         std::move(weights),
                                                                         std::move(skins),
                                                                         std::move(animation),
                                                                         std::move(geometry.bodies)});
  }
  build_meshes(geometry, loaded.motion.get(), scene);
  gltf::read_stated_shapes(document.root(context), placements.meshes, scene);
  gltf::read_waters(document.root(context), placements.meshes, scene);
  scene.lights = gltf::read_lights(context, document, placements.lights, scene.origin);
  scene.cameras = gltf::read_cameras(context, document, placements.cameras, scene.origin);
  scene.medium = gltf::read_medium(context, document);
  scene.materials = materials.list;
  scene.images = std::move(textures.images());
  add_mip_levels(scene);
  scene.notes = std::move(context.notes());
  if (loaded.motion) loaded.motion->start(without_data(std::move(document)), scene);
  const bool needs_fallback = std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
    return mesh.material == materials.fallback();
  });
  if (!needs_fallback) scene.materials.pop_back();
  return loaded;
}

// Runs the loader so that whatever goes wrong is one line about the file.
Loaded load_file(const std::filesystem::path& path, const LoadOptions& options) {
  try {
    Context context(path, options);
    return load(context);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    Context(path, options).fail("", "needs more memory than there is", "simplify the scene");
  } catch (const std::exception& problem) {
    // Whatever a library throws on a file is the file's fault here: nothing else came in.
    Context(path, options).fail("", std::string("cannot be read: ") + problem.what(), "export it again");
  }
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options) {
  return load_file(path, options).scene;
}

AnimatedScene load_animated(const std::filesystem::path& path, const LoadOptions& options) {
  Loaded loaded = load_file(path, options);
  return AnimatedScene(std::move(loaded.scene), std::move(loaded.motion), std::move(loaded.files));
}

}  // namespace caustics
