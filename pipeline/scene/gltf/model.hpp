// The geometry's part of a checked document: numbers instead of text, with the defaults that glTF states, and
// the bytes behind them.
//
// Read by our own checks and not by tinygltf, which hands on too little for them: a member of the wrong type
// and one that is absent look the same in its model, indices beyond 32 bits are wrapped, empty objects
// ("water": {}) and nulls vanish, and a file is refused for what no scene of it uses.
#pragma once
#include <map>

#include "pipeline/scene/gltf/used.hpp"

namespace caustics::gltf {

// Source: glTF 2.0 section 5.1.3.
enum ComponentType : int {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126
};
// Source: glTF 2.0 section 5.24.4. Points and lines come before.
enum PrimitiveMode : int { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };

struct BufferView {
  std::size_t buffer = 0, offset = 0, length = 0;
  std::size_t stride = 0;  // 0: elements stand side by side
};

// Elements in a view, from an offset on.
struct ElementPlace {
  int view = -1;  // -1: none, all zeros
  std::size_t offset = 0;
};

struct SparseElements {
  std::size_t count = 0;  // 0: none
  int index_type = kUnsignedInt;
  ElementPlace indices, values;
};

struct AccessorLayout {
  ElementPlace place;
  std::size_t count = 0;
  int component_type = kFloat;
  int components = 1;
  bool normalized = false;
  SparseElements sparse;
};

struct Primitive {
  std::map<std::string, int> attributes;  // accessors by name
  int indices = -1, material = -1;        // -1: none
  int mode = kTriangles;
};

struct MeshSource {
  std::string name;
  std::vector<Primitive> primitives;
};

// What stands in the file, so empty where it says nothing.
struct NodeSource {
  std::vector<int> children;
  std::vector<double> matrix, translation, rotation, scale;
};

struct Model {
  std::vector<Bytes> buffers;
  std::vector<BufferView> views;
  std::vector<AccessorLayout> accessors;
  std::vector<MeshSource> meshes;
  std::vector<NodeSource> nodes;
  std::vector<std::vector<int>> scenes;  // their roots
};

std::size_t component_bytes(int component_type);
// Of an accessor's type, such as VEC3; 0: there is no such type.
int component_count(const std::string& type);

// check_structure must have passed. What is unused is there, and empty.
Model build_model(const Context& context, const Document& document, const Used& used,
                  std::vector<Bytes> buffers);

}  // namespace caustics::gltf
