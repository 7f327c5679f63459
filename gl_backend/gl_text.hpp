// The GLSL that the driver is given for a stage of a shader. Needs no OpenGL.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/gpu/shader.hpp"

namespace caustics::gl {

// VertexOfQuads: of points that are drawn as quadrilaterals (point_quads.glsl).
enum class Stage : std::uint8_t { Vertex, VertexOfQuads, Fragment };

// pipeline/shader/prelude.glsl, embedded at build time.
extern const std::string_view kPrelude;
// point_quads.glsl, likewise.
extern const std::string_view kPointQuads;

// Version, stage, prelude and the shader's text, with every float operation marked precise
// (precise_text.hpp), and with a value for each of its choices, in their order, in place of `u.name`; without
// values the uniform block has them. Lines count from the first line of Shader::text.
std::string gl_text(const Shader& shader, Stage stage, std::span<const int> choices = {});

}  // namespace caustics::gl
