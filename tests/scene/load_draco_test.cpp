// Geometry compressed with Draco: encoded here, by the library's own encoder.
#include <draco/compression/encode.h>

#include <algorithm>

#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr int kSide = 7;  // vertices of a square grid, 1 m apart, that rises to one side

glm::vec3 grid_point(int i) {
  const float x = static_cast<float>(i % kSide), z = static_cast<float>(i / kSide);
  return {x, 0.25f * x, z};
}

void fill_grid(draco::Mesh& mesh) {
  mesh.set_num_points(kSide * kSide);
  draco::GeometryAttribute position;
  position.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
  const int id = mesh.AddAttribute(position, true, kSide * kSide);
  for (int i = 0; i < kSide * kSide; ++i) {
    const glm::vec3 p = grid_point(i);
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(static_cast<std::uint32_t>(i)), &p.x);
  }
  const auto add = [&](int a, int b, int c) {
    draco::Mesh::Face face;
    const int corners[] = {a, b, c};
    for (std::size_t k = 0; k < 3; ++k) face[k] = draco::PointIndex(static_cast<std::uint32_t>(corners[k]));
    mesh.AddFace(face);
  };
  for (int i = 0; i + kSide < kSide * kSide; ++i) {
    if (i % kSide == kSide - 1) continue;
    add(i, i + kSide, i + 1);
    add(i + 1, i + kSide, i + kSide + 1);
  }
}

// Every vertex hangs on joint 1.
void add_influences(draco::Mesh& mesh) {
  draco::GeometryAttribute joints, weights;
  joints.Init(draco::GeometryAttribute::GENERIC, nullptr, 4, draco::DT_UINT8, false, 4, 0);
  weights.Init(draco::GeometryAttribute::GENERIC, nullptr, 4, draco::DT_FLOAT32, false, 16, 0);
  const std::uint8_t which[4] = {1, 0, 0, 0};
  const float how_much[4] = {1.0f, 0.0f, 0.0f, 0.0f};
  const int ids[2] = {mesh.AddAttribute(joints, true, kSide * kSide),
                      mesh.AddAttribute(weights, true, kSide * kSide)};
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    mesh.attribute(ids[0])->SetAttributeValue(draco::AttributeValueIndex(i), which);
    mesh.attribute(ids[1])->SetAttributeValue(draco::AttributeValueIndex(i), how_much);
  }
}

std::vector<std::uint8_t> encoded(int method, bool skinned = false) {
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  draco::EncoderBuffer buffer;
  draco::Mesh mesh;
  fill_grid(mesh);
  if (skinned) add_influences(mesh);
  REQUIRE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

// A file of these bytes. Its accessors are empty shells: of positions and indices.
Gltf holding(const std::vector<std::uint8_t>& bytes, const std::string& attributes = R"("POSITION":0)") {
  Gltf gltf;
  gltf.add(bytes, 5121, "SCALAR", bytes.size());
  gltf.accessors += R"(,{"componentType":5126,"type":"VEC3","count":49})"
                    R"(,{"componentType":5123,"type":"SCALAR","count":216})";
  gltf.mesh = R"("attributes":{"POSITION":1},"indices":2,"extensions":{"KHR_draco_mesh_compression":)"
              R"({"bufferView":0,"attributes":{)" +
              attributes + "}}}";
  gltf.rest = R"(,"extensionsRequired":["KHR_draco_mesh_compression"],)"
              R"("extensionsUsed":["KHR_draco_mesh_compression"])";
  return gltf;
}

const int kMethods[] = {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING};

}  // namespace

