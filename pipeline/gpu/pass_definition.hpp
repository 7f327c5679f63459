// What a pass reads, writes and draws with: a value that both devices execute and every tool prints.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/gpu/format.hpp"
#include "pipeline/gpu/shader.hpp"
#include "pipeline/gpu/state.hpp"

namespace caustics {

// A 2-D texture that the shader fetches texels from. The order is the texture unit of the shader's
// TEXTURE(unit, name) declarations.
struct TextureRead {
  std::string name;
  std::string meaning;
  // A per-draw texture of the drawn surface's material instead of a resource of the frame.
  bool of_material = false;
  // A resource that this frame may lack; the device then binds one texel of zeros.
  bool optional = false;
  // Where this texture of the targets' size is bound and holds zeros the shader discards its fragment. A
  // device may leave such fragments out.
  bool discards_where_zero = false;
  // The only attachment that depends on it; empty: all do. Where nobody wants that one, nothing is read.
  std::string only_towards{};
};

// A colour attachment. The order is the location of the shader's OUTPUT(location, type, name).
struct ColorWrite {
  std::string name;
  Format format = Format::RGBA32F;
  // What a texel means, with its unit and space.
  std::string meaning;
  std::array<float, 4> clear{0.0f, 0.0f, 0.0f, 0.0f};
  BlendState blend{};
  ColorMask mask = kAllChannels;
};

// The depth attachment, Depth32F.
struct DepthWrite {
  std::string name;
  std::string meaning;
  float clear = 1.0f;
};

struct PassDefinition {
  std::string name;
  std::string purpose;
  std::vector<TextureRead> reads{};
  std::vector<ColorWrite> writes{};
  std::optional<DepthWrite> depth{};
  Topology topology = Topology::Triangles;
  // Of rectangles that are added to what is there: the first of the eight varying components that are corners
  // a, b, c and d, in pixels. Farther than kQuadMargin from the triangles (a, b, c) and (d, c, b) the shader
  // gives zeros, so that a device may leave these fragments out.
  std::optional<int> zero_outside_quad{};
  DepthState depth_state{};
  Cull cull = Cull::None;
  // Count the samples that pass the depth test (an occlusion query, 4.2.1).
  bool count_samples = false;
  const Shader* shader = nullptr;
};

}  // namespace caustics
