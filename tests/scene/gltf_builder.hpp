// Builds small glTF files for the loader's tests: binary data with its views and accessors, JSON
// text around it, a folder of its own that is removed afterwards.
#pragma once
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/gltf/load_gltf.hpp"
#include "tests/support/catch.hpp"

namespace caustics::test {

class Folder {
 public:
  Folder() {
    static int number = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("caustics_gltf_" + std::to_string(::getpid()) + "_" + std::to_string(number++));
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

template <typename T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

inline std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

// A file in the making. Every accessor gets a view of its own; members of the JSON can be set as
// text.
struct Gltf {
  std::string data;
  std::string views, accessors;
  int count = 0;
  std::string mesh;                  // the first primitive's members, e.g. "attributes":{...}
  std::string node = R"("mesh":0)";  // members of nodes[0]
  std::string rest;                  // further top-level members, beginning with a comma
  std::string uri;                   // of the buffer; empty: a data URI

  template <typename T>
  int add(const std::vector<T>& values, int component_type, const std::string& type, std::size_t elements,
          const std::string& more = "") {
    while (data.size() % 4 != 0) data += '\0';
    const std::string comma = count > 0 ? "," : "";
    const std::string bytes = bytes_of(values);
    views += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(data.size()) + R"(,"byteLength":)" +
             std::to_string(bytes.size()) + "}";
    accessors += comma + R"({"bufferView":)" + std::to_string(count) + R"(,"componentType":)" +
                 std::to_string(component_type) + R"(,"type":")" + type + R"(","count":)" +
                 std::to_string(elements) + more + "}";
    data += bytes;
    return count++;
  }

  std::string json() const {
    const std::string source = uri.empty() ? "data:application/octet-stream;base64," + base64(data) : uri;
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{)" + node +
           R"(}],"meshes":[{"primitives":[{)" + mesh + R"(}]}],"buffers":[{"byteLength":)" +
           std::to_string(data.size()) + R"(,"uri":")" + source + R"("}],"bufferViews":[)" + views +
           R"(],"accessors":[)" + accessors + "]" + rest + "}";
  }
};

// A right triangle in the plane z = 0 that faces +z.
inline Gltf triangle() {
  Gltf gltf;
  gltf.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, 5126, "VEC3", 3);
  gltf.mesh = R"("attributes":{"POSITION":0})";
  return gltf;
}

inline std::string glb(std::string json, std::string bin) {
  while (json.size() % 4 != 0) json += ' ';
  while (bin.size() % 4 != 0) bin += '\0';
  const auto word = [](std::size_t value) {
    return bytes_of(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)});
  };
  return "glTF" + word(2) + word(28 + json.size() + bin.size()) + word(json.size()) + "JSON" + json +
         word(bin.size()) + std::string("BIN\0", 4) + bin;
}

inline Scene load_text(const std::string& text, const LoadOptions& options = {}) {
  const Folder folder;
  return load_gltf(folder.write("scene.gltf", text), options);
}
inline Scene load(const Gltf& gltf) { return load_text(gltf.json()); }

// The message of the error that loading must give; it must be one line, about bad input, with the
// file.
inline std::string refusal(const std::string& text, const LoadOptions& options = {}) {
  try {
    load_text(text, options);
  } catch (const Error& error) {
    const std::string message = error.what();
    CHECK(error.code() == ExitCode::BadInput);
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find("scene.gltf: ") != std::string::npos);
    return message;
  }
  return "no error";
}
inline std::string refusal(const Gltf& gltf) { return refusal(gltf.json()); }

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
inline bool has_note(const Scene& scene, const std::string& part) {
  for (const std::string& note : scene.notes) {
    if (contains(note, part)) return true;
  }
  return false;
}

inline glm::vec3 world(const Scene& scene, const Vertex& vertex) {
  return glm::vec3(glm::dvec3(vertex.position) + scene.origin);
}
// The unnormalised geometric normal of triangle t.
inline glm::vec3 facing(const Mesh& mesh, std::size_t t) {
  const glm::vec3 a = mesh.vertices[mesh.indices[3 * t]].position;
  const glm::vec3 b = mesh.vertices[mesh.indices[3 * t + 1]].position;
  const glm::vec3 c = mesh.vertices[mesh.indices[3 * t + 2]].position;
  return glm::cross(b - a, c - a);
}

// A level square of 2 x 2 m that faces up, its node "pool" with these extras.
inline Gltf level_square(const std::string& extras, const std::string& more = "") {
  Gltf gltf;
  gltf.add<float>({-1, 0, 1, 1, 0, 1, 1, 0, -1, -1, 0, -1}, 5126, "VEC3", 4);
  gltf.add<std::uint16_t>({0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 6);
  gltf.mesh = R"("attributes":{"POSITION":0},"indices":1)";
  gltf.node = R"("mesh":0,"name":"pool","extras":{)" + extras + "}" + more;
  return gltf;
}

}  // namespace caustics::test
