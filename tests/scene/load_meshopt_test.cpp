// Geometry compressed with meshopt: encoded here, by the library's own encoder.
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

#include "pipeline/scene/gltf/compressed.hpp"
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const std::vector<float> kSquare = {0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 0, 0};
const std::vector<std::uint32_t> kTwoTriangles = {0, 1, 2, 0, 2, 3};

std::vector<std::uint8_t> packed_vertices(const void* data, std::size_t count, std::size_t stride) {
  std::vector<std::uint8_t> bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), data, count, stride));
  return bytes;
}

std::vector<std::uint8_t> packed_triangles() {
  std::vector<std::uint8_t> bytes(meshopt_encodeIndexBufferBound(6, 4));
  bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), kTwoTriangles.data(), 6));
  return bytes;
}

std::vector<std::uint8_t> packed_sequence() {
  std::vector<std::uint8_t> bytes(meshopt_encodeIndexSequenceBound(6, 4));
  bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), kTwoTriangles.data(), 6));
  return bytes;
}

// Two triangles whose positions and indices are views of a buffer that is not there.
struct PackedSquare {
  std::vector<std::uint8_t> vertices = packed_vertices(kSquare.data(), 4, 12), indices = packed_triangles();
  std::string of_vertices = R"("byteStride":12,"count":4,"mode":"ATTRIBUTES")";
  std::string of_indices = R"("byteStride":4,"count":6,"mode":"TRIANGLES")";

  static std::string view(int offset, int length, std::size_t at, std::size_t bytes,
                          const std::string& more) {
    return R"({"buffer":1,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
           std::to_string(length) + R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)" +
           std::to_string(at) + R"(,"byteLength":)" + std::to_string(bytes) + "," + more + "}}}";
  }

  std::string json() const {
    Gltf gltf;
    gltf.data.assign(vertices.begin(), vertices.end());
    gltf.data.append(indices.begin(), indices.end());
    gltf.views = view(0, 48, 0, vertices.size(), of_vertices) + "," +
                 view(48, 24, vertices.size(), indices.size(), of_indices);
    gltf.accessors = R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4},)"
                     R"({"bufferView":1,"componentType":5125,"type":"SCALAR","count":6})";
    gltf.mesh = R"("attributes":{"POSITION":0},"indices":1)";
    gltf.rest = R"(,"extensionsRequired":["EXT_meshopt_compression"],)"
                R"("extensionsUsed":["EXT_meshopt_compression"])";
    std::string text = gltf.json();
    const std::string fallback =
        R"(},{"byteLength":72,"extensions":{"EXT_meshopt_compression":{"fallback":true}}}],"bufferViews")";
    const std::string plain = R"(}],"bufferViews")";
    return text.replace(text.find(plain), plain.size(), fallback);
  }
};

template <typename T>
gltf::Bytes filtered(const std::vector<T>& values) {
  gltf::Bytes bytes(values.size() * sizeof(T));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

template <typename T>
T value_at(const gltf::Bytes& bytes, std::size_t i) {
  T value;
  std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof value);
  return value;
}

// The largest difference between what these filters and the library's make of the same elements.
template <typename T>
int difference(const gltf::Bytes& ours, const gltf::Bytes& theirs) {
  int most = 0;
  for (std::size_t i = 0; i * sizeof(T) < ours.size(); ++i)
    most = std::max(most, std::abs(int{value_at<T>(ours, i)} - int{value_at<T>(theirs, i)}));
  return most;
}

}  // namespace

TEST_CASE("A mesh compressed with meshopt has the vertices and triangles that went into it") {
  PackedSquare square;
  for (const bool sequence : {false, true}) {
    if (sequence) {
      square.indices = packed_sequence();
      square.of_indices = R"("byteStride":4,"count":6,"mode":"INDICES")";
    }
    const Scene scene = load_text(square.json());
    REQUIRE(scene.meshes.size() == 1);
    REQUIRE(scene.meshes[0].indices.size() == 6);
    glm::vec3 both(0);
    for (std::size_t t = 0; t < 2; ++t) both += facing(scene.meshes[0], t);
    CHECK(both == glm::vec3(0, 2, 0));  // twice the square's area, upwards
  }
}

TEST_CASE("meshopt data that are cut short or changed end in one line, and without harm") {
  const PackedSquare whole;
  for (const bool vertices : {true, false}) {
    const std::size_t size = (vertices ? whole.vertices : whole.indices).size();
    for (std::size_t length = 1; length < size; length += vertices ? 16 : 4) {
      PackedSquare cut;
      (vertices ? cut.vertices : cut.indices).resize(length);
      CHECK(contains(refusal(cut.json()), "EXT_meshopt_compression: the meshopt data are damaged"));
    }
    for (std::size_t at = 0; at < size; ++at) {
      for (const std::uint8_t bit : {0x01, 0x10, 0x80}) {
        PackedSquare changed;
        (vertices ? changed.vertices : changed.indices)[at] ^= bit;
        CHECK_FALSE(refusal(changed.json()).empty());  // that it ends in one line is checked there
      }
    }
  }
}

