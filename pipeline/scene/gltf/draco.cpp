#if CAUSTICS_HAS_DRACO
#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#endif

#include <algorithm>
#include <cstring>

#include "pipeline/scene/gltf/compressed.hpp"

namespace caustics::gltf {

namespace {

#if CAUSTICS_HAS_DRACO

// About what the decoder takes for each triangle while it works.
constexpr std::uint64_t kBytesForTriangle = 64;
// A flat grid takes hundreds of triangles a byte, nothing more.
constexpr std::uint64_t kMostTrianglesInByte = 1024;

const char* kDamagedDraco = "the Draco data are damaged";

// How many triangles the head of the data announces; before anything is made for them.
std::uint64_t announced_triangles(const Cursor& packed, std::span<const std::uint8_t> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DracoHeader header{};
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok())
    packed.fail(std::string(kDamagedDraco) + ": no Draco header", kExportAgain);
  if (header.encoder_type != draco::TRIANGULAR_MESH)
    packed.fail("holds points; only triangles are drawn", kExportAgain);
  if (header.version_major != 2 || header.version_minor != 2)
    packed.fail("is of another Draco version than 2.2", kExportAgain);
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(2, 2));
  bool good = true;
  if (header.flags & METADATA_FLAG_MASK) {
    draco::GeometryMetadata ignored;
    good = draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &ignored);
  }
  std::uint32_t triangles = 0;
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
    std::uint8_t traversal = 0;
    std::uint32_t vertices = 0;
    good = good && buffer.Decode(&traversal) && draco::DecodeVarint(&vertices, &buffer);
  }
  if (!good || !draco::DecodeVarint(&triangles, &buffer))
    packed.fail(std::string(kDamagedDraco) + ": they end in their head", kExportAgain);
  return triangles;
}

std::unique_ptr<draco::Mesh> decode_draco(Context& context, const Cursor& packed,
                                          std::span<const std::uint8_t> bytes) {
  const std::uint64_t triangles = announced_triangles(packed, bytes);
  if (triangles > kMostTrianglesInByte * bytes.size() || triangles > context.options().max_triangles)
    packed.fail("announces " + std::to_string(triangles) + " triangles, more than can be", kExportAgain);
  context.spend_bytes(kBytesForTriangle * triangles, packed.path());
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok()) packed.fail(kDamagedDraco + (": " + mesh.status().error_msg_string()), kExportAgain);
  return std::move(mesh).value();
}

// The values of all points, side by side. False where the data name values that they lack.
template <typename T>
bool copy_values(const draco::Mesh& mesh, const draco::PointAttribute& attribute, Bytes& bytes) {
  const auto components = static_cast<std::size_t>(attribute.num_components());
  std::vector<T> values(mesh.num_points() * components);
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(i));
    if (value.value() >= attribute.size() || !attribute.ConvertValue<T>(value, &values[i * components]))
      return false;
  }
  bytes.resize(values.size() * sizeof(T));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return true;
}

bool copy_values(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int type, Bytes& bytes) {
  switch (type) {
    case kByte:
      return copy_values<std::int8_t>(mesh, attribute, bytes);
    case kUnsignedByte:
      return copy_values<std::uint8_t>(mesh, attribute, bytes);
    case kShort:
      return copy_values<std::int16_t>(mesh, attribute, bytes);
    case kUnsignedShort:
      return copy_values<std::uint16_t>(mesh, attribute, bytes);
    case kUnsignedInt:
      return copy_values<std::uint32_t>(mesh, attribute, bytes);
    default:
      return copy_values<float>(mesh, attribute, bytes);
  }
}

// The number of a new accessor of these bytes, tightly packed.
int add_accessor(Model& model, AccessorLayout layout, Bytes bytes) {
  model.views.push_back({model.buffers.size(), 0, bytes.size(), 0});
  model.buffers.push_back(std::move(bytes));
  layout.place = {static_cast<int>(model.views.size()) - 1, 0};
  layout.sparse = {};
  model.accessors.push_back(layout);
  return static_cast<int>(model.accessors.size()) - 1;
}

