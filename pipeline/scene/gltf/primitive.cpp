#include "pipeline/scene/gltf/primitive.hpp"

#include <algorithm>
#include <limits>

#include "pipeline/scene/gltf/accessor.hpp"
#include "pipeline/scene/gltf/cursor.hpp"
#include "pipeline/scene/gltf/morph.hpp"
#include "pipeline/scene/gltf/skin.hpp"

namespace caustics::gltf {

namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

// The accessor of an attribute, or none. Its type must be the one that glTF prescribes.
std::optional<Accessor> attribute(const Context& context, const Model& model, const Primitive& primitive,
                                  const std::string& name, int components) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) return std::nullopt;
  Accessor accessor(context, model, found->second);
  const bool is_uint = accessor.component_type() == kUnsignedInt;
  if (accessor.components() != components || is_uint) {
    context.fail(accessor.path(), "has the wrong type for " + name, kExportAgain);
  }
  return accessor;
}

// COLOR_0, of three or four components; none where it is of another type, as old exporters wrote it.
std::optional<Accessor> color_attribute(Context& context, const Model& model, const Primitive& primitive) {
  const auto found = primitive.attributes.find("COLOR_0");
  if (found == primitive.attributes.end()) return std::nullopt;
  Accessor accessor(context, model, found->second);
  const bool fits = accessor.components() == 3 || accessor.components() == 4;
  if (fits && (accessor.is_float() || accessor.normalized())) return accessor;
  context.note(accessor.path() + ": vertex colours are neither floats nor shares of 1 and are left out.");
  return std::nullopt;
}

// Checked indices of a primitive, 0, 1, 2, ... where it has none.
std::vector<std::uint32_t> read_indices(const Context& context, const Model& model,
                                        const Primitive& primitive, std::size_t vertices) {
  std::vector<std::uint32_t> indices;
  if (primitive.indices < 0) {
    for (std::size_t i = 0; i < vertices; ++i) indices.push_back(static_cast<std::uint32_t>(i));
    return indices;
  }
  const Accessor accessor(context, model, primitive.indices);
  const int type = accessor.component_type();
  if (accessor.components() != 1 ||
      (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt)) {
    context.fail(accessor.path(), "indices must be unsigned scalars", kExportAgain);
  }
  const std::uint32_t restart = type == kUnsignedByte    ? 0xFFu
                                : type == kUnsignedShort ? 0xFFFFu
                                                         : 0xFFFFFFFFu;
  indices.reserve(accessor.size());
  for (std::size_t i = 0; i < accessor.size(); ++i) {
    const std::uint32_t value = accessor.unsigned_value(i);
    if (value == restart || value >= vertices) {
      context.fail(accessor.path(),
                   "index " + std::to_string(i) + " is " + std::to_string(value) +
                       (value == restart ? ", the primitive restart value, which glTF forbids"
                                         : ", but there are " + std::to_string(vertices) + " vertices"),
                   kExportAgain);
    }
    indices.push_back(value);
  }
  return indices;
}

// Triangles as glTF 2.0 section 3.7.2.1 winds them.
std::vector<std::array<std::uint32_t, 3>> assemble(const std::vector<std::uint32_t>& index, int mode) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (index.size() < 3) return triangles;
  triangles.reserve(mode == kTriangles ? index.size() / 3 : index.size() - 2);
  if (mode == kTriangles) {
    for (std::size_t i = 0; i + 2 < index.size(); i += 3) {
      triangles.push_back({index[i], index[i + 1], index[i + 2]});
    }
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < index.size(); ++i) {
    if (mode == kTriangleFan) {
      triangles.push_back({index[i + 1], index[i + 2], index[0]});
    } else {
      triangles.push_back({index[i], index[i + 1 + i % 2], index[i + 2 - i % 2]});
    }
  }
  return triangles;
}

void spend(const Context& context, const std::string& path, std::uint64_t& used, std::uint64_t more,
           std::uint64_t most, const char* what) {
  if (more > most - used) {
    context.fail(path, "the scene has more than " + std::to_string(most) + " " + what, "simplify the scene");
  }
  used += more;
}

// Copies the attributes of the vertices that the triangles use, in the order of their first use,
// and renumbers the triangles.
class Gather {
 public:
  Gather(Context& context, const Model& model, const Primitive& primitive, int uv_set)
      : context_(context),
        positions_(*attribute(context, model, primitive, "POSITION", 3)),
        normals_(attribute(context, model, primitive, "NORMAL", 3)),
        tangents_(attribute(context, model, primitive, "TANGENT", 4)),
        uvs_(attribute(context, model, primitive, "TEXCOORD_" + std::to_string(uv_set), 2)),
        colors_(color_attribute(context, model, primitive)) {
    check_count(normals_, "NORMAL");
    check_count(tangents_, "TANGENT");
    check_count(uvs_, "TEXCOORD_" + std::to_string(uv_set));
    check_count(colors_, "COLOR_0");
  }

  std::size_t vertices() const { return positions_.size(); }
  std::string position_path() const { return positions_.path(); }

  // Returns which vertices of the accessors are used, in their new order.
  std::vector<std::uint32_t> run(Shape& shape) {
    std::vector<std::uint32_t> renumbered(positions_.size(), kUnused), used;
    reserve(shape, used);
    for (auto& triangle : shape.triangles) {
      for (std::uint32_t& corner : triangle) {
        if (renumbered[corner] == kUnused) {
          renumbered[corner] = static_cast<std::uint32_t>(shape.positions.size());
          add_vertex(shape, corner);
          used.push_back(corner);
        }
        corner = renumbered[corner];
      }
    }
    return used;
  }

