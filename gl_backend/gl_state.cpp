#include "gl_backend/gl_state.hpp"

namespace caustics::gl {

namespace {

void set_enabled(GLenum what, bool on) {
  if (on)
    glEnable(what);
  else
    glDisable(what);
}

void set_depth(const DepthState& state) {
  // A disabled test does not write either, so "always" with writing needs the test.
  set_enabled(GL_DEPTH_TEST, state.compare != Compare::Always || state.write);
  glDepthFunc(gl_compare(state.compare));
  glDepthMask(state.write ? GL_TRUE : GL_FALSE);
}

void set_color(GLuint attachment, const ColorWrite& write) {
  const auto channel = [&](std::size_t c) -> GLboolean { return write.mask[c] ? GL_TRUE : GL_FALSE; };
  glColorMaski(attachment, channel(0), channel(1), channel(2), channel(3));
  if (!write.blend.enabled) {
    glDisablei(GL_BLEND, attachment);
    return;
  }
  glEnablei(GL_BLEND, attachment);
  glBlendEquationi(attachment, gl_equation(write.blend.equation));
  glBlendFunci(attachment, gl_factor(write.blend.source), gl_factor(write.blend.destination));
}

}  // namespace

TexelLayout texel_layout(Format format) {
  switch (format) {
    case Format::R32F:
      return {GL_R32F, GL_RED, GL_FLOAT};
    case Format::RG32F:
      return {GL_RG32F, GL_RG, GL_FLOAT};
    case Format::RGBA32F:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case Format::RGBA16F:
      return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    case Format::RGBA8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case Format::Depth32F:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  }
  return {};
}

GLenum gl_topology(Topology topology) { return topology == Topology::Points ? GL_POINTS : GL_TRIANGLES; }

GLenum gl_compare(Compare compare) {
  switch (compare) {
    case Compare::Always:
      return GL_ALWAYS;
    case Compare::Less:
      return GL_LESS;
    case Compare::LessEqual:
      return GL_LEQUAL;
    case Compare::Greater:
      return GL_GREATER;
    case Compare::GreaterEqual:
      return GL_GEQUAL;
    case Compare::Equal:
      return GL_EQUAL;
    case Compare::Never:
      return GL_NEVER;
  }
  return GL_ALWAYS;
}

GLenum gl_equation(BlendEquation equation) {
  switch (equation) {
    case BlendEquation::Add:
      return GL_FUNC_ADD;
    case BlendEquation::Min:
      return GL_MIN;
    case BlendEquation::Max:
      return GL_MAX;
  }
  return GL_FUNC_ADD;
}

GLenum gl_factor(BlendFactor factor) {
  switch (factor) {
    case BlendFactor::Zero:
      return GL_ZERO;
    case BlendFactor::One:
      return GL_ONE;
    case BlendFactor::SourceColor:
      return GL_SRC_COLOR;
    case BlendFactor::SourceAlpha:
      return GL_SRC_ALPHA;
    case BlendFactor::OneMinusSourceAlpha:
      return GL_ONE_MINUS_SRC_ALPHA;
    case BlendFactor::DestinationColor:
      return GL_DST_COLOR;
  }
  return GL_ONE;
}

void set_common_state() {
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_PROGRAM_POINT_SIZE);
  for (const GLenum off : {GL_DITHER, GL_FRAMEBUFFER_SRGB, GL_MULTISAMPLE, GL_SCISSOR_TEST, GL_STENCIL_TEST,
                           GL_PRIMITIVE_RESTART})
    glDisable(off);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void open_masks() {
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
}

void set_pass_state(const PassDefinition& definition) {
  set_depth(definition.depth_state);
  set_enabled(GL_CULL_FACE, definition.cull != Cull::None);
  glCullFace(definition.cull == Cull::Front ? GL_FRONT : GL_BACK);
  for (std::size_t i = 0; i < definition.writes.size(); ++i)
    set_color(static_cast<GLuint>(i), definition.writes[i]);
}

}  // namespace caustics::gl
