// What a device executes: meshes, draw calls, and one execution of a pass with its result.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/gpu/pass_definition.hpp"

namespace caustics {

enum class TextureId : std::uint32_t { None = 0 };
enum class MeshId : std::uint32_t { None = 0 };

// Triangles or points with interleaved float attributes, matched to a shader's ATTRIBUTEs by name.
struct MeshData {
  struct Attribute {
    std::string name;
    int components = 0;
  };
  std::vector<Attribute> layout;
  std::vector<float> vertices;              // vertex after vertex, attributes in layout order
  std::vector<std::uint32_t> indices = {};  // empty: the vertices in order
  int floats_per_vertex() const;
  std::size_t vertex_count() const;
};

// One draw call. Without a mesh, `vertex_count` vertices are drawn that know only their vertex_id.
struct Draw {
  MeshId mesh = MeshId::None;
  int vertex_count = 0;
  // The shader's uniform block, laid out as std140 (pipeline/shader/std140.hpp).
  std::vector<std::byte> uniforms{};
  // One for each of the definition's reads, in that order. None is bound as one texel of zeros.
  std::vector<TextureId> textures{};
};

// An occlusion query, numbered by the caller: it holds the samples that passed the depth test in the last run
// that counted into it.
enum class OcclusionQuery : std::uint32_t { None = 0 };

// One execution of a pass: its targets, all of one size, and its draws in API order.
struct PassRun {
  const PassDefinition* definition = nullptr;
  // One for each of the definition's writes. What is written to None goes nowhere.
  std::vector<TextureId> colors{};
  TextureId depth = TextureId::None;
  // Attachments whose contents are kept instead of cleared, by index; the depth attachment last.
  std::vector<bool> keep{};
  std::vector<Draw> draws{};
  OcclusionQuery counts_into = OcclusionQuery::None;  // of a definition that counts samples
  // Where that query holds 0 samples, nothing is drawn: the targets are cleared all the same. OpenGL decides
  // it by conditional rendering, so that nothing is read back.
  OcclusionQuery only_if = OcclusionQuery::None;
};

struct PassResult {
  std::uint64_t vertices = 0;        // vertices submitted; an index counts as one
  std::uint64_t primitives = 0;      // triangles or points assembled
  std::uint64_t fragments = 0;       // fragments shaded (0 where a device cannot tell)
  std::uint64_t samples_passed = 0;  // when the definition counts samples
  std::uint64_t operations = 0;      // of its shaders on floats (kernel.hpp), 0 but for the scalar lanes
  // Its draws were, by its occlusion query (PassRun::only_if). False too where a device was not asked to
  // measure and cannot tell.
  bool left_out = false;
  double milliseconds = 0.0;
  double processor_milliseconds = 0.0;  // of all the process's threads meanwhile, a driver's too
};

}  // namespace caustics