int unpack_attribute(Context& context, const Cursor& id, const draco::Mesh& mesh, int accessor,
                     Model& model) {
  AccessorLayout layout = model.accessors[static_cast<std::size_t>(accessor)];
  const draco::PointAttribute* attribute =
      mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id.integer(0, 0xFFFFFFFF)));
  if (!attribute || attribute->num_components() != layout.components)
    id.fail("is no such attribute of the Draco data", kExportAgain);
  layout.count = mesh.num_points();
  context.spend_bytes(
      layout.count * static_cast<std::size_t>(layout.components) * component_bytes(layout.component_type),
      id.path());
  Bytes bytes;
  if (!copy_values(mesh, *attribute, layout.component_type, bytes)) id.fail(kDamagedDraco, kExportAgain);
  return add_accessor(model, layout, std::move(bytes));
}

int unpack_triangles(const Cursor& packed, const draco::Mesh& mesh, Model& model) {
  Bytes bytes(std::size_t{mesh.num_faces()} * 3 * sizeof(std::uint32_t));
  std::uint8_t* out = bytes.data();
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i))) {
      if (corner.value() >= mesh.num_points()) packed.fail(kDamagedDraco, kExportAgain);
      const std::uint32_t value = corner.value();
      std::memcpy(out, &value, sizeof value);
      out += sizeof value;
    }
  }
  AccessorLayout layout;
  layout.count = mesh.num_faces() * std::size_t{3};
  layout.component_type = kUnsignedInt;
  return add_accessor(model, layout, std::move(bytes));
}

void unpack_draco(Context& context, const Cursor& packed, Primitive& primitive, Model& model) {
  if (primitive.mode != kTriangles && primitive.mode != kTriangleStrip)
    packed.fail("is on a primitive that is not of triangles", kExportAgain);
  const auto number =
      static_cast<std::size_t>(packed.member("bufferView").index("bufferViews", model.views.size()));
  const BufferView& view = model.views[number];
  const std::span<const std::uint8_t> bytes{model.buffers[view.buffer].data() + view.offset, view.length};
  const std::unique_ptr<draco::Mesh> mesh = decode_draco(context, packed, bytes);
  if (mesh->num_points() > context.options().max_vertices || mesh->num_faces() == 0)
    packed.fail("holds no triangles, or more vertices than can be", kExportAgain);
  const Cursor attributes = packed.member("attributes");
  for (const std::string& name : attributes.keys()) {
    const auto used = primitive.attributes.find(name);
    if (used == primitive.attributes.end()) continue;
    used->second = unpack_attribute(context, attributes.member(name), *mesh, used->second, model);
  }
  primitive.indices = unpack_triangles(packed, *mesh, model);
  primitive.mode = kTriangles;
}

#else

void unpack_draco(Context&, const Cursor& packed, Primitive&, Model&) {
  fail_without_decoder(packed, kDraco);
}

#endif

// Where the file has a plain copy beside the compressed data, that is read.
bool is_empty_shell(const Primitive& primitive, const Model& model) {
  const auto position = primitive.attributes.find("POSITION");
  return position != primitive.attributes.end() &&
         model.accessors[static_cast<std::size_t>(position->second)].place.view < 0;
}

}  // namespace

bool has_draco_decoder() {
#if CAUSTICS_HAS_DRACO
  return true;
#else
  return false;
#endif
}

void fail_without_decoder(const Cursor& where, std::string_view extension) {
  const std::string library = extension == kDraco ? "draco" : "meshoptimizer";
  where.fail(std::string(extension) + " needs the library " + library + ", which this build lacks",
             "install lib" + library +
                 "-dev and build again, or unpack the file: "
                 "gltf-transform copy in.glb out.glb");
}

void unpack_primitives(Context& context, const Document& document, Model& model) {
  const Cursor meshes = document.root(context).member("meshes");
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const Cursor primitives = meshes.element(i).member("primitives");
    for (std::size_t k = 0; k < model.meshes[i].primitives.size(); ++k) {
      const Cursor packed = primitives.element(k).member("extensions").member(kDraco);
      if (packed.present() && is_empty_shell(model.meshes[i].primitives[k], model))
        unpack_draco(context, packed, model.meshes[i].primitives[k], model);
    }
  }
}

}  // namespace caustics::gltf