TEST_CASE("Sizes that do not fit are refused before anything is unpacked") {
  const auto with = [](const std::string& of_vertices) {
    PackedSquare square;
    square.of_vertices = of_vertices;
    return refusal(square.json());
  };
  CHECK(contains(with(R"("byteStride":12,"count":5,"mode":"ATTRIBUTES")"), "count: must be"));
  CHECK(contains(with(R"("byteStride":12,"count":3,"mode":"ATTRIBUTES")"), "another length than its view's"));
  CHECK(contains(with(R"("byteStride":6,"count":8,"mode":"ATTRIBUTES")"), "byteStride: does not fit"));
  CHECK(contains(with(R"("byteStride":12,"count":4,"mode":"TRIANGLES")"), "byteStride: does not fit"));
  CHECK(contains(with(R"("byteStride":12,"count":4,"mode":"PIXELS")"), "mode: is not one"));
  CHECK(contains(with(R"("byteStride":12,"count":4,"mode":"ATTRIBUTES","filter":"OCTAHEDRAL")"),
                 "filter: does not fit"));
}

TEST_CASE("A view of a buffer that is not there is refused unless it has compressed data") {
  std::string json = PackedSquare().json();
  const std::string name = "\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0";
  json.replace(json.find(name), name.size(), "\"extras\":{\"EXT_meshopt_compression\":{\"buffer\":0");
  CHECK(contains(refusal(json), "bufferViews[0]: its buffer has no data"));
}

TEST_CASE("The octahedral filter gives unit vectors, and what the library's gives but for rounding") {
  // Along x; along -z, where the lower half is folded over; (1, 1, 1) / root of 3: 73.3 of 127.
  gltf::Bytes bytes = filtered<std::int8_t>({127, 0, 127, 1, 127, 127, 127, 2, 42, 42, 126, 3});
  gltf::decode_octahedral(bytes, 4);
  CHECK(bytes == filtered<std::int8_t>({127, 0, 0, 1, 0, 0, -127, 2, 73, 73, 73, 3}));
  std::vector<float> vectors;
  for (int i = 0; i < 200; ++i) {
    const float z = 1.0f - static_cast<float>(i) / 100.0f, turn = 2.4f * static_cast<float>(i);
    const float ring = std::sqrt(std::max(1.0f - z * z, 0.0f));
    vectors.insert(vectors.end(), {ring * std::cos(turn), ring * std::sin(turn), z, 0.0f});
  }
  gltf::Bytes ours(200 * 8);
  meshopt_encodeFilterOct(ours.data(), 200, 8, 12, vectors.data());
  gltf::Bytes theirs = ours;
  gltf::decode_octahedral(ours, 8);
  meshopt_decodeFilterOct(theirs.data(), 200, 8);
  CHECK(difference<std::int16_t>(ours, theirs) <= 1);
}

TEST_CASE("The quaternion filter puts back the largest component, as the library's does but for rounding") {
  std::vector<float> turns;
  for (int i = 0; i < 100; ++i) {
    const float a = 0.1f * static_cast<float>(i), b = 0.37f * static_cast<float>(i);
    turns.insert(turns.end(), {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b),
                               std::cos(a) * std::cos(b), std::cos(a) * std::sin(b)});
  }
  gltf::Bytes ours(100 * 8);
  meshopt_encodeFilterQuat(ours.data(), 100, 8, 12, turns.data());
  gltf::Bytes theirs = ours;
  gltf::decode_quaternion(ours);
  meshopt_decodeFilterQuat(theirs.data(), 100, 8);
  CHECK(difference<std::int16_t>(ours, theirs) <= 1);
  for (std::size_t i = 0; i < 100; ++i) {
    double square = 0;
    for (std::size_t k = 0; k < 4; ++k)
      square += std::pow(value_at<std::int16_t>(ours, 4 * i + k) / 32767.0, 2);
    CHECK(std::abs(square - 1) < 1e-3);
  }
}

TEST_CASE("The exponential filter gives an integer times a power of two") {
  // 3 * 2^-1, -5 * 2^2, 0, 2^23 - 1 times 2^-100.
  gltf::Bytes bytes = filtered<std::uint32_t>({0xff000003u, 0x02fffffbu, 0x05000000u, 0x9c7fffffu});
  gltf::decode_exponential(bytes);
  CHECK(value_at<float>(bytes, 0) == 1.5f);
  CHECK(value_at<float>(bytes, 1) == -20.0f);
  CHECK(value_at<float>(bytes, 2) == 0.0f);
  CHECK(value_at<float>(bytes, 3) == std::ldexp(8388607.0f, -100));
}
