#include "pipeline/scene/gltf/check.hpp"

#include <algorithm>
#include <limits>

#include "pipeline/scene/gltf/model.hpp"

namespace caustics::gltf {

namespace {

constexpr std::int64_t kMostBytes = std::int64_t{1} << 53;

struct Counts {
  std::size_t buffers, views, accessors, meshes, nodes, materials, cameras;
};

Counts count(const Cursor& root) {
  return {root.member("buffers").size(), root.member("bufferViews").size(), root.member("accessors").size(),
          root.member("meshes").size(),  root.member("nodes").size(),       root.member("materials").size(),
          root.member("cameras").size()};
}

struct CheckedType {
  int code;
  std::int64_t bytes;
};

CheckedType checked_type(const Cursor& type) {
  const int code = static_cast<int>(type.integer(0, 65535));
  const std::size_t bytes = component_bytes(code);
  if (bytes == 0) type.fail("is not a component type of glTF 2.0", kExportAgainOrCorrect);
  return {code, static_cast<std::int64_t>(bytes)};
}

std::int64_t checked_count(const Cursor& type) {
  const int count = component_count(type.string());
  if (count == 0) type.fail("is not an accessor type of glTF 2.0: " + type.string(), kExportAgainOrCorrect);
  return count;
}

std::int64_t length_of(const Cursor& object) { return object.member("byteLength").integer(1, kMostBytes); }
std::int64_t offset_of(const Cursor& object) { return object.member("byteOffset").integer(0, kMostBytes, 0); }

void check_view(const Cursor& root, const Cursor& view, const Counts& counts) {
  const int buffer = view.member("buffer").index("buffers", counts.buffers);
  const std::int64_t room = length_of(root.member("buffers").element(static_cast<std::size_t>(buffer)));
  const std::int64_t offset = offset_of(view), length = length_of(view);
  const Cursor stride = view.member("byteStride");
  if (stride.integer(4, 252, 4) % 4 != 0) stride.fail("must be a multiple of 4", kExportAgainOrCorrect);
  if (offset > room || length > room - offset) {
    view.fail("ends at byte " + std::to_string(offset + length) + ", but buffers[" + std::to_string(buffer) +
                  "] has " + std::to_string(room),
              kExportAgainOrCorrect);
  }
}

// `count` elements of `size` bytes at a stride, from `offset` on, must lie inside the view.
void check_extent(const Cursor& root, const Cursor& place, const Counts& counts, std::int64_t elements,
                  std::int64_t size, bool may_be_strided) {
  const int index = place.member("bufferView").index("bufferViews", counts.views);
  const Cursor view = root.member("bufferViews").element(static_cast<std::size_t>(index));
  const Cursor step = view.member("byteStride");
  const std::int64_t stride = may_be_strided ? step.integer(4, 252, size) : size;
  if (stride < size) {
    step.fail("is " + std::to_string(stride) + ", less than the " + std::to_string(size) +
                  " bytes of an element of " + place.path(),
              kExportAgainOrCorrect);
  }
  const std::int64_t room = length_of(view), offset = offset_of(place);
  // Divided instead of multiplied: no product of two numbers from the file can overflow.
  const bool fits =
      offset <= room && size <= room - offset && (elements - 1) <= (room - offset - size) / stride;
  if (!fits) {
    place.fail("its " + std::to_string(elements) + " elements reach beyond the " + std::to_string(room) +
                   " bytes of bufferViews[" + std::to_string(index) + "]",
               kExportAgainOrCorrect);
  }
}

void check_sparse(const Cursor& root, const Cursor& sparse, const Counts& counts, std::int64_t elements,
                  std::int64_t element_size) {
  const std::int64_t changed = sparse.member("count").integer(1, elements);
  const Cursor indices = sparse.member("indices");
  const Cursor type = indices.member("componentType");
  const auto [code, size] = checked_type(type);
  if (code != kUnsignedByte && code != kUnsignedShort && code != kUnsignedInt)
    type.fail("must be an unsigned type", kExportAgainOrCorrect);
  check_extent(root, indices, counts, changed, size, false);
  check_extent(root, sparse.member("values"), counts, changed, element_size, false);
}

void check_accessor(const Cursor& root, const Cursor& accessor, const Counts& counts) {
  const std::int64_t size =
      checked_type(accessor.member("componentType")).bytes * checked_count(accessor.member("type"));
  const auto most = static_cast<std::int64_t>(std::min<std::uint64_t>(
      accessor.context().options().max_vertices * 3, std::numeric_limits<std::int32_t>::max()));
  const std::int64_t elements = accessor.member("count").integer(1, most);
  accessor.member("normalized").boolean(false);
  offset_of(accessor);
  if (accessor.member("bufferView").present()) {
    check_extent(root, accessor, counts, elements, size, true);
  }
  const Cursor sparse = accessor.member("sparse");
  if (sparse.present()) check_sparse(root, sparse, counts, elements, size);
}

void check_primitive(const Cursor& primitive, const Counts& counts) {
  const Cursor attributes = primitive.member("attributes");
  for (const std::string& name : attributes.keys()) {
    attributes.member(name).index("accessors", counts.accessors);
  }
  primitive.member("indices").optional_index("accessors", counts.accessors);
  primitive.member("material").optional_index("materials", counts.materials);
  primitive.member("mode").integer(0, 6, 4);
}

void check_node(const Cursor& node, const Counts& counts) {
  const Cursor children = node.member("children");
  for (std::size_t i = 0; i < children.size(); ++i) {
    children.element(i).index("nodes", counts.nodes);
  }
  node.member("mesh").optional_index("meshes", counts.meshes);
  node.member("camera").optional_index("cameras", counts.cameras);
  node.member("matrix").numbers(16);
  node.member("translation").numbers(3);
  node.member("rotation").numbers(4);
  node.member("scale").numbers(3);
  node.member("name").string("");
}

template <typename Check>
void check_each(const Cursor& array, const Check& check) {
  const std::size_t size = array.size();
  for (std::size_t i = 0; i < size; ++i) check(array.element(i));
}

// As many as the array has elements.
template <typename Check>
void check_used(const Cursor& array, const std::vector<bool>& used, const Check& check) {
  const std::size_t size = array.size();
  for (std::size_t i = 0; i < size; ++i)
    if (used[i]) check(array.element(i));
}

}  // namespace

void check_structure(const Context& context, const Document& document, const Used& used) {
  const Cursor root = document.root(context);
  const Counts counts = count(root);
  check_used(root.member("buffers"), used.buffers, [](const Cursor& buffer) { length_of(buffer); });
  check_used(root.member("bufferViews"), used.views,
             [&](const Cursor& view) { check_view(root, view, counts); });
  check_used(root.member("accessors"), used.accessors,
             [&](const Cursor& accessor) { check_accessor(root, accessor, counts); });
  check_used(root.member("meshes"), used.meshes, [&](const Cursor& mesh) {
    mesh.member("name").string("");
    check_each(mesh.member("primitives"),
               [&](const Cursor& primitive) { check_primitive(primitive, counts); });
  });
  check_used(root.member("nodes"), used.nodes, [&](const Cursor& node) { check_node(node, counts); });
  check_used(root.member("scenes"), used.scenes, [&](const Cursor& scene) {
    check_each(scene.member("nodes"), [&](const Cursor& node) { node.index("nodes", counts.nodes); });
  });
  check_used(root.member("images"), used.images, [&](const Cursor& image) {
    image.member("uri").string("");
    image.member("bufferView").optional_index("bufferViews", counts.views);
  });
  root.member("scene").optional_index("scenes", root.member("scenes").size());
}

}  // namespace caustics::gltf
