#include "pipeline/scene/gltf/morph.hpp"

#include "pipeline/scene/gltf/accessor.hpp"
#include "pipeline/scene/gltf/cursor.hpp"

namespace caustics::gltf {

namespace {

Cursor mesh_cursor(const Context& context, const Document& document, std::size_t mesh) {
  return document.root(context).member("meshes").element(mesh);
}

std::vector<glm::vec3> read_differences(const Context& context, const Cursor& attribute, const Model& model,
                                        std::size_t vertices, std::span<const std::uint32_t> used) {
  std::vector<glm::vec3> values;
  const auto index = attribute.optional_index("accessors", model.accessors.size());
  if (!index) return values;
  const Accessor accessor(context, model, *index);
  if (accessor.components() != 3 || accessor.component_type() == kUnsignedInt) {
    attribute.fail("has the wrong type for a morph target", kExportAgain);
  }
  if (accessor.size() != vertices) {
    attribute.fail(
        "has " + std::to_string(accessor.size()) + " elements, POSITION " + std::to_string(vertices),
        kExportAgain);
  }
  values.reserve(used.size());
  for (const std::uint32_t i : used) {
    glm::dvec3 value(accessor.value(i, 0), accessor.value(i, 1), accessor.value(i, 2));
    if (!exact::finite(value))
      attribute.fail("element " + std::to_string(i) + " is not finite", kExportAgain);
    values.emplace_back(value);
  }
  return values;
}

}  // namespace

std::size_t target_count(const Context& context, const Document& document, std::size_t mesh) {
  const Cursor primitives = mesh_cursor(context, document, mesh).member("primitives");
  std::size_t count = 0;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const Cursor targets = primitives.element(i).member("targets");
    if (i > 0 && targets.size() != count)
      targets.fail("has " + std::to_string(targets.size()) + " morph targets, the mesh's first " +
                       "primitive " + std::to_string(count),
                   kExportAgain);
    count = targets.size();
  }
  return count;
}

std::vector<double> rest_weights(const Context& context, const Document& document, std::size_t node,
                                 std::size_t mesh) {
  const std::size_t count = target_count(context, document, mesh);
  const Cursor own = document.root(context).member("nodes").element(node).member("weights");
  const Cursor given = own.present() ? own : mesh_cursor(context, document, mesh).member("weights");
  if (!given.present()) return std::vector<double>(count, 0.0);
  std::vector<double> weights = given.numbers(count);
  for (const double weight : weights)
    if (!(weight > -1e30 && weight < 1e30)) given.fail("has a weight beyond 1e30", kExportAgain);
  return weights;
}

std::vector<MorphTarget> read_targets(Context& context, const Cursor& primitive, const Model& model,
                                      std::size_t vertices, std::span<const std::uint32_t> used) {
  std::vector<MorphTarget> targets;
  const Cursor list = primitive.member("targets");
  for (std::size_t t = 0; t < list.size(); ++t) {
    const Cursor target = list.element(t);
    const auto read = [&](const char* name) {
      return read_differences(context, target.member(name), model, vertices, used);
    };
    for (const std::string& name : target.keys())
      if (name.rfind("TEXCOORD_", 0) == 0) context.note("Morph targets move no texture coordinates here.");
    targets.push_back({read("POSITION"), read("NORMAL"), read("TANGENT")});
  }
  return targets;
}

}  // namespace caustics::gltf
