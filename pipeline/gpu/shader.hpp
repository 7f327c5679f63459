// A pass's program: one text in the common subset of GLSL 4.50 and C++, and the kernels that C++
// compilers made of it for each lane width. pipeline/shader has the subset and the kernels' types.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace caustics {

struct VertexBlock;
struct FragmentBlock;
using VertexKernel = void (*)(const VertexBlock&);
using FragmentKernel = void (*)(const FragmentBlock&);

// How many vertices or fragments one instruction works on, and with which instructions.
enum class Lanes : std::uint8_t { Scalar, Plain4, Sse41x4, Avx2x8, Avx512x16 };
inline constexpr int kLanesCount = 5;
std::string_view lanes_name(Lanes lanes);

// Kernels by Lanes; a null pointer where this build or architecture has none.
struct ShaderKernels {
  std::array<VertexKernel, kLanesCount> vertex{};
  std::array<FragmentKernel, kLanesCount> fragment{};
};

// A whole number of the uniform block that is the same for a whole draw (a CHOICE line), and where it lies.
// OpenGL compiles it into the program.
struct ShaderChoice {
  std::string_view name;
  std::size_t offset = 0;
};

struct Shader {
  std::string_view name;
  // The whole text, includes expanded, without the GLSL prelude.
  std::string_view text;
  ShaderKernels kernels;
  // Of the uniform block, a multiple of 16, and those of its choices that the text asks; null where nobody
  // knows (shaders that are not compiled here).
  std::size_t (*uniform_bytes)() = nullptr;
  std::span<const ShaderChoice> (*choices)() = nullptr;
};

std::span<const ShaderChoice> choices_of(const Shader& shader);

enum class Interpolation : std::uint8_t { Smooth, Flat };

// One declaration of a shader text. `first_component` counts floats from the block's start.
struct ShaderVariable {
  std::string name;
  int first_component = 0;
  int components = 0;
  Interpolation interpolation = Interpolation::Smooth;
};

// What a shader text declares, read from the text itself, so that it stands in one place only.
struct ShaderInterface {
  std::vector<ShaderVariable> attributes;
  std::vector<ShaderVariable> varyings;
  std::vector<std::string> textures;  // by unit
  std::vector<std::string> outputs;   // by location
  bool discards = false;              // fragments may be discarded
  int attribute_components() const;
  int varying_components() const;
};

// Reads the ATTRIBUTE, VARYING_SMOOTH, VARYING_FLAT, TEXTURE and OUTPUT lines of a text. Throws Error
// (InternalError) when components overlap or leave gaps, or units or locations are not 0, 1, 2, ...
ShaderInterface reflect(std::string_view text);

// The same of a shader, read from its text once in the life of the process.
const ShaderInterface& interface_of(const Shader& shader);

}  // namespace caustics
