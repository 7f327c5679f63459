// Fixed-function state of a pass. An untouched field is OpenGL's default, so a definition shows only
// what differs. Section numbers are those of the OpenGL 4.5 core specification.
#pragma once
#include <array>
#include <cstdint>

namespace caustics {

// A rectangle is drawn by one run of the vertex stage, without a mesh, and covers the pixels whose centres it
// holds; those on its left and its lower edge too. Its varyings are flat.
enum class Topology : std::uint8_t { Triangles, Points, Rectangles };

// Pixels, of PassDefinition::zero_outside_quad.
inline constexpr float kQuadMargin = 1.0f / 64.0f;

// Depth test (17.3.4): an incoming fragment passes when `incoming compare stored`.
enum class Compare : std::uint8_t { Always, Less, LessEqual, Greater, GreaterEqual, Equal, Never };

// `Always` without writing is "no depth test". Window depth runs from 0 (near) to 1 (far).
struct DepthState {
  Compare compare = Compare::Always;
  bool write = false;
  bool operator==(const DepthState&) const = default;
};

// Face culling (14.6.1). Front faces wind counter-clockwise in y-up window coordinates.
enum class Cull : std::uint8_t { None, Back, Front };

enum class BlendEquation : std::uint8_t { Add, Min, Max };
enum class BlendFactor : std::uint8_t {
  Zero,
  One,
  SourceColor,
  SourceAlpha,
  OneMinusSourceAlpha,
  DestinationColor,
};

// Blending (17.3.6) of one colour attachment: equation(source * source_factor,
// destination * destination_factor); Min and Max ignore the factors.
struct BlendState {
  bool enabled = false;
  BlendEquation equation = BlendEquation::Add;
  BlendFactor source = BlendFactor::One;
  BlendFactor destination = BlendFactor::Zero;
  bool operator==(const BlendState&) const = default;
};

inline constexpr BlendState kReplace{};
inline constexpr BlendState kAccumulate{true, BlendEquation::Add, BlendFactor::One, BlendFactor::One};
inline constexpr BlendState kMultiply{true, BlendEquation::Add, BlendFactor::Zero, BlendFactor::SourceColor};

// Which channels a pass may write, in the order red, green, blue, alpha.
using ColorMask = std::array<bool, 4>;
inline constexpr ColorMask kAllChannels{true, true, true, true};
inline constexpr ColorMask kColorWithoutAlpha{true, true, true, false};

}  // namespace caustics
