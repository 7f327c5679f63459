#if CAUSTICS_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include <algorithm>

#include "pipeline/scene/gltf/compressed.hpp"

namespace caustics::gltf {

namespace {

// Where a block of vertices does not change, the codec needs two bits for up to 256 bytes.
constexpr std::int64_t kMostUnpacked = 1024;

struct MeshoptView {
  std::string mode, filter;
  std::size_t count = 0, stride = 0;
  std::span<const std::uint8_t> bytes;
};

std::span<const std::uint8_t> compressed_bytes(const Cursor& packed, const Model& model) {
  const auto& buffer =
      model.buffers[static_cast<std::size_t>(packed.member("buffer").index("buffers", model.buffers.size()))];
  const auto room = static_cast<std::int64_t>(buffer.size());
  const std::int64_t offset = packed.member("byteOffset").integer(0, room, 0);
  const std::int64_t length = packed.member("byteLength").integer(1, room);
  if (length > room - offset) packed.fail("reaches beyond its buffer", kExportAgain);
  return {buffer.data() + offset, static_cast<std::size_t>(length)};
}

void check_mode(const Cursor& packed, const MeshoptView& view) {
  const bool vertices = view.mode == "ATTRIBUTES", triangles = view.mode == "TRIANGLES";
  if (!vertices && !triangles && view.mode != "INDICES")
    packed.member("mode").fail("is not one of the extension", kExportAgain);
  const bool fits = vertices ? view.stride % 4 == 0 : view.stride == 2 || view.stride == 4;
  if (!fits) packed.member("byteStride").fail("does not fit " + view.mode, kExportAgain);
  if (triangles && view.count % 3 != 0)
    packed.member("count").fail("is not of whole triangles", kExportAgain);
  const bool filtered = view.filter == "NONE" ||
                        (vertices && view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8)) ||
                        (vertices && view.filter == "QUATERNION" && view.stride == 8) ||
                        (vertices && view.filter == "EXPONENTIAL");
  if (!filtered) packed.member("filter").fail("does not fit mode and stride, or is unknown", kExportAgain);
}

MeshoptView checked_view(const Cursor& packed, const Model& model, const BufferView& unpacked) {
  MeshoptView view;
  view.bytes = compressed_bytes(packed, model);
  view.mode = packed.member("mode").string();
  view.filter = packed.member("filter").string("NONE");
  view.stride = static_cast<std::size_t>(packed.member("byteStride").integer(1, 256));
  const auto most = static_cast<std::int64_t>(unpacked.length / view.stride);
  view.count = static_cast<std::size_t>(packed.member("count").integer(1, most));
  check_mode(packed, view);
  if (view.count * view.stride != unpacked.length)
    packed.fail("unpacks to another length than its view's", kExportAgain);
  if (static_cast<std::int64_t>(unpacked.length) / kMostUnpacked >
      static_cast<std::int64_t>(view.bytes.size()))
    packed.fail("says that it unpacks to more than its bytes can hold", kExportAgain);
  return view;
}

bool decode_meshopt(const MeshoptView& view, Bytes& bytes) {
#if CAUSTICS_HAS_MESHOPT
  if (view.mode == "ATTRIBUTES")
    return meshopt_decodeVertexBuffer(bytes.data(), view.count, view.stride, view.bytes.data(),
                                      view.bytes.size()) == 0;
  if (view.mode == "TRIANGLES")
    return meshopt_decodeIndexBuffer(bytes.data(), view.count, view.stride, view.bytes.data(),
                                     view.bytes.size()) == 0;
  return meshopt_decodeIndexSequence(bytes.data(), view.count, view.stride, view.bytes.data(),
                                     view.bytes.size()) == 0;
#else
  (void)view;
  (void)bytes;
  return false;
#endif
}

Bytes unpacked_bytes(Context& context, const Cursor& packed, const MeshoptView& view) {
  context.spend_bytes(view.count * view.stride, packed.path());
  Bytes bytes(view.count * view.stride);
  if (!decode_meshopt(view, bytes)) packed.fail("the meshopt data are damaged", kExportAgain);
  if (view.filter == "OCTAHEDRAL") decode_octahedral(bytes, view.stride);
  if (view.filter == "QUATERNION") decode_quaternion(bytes);
  if (view.filter == "EXPONENTIAL") decode_exponential(bytes);
  return bytes;
}

}  // namespace

bool has_meshopt_decoder() {
#if CAUSTICS_HAS_MESHOPT
  return true;
#else
  return false;
#endif
}

bool is_meshopt_fallback(const Cursor& buffer) {
  return !buffer.member("uri").present() &&
         buffer.member("extensions").member(kMeshopt).member("fallback").boolean(false);
}

void unpack_views(Context& context, const Document& document, const Used& used, Model& model) {
  const Cursor views = document.root(context).member("bufferViews");
  for (std::size_t i = 0; i < model.views.size(); ++i) {
    if (!used.views[i]) continue;
    const Cursor packed = views.element(i).member("extensions").member(kMeshopt);
    const bool missing = model.buffers[model.views[i].buffer].empty();
    if (!packed.present()) {
      if (missing) views.element(i).fail("its buffer has no data, nor has it compressed ones", kExportAgain);
    } else if (has_meshopt_decoder()) {
      Bytes bytes = unpacked_bytes(context, packed, checked_view(packed, model, model.views[i]));
      model.buffers.push_back(std::move(bytes));
      model.views[i].buffer = model.buffers.size() - 1;
      model.views[i].offset = 0;
    } else if (missing) {
      fail_without_decoder(packed, kMeshopt);
    }
  }
}

}  // namespace caustics::gltf
