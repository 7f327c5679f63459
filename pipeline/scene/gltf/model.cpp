#include "pipeline/scene/gltf/model.hpp"

namespace caustics::gltf {

namespace {

constexpr std::int64_t kMost = std::int64_t{1} << 53;

// Numbers that check_structure has seen.
std::size_t size_at(const Cursor& object, const char* key) {
  return static_cast<std::size_t>(object.member(key).integer(0, kMost, 0));
}
int index_at(const Cursor& object, const char* key) {
  return static_cast<int>(object.member(key).integer(-1, kMost, -1));
}

template <typename T, typename Read>
std::vector<T> all_of(const Cursor& array, const Read& read) {
  const std::size_t count = array.size();
  std::vector<T> list;
  list.reserve(count);
  for (std::size_t i = 0; i < count; ++i) list.push_back(read(array.element(i)));
  return list;
}

// Likewise, with an empty element in the place of each unused one.
template <typename T, typename Read>
std::vector<T> used_of(const Cursor& array, const std::vector<bool>& used, const Read& read) {
  std::vector<T> list(used.size());
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) list[i] = read(array.element(i));
  return list;
}

std::vector<int> indices_of(const Cursor& array) {
  return all_of<int>(array, [](const Cursor& index) { return static_cast<int>(index.integer(0, kMost)); });
}

BufferView view_of(const Cursor& view) {
  return {size_at(view, "buffer"), size_at(view, "byteOffset"), size_at(view, "byteLength"),
          size_at(view, "byteStride")};
}

ElementPlace place_of(const Cursor& object) {
  return {index_at(object, "bufferView"), size_at(object, "byteOffset")};
}

AccessorLayout accessor_of(const Cursor& accessor) {
  AccessorLayout layout;
  layout.place = place_of(accessor);
  layout.count = size_at(accessor, "count");
  layout.component_type = index_at(accessor, "componentType");
  layout.components = component_count(accessor.member("type").string());
  layout.normalized = accessor.member("normalized").boolean(false);
  const Cursor sparse = accessor.member("sparse");
  if (sparse.present()) {
    const Cursor indices = sparse.member("indices");
    layout.sparse = {size_at(sparse, "count"), index_at(indices, "componentType"), place_of(indices),
                     place_of(sparse.member("values"))};
  }
  return layout;
}

Primitive primitive_of(const Cursor& cursor) {
  Primitive primitive;
  const Cursor attributes = cursor.member("attributes");
  for (const std::string& name : attributes.keys())
    primitive.attributes[name] = index_at(attributes, name.c_str());
  primitive.indices = index_at(cursor, "indices");
  primitive.material = index_at(cursor, "material");
  primitive.mode = static_cast<int>(cursor.member("mode").integer(0, 6, kTriangles));
  return primitive;
}

NodeSource node_of(const Cursor& node) {
  return {indices_of(node.member("children")), node.member("matrix").numbers(16),
          node.member("translation").numbers(3), node.member("rotation").numbers(4),
          node.member("scale").numbers(3)};
}

}  // namespace

std::size_t component_bytes(int component_type) {
  switch (component_type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

int component_count(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4" || type == "MAT2") return 4;
  if (type == "MAT3") return 9;
  return type == "MAT4" ? 16 : 0;
}

Model build_model(const Context& context, const Document& document, const Used& used,
                  std::vector<Bytes> buffers) {
  const Cursor root = document.root(context);
  Model model;
  model.buffers = std::move(buffers);
  model.views = used_of<BufferView>(root.member("bufferViews"), used.views, view_of);
  model.accessors = used_of<AccessorLayout>(root.member("accessors"), used.accessors, accessor_of);
  model.meshes = used_of<MeshSource>(root.member("meshes"), used.meshes, [](const Cursor& mesh) {
    return MeshSource{mesh.member("name").string(""),
                      all_of<Primitive>(mesh.member("primitives"), primitive_of)};
  });
  model.nodes = used_of<NodeSource>(root.member("nodes"), used.nodes, node_of);
  model.scenes = used_of<std::vector<int>>(root.member("scenes"), used.scenes, [](const Cursor& scene) {
    return indices_of(scene.member("nodes"));
  });
  return model;
}

}  // namespace caustics::gltf