TEST_CASE("A mesh compressed with Draco has the vertices and triangles that went into it") {
  for (const int method : kMethods) {
    const Scene scene = load(holding(encoded(method)));
    REQUIRE(scene.meshes.size() == 1);
    const Mesh& mesh = scene.meshes[0];
    CHECK(mesh.indices.size() == 3 * 2 * (kSide - 1) * (kSide - 1));
    for (const Vertex& vertex : mesh.vertices) {
      const glm::vec3 at = world(scene, vertex);
      // Quantised to 14 bits of the longest side, 6 m: half a step is 1.8e-4 m.
      CHECK(std::abs(at.y - 0.25f * at.x) < 3e-4f);
      CHECK(std::abs(at.x - std::round(at.x)) < 2e-4f);
      CHECK(std::abs(at.z - std::round(at.z)) < 2e-4f);
    }
    // Each triangle is half a square of the slanted grid, and faces up.
    for (std::size_t t = 0; 3 * t < mesh.indices.size(); ++t) {
      CHECK(std::abs(facing(mesh, t).y - 1.0f) < 1e-3f);
      CHECK(std::abs(facing(mesh, t).x + 0.25f) < 1e-3f);
    }
  }
}

TEST_CASE("A skinned mesh compressed with Draco hangs on its joints") {
  // Bound at the origin; joint 1 stands 3 m higher.
  Gltf gltf =
      holding(encoded(draco::MESH_EDGEBREAKER_ENCODING, true), R"("POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2)");
  gltf.accessors += R"(,{"componentType":5121,"type":"VEC4","count":49})"
                    R"(,{"componentType":5126,"type":"VEC4","count":49})";
  gltf.mesh.replace(gltf.mesh.find("\"POSITION\":1"), 12, R"("POSITION":1,"JOINTS_0":3,"WEIGHTS_0":4)");
  gltf.node =
      R"("children":[1,2,3]},{"mesh":0,"skin":0},{"name":"foot"},{"name":"head","translation":[0,3,0])";
  gltf.rest += R"(,"skins":[{"joints":[2,3]}])";
  const Scene scene = load(gltf);
  REQUIRE(scene.meshes.size() == 1);
  for (const Vertex& vertex : scene.meshes[0].vertices) {
    const glm::vec3 at = world(scene, vertex);
    CHECK(std::abs(at.y - 0.25f * at.x - 3.0f) < 3e-4f);
  }
}

TEST_CASE("Draco data that are cut short or changed end in one line, and without harm") {
  for (const int method : kMethods) {
    const std::vector<std::uint8_t> whole = encoded(method);
    for (std::size_t length = 1; length < whole.size(); length += 16) {
      const std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
      CHECK(contains(refusal(holding(cut)), "KHR_draco_mesh_compression: "));
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
      for (const std::uint8_t bit : {0x01, 0x10, 0x80}) {
        std::vector<std::uint8_t> changed = whole;
        changed[at] ^= bit;
        CHECK_FALSE(refusal(holding(changed)).empty());  // that it ends in one line is checked there
      }
    }
  }
}

TEST_CASE("A head that announces more triangles than its bytes can hold is refused before they are made") {
  std::vector<std::uint8_t> bytes = encoded(draco::MESH_SEQUENTIAL_ENCODING);
  // After the 11 bytes of the header: the triangles, a number of 7 bits a byte.
  REQUIRE(bytes[11] == 72);
  bytes.erase(bytes.begin() + 11);
  const std::uint8_t many[] = {0xff, 0xff, 0xff, 0xff, 0x04};
  bytes.insert(bytes.begin() + 11, std::begin(many), std::end(many));
  CHECK(contains(refusal(holding(bytes)), "announces 1342177279 triangles, more than can be"));
}

TEST_CASE("Attributes that the Draco data lack are refused with their path") {
  CHECK(contains(refusal(holding(encoded(draco::MESH_EDGEBREAKER_ENCODING), R"("POSITION":7)")),
                 "KHR_draco_mesh_compression.attributes.POSITION: is no such attribute"));
}

TEST_CASE("A plain copy beside Draco data is read instead of them") {
  Gltf gltf = triangle();
  gltf.mesh = R"("attributes":{"POSITION":0},"extensions":{"KHR_draco_mesh_compression":)"
              R"({"bufferView":0,"attributes":{"POSITION":0}}})";
  CHECK(load(gltf).meshes.size() == 1);
}