 private:
  // For as many vertices as there can be: lists that grow are copied again and again.
  void reserve(Shape& shape, std::vector<std::uint32_t>& used) const {
    const std::size_t most = std::min(positions_.size(), 3 * shape.triangles.size());
    used.reserve(most);
    shape.positions.reserve(most);
    if (normals_) shape.normals.reserve(most);
    if (tangents_) shape.tangents.reserve(most);
    if (uvs_) shape.uvs.reserve(most);
    if (colors_) shape.colors.reserve(most);
  }

  void check_count(const std::optional<Accessor>& accessor, const std::string& name) const {
    if (accessor && accessor->size() != positions_.size()) {
      context_.fail(accessor->path(),
                    name + " has " + std::to_string(accessor->size()) + " elements, POSITION " +
                        std::to_string(positions_.size()),
                    kExportAgain);
    }
  }

  static glm::dvec3 vec3(const Accessor& accessor, std::size_t i) {
    return {accessor.value(i, 0), accessor.value(i, 1), accessor.value(i, 2)};
  }

  glm::dvec3 position(std::size_t i) const {
    const glm::dvec3 local = vec3(positions_, i);
    if (!exact::finite(local)) {
      context_.fail(positions_.path(), "position " + std::to_string(i) + " is not finite",
                    "repair the mesh and export it again");
    }
    return local;
  }

  // glTF 2.0 section 3.7.2.1 clamps them.
  glm::vec4 color(std::size_t i) const {
    glm::vec4 color(1);
    for (int c = 0; c < colors_->components(); ++c) {
      const double value = colors_->value(i, c);
      color[c] = value >= 0.0 ? static_cast<float>(std::min(value, 1.0)) : 0.0f;
    }
    return color;
  }

  void add_vertex(Shape& shape, std::size_t i) {
    shape.positions.push_back(position(i));
    if (normals_) shape.normals.push_back(vec3(*normals_, i));
    if (tangents_) {
      const glm::dvec3 tangent = vec3(*tangents_, i);
      shape.tangents.push_back({tangent.x, tangent.y, tangent.z, tangents_->value(i, 3)});
    }
    if (uvs_) {
      const glm::dvec2 uv(uvs_->value(i, 0), uvs_->value(i, 1));
      const bool usable = uv.x - uv.x == 0 && uv.y - uv.y == 0;
      shape.uvs.push_back(usable ? uv : glm::dvec2(0));
    }
    if (colors_) shape.colors.push_back(color(i));
  }

  const Context& context_;
  Accessor positions_;
  std::optional<Accessor> normals_, tangents_, uvs_, colors_;
};

// Morph targets and sets of joints are as large as the base shape.
std::uint64_t influence_set_count(const Primitive& primitive) {
  return static_cast<std::uint64_t>(
      std::count_if(primitive.attributes.begin(), primitive.attributes.end(),
                    [](const auto& attribute) { return attribute.first.rfind("JOINTS_", 0) == 0; }));
}

bool can_be_drawn(Context& context, const Primitive& primitive, const std::string& path) {
  if (primitive.mode < kTriangles) {
    context.note(path + ": points and lines are left out.");
    return false;
  }
  if (primitive.attributes.count("POSITION") == 0) {
    context.note(path + " has no POSITION and is left out.");
    return false;
  }
  return true;
}

}  // namespace

std::optional<Body> read_primitive(Context& context, const Document& document, const Model& model,
                                   const Placement& placement, std::size_t number, int uv_set,
                                   std::size_t joints, GeometryBudget& budget) {
  const auto mesh = static_cast<std::size_t>(placement.index);
  const Primitive& primitive = model.meshes[mesh].primitives[number];
  const Cursor cursor =
      document.root(context).member("meshes").element(mesh).member("primitives").element(number);
  Body body;
  Shape& shape = body.shape;
  shape.path = cursor.path();
  if (!can_be_drawn(context, primitive, shape.path)) return std::nullopt;
  const std::string& mesh_name = model.meshes[mesh].name;
  shape.name = printable(!placement.name.empty() ? placement.name
                         : !mesh_name.empty()    ? mesh_name
                                                 : "nodes[" + std::to_string(placement.node) + "]");
  Gather gather(context, model, primitive, uv_set);
  const LoadOptions& limits = context.options();
  const std::uint64_t copies =
      1 + cursor.member("targets").size() + (joints > 0 ? influence_set_count(primitive) : 0);
  spend(context, shape.path, budget.vertices, copies * gather.vertices(), limits.max_vertices, "vertices");
  const auto indices = read_indices(context, model, primitive, gather.vertices());
  const int mode = primitive.mode;
  if (mode == kTriangles && indices.size() % 3 != 0) {
    context.note(shape.path + ": the last " + std::to_string(indices.size() % 3) +
                 " indices make no triangle and are ignored.");
  }
  const std::size_t triangles =
      mode == kTriangles ? indices.size() / 3 : std::max<std::size_t>(indices.size(), 2) - 2;
  spend(context, shape.path, budget.triangles, triangles, limits.max_triangles, "triangles");
  shape.triangles = assemble(indices, mode);
  body.position_path = gather.position_path();
  const std::vector<std::uint32_t> used = gather.run(shape);
  body.targets = read_targets(context, cursor, model, gather.vertices(), used);
  if (joints > 0) read_influences(context, cursor, primitive, model, gather.vertices(), used, joints, body);
  return body;
}

}  // namespace caustics::gltf
