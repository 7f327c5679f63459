// What the contract's enumerations are called in OpenGL, and setting a pass's fixed-function state.
#pragma once
#include <epoxy/gl.h>

#include "pipeline/gpu/pass_definition.hpp"

namespace caustics::gl {

// How texels are stored on the device and moved to and from memory.
struct TexelLayout {
  GLenum internal_format = 0;
  GLenum channels = 0;
  GLenum type = 0;
};
TexelLayout texel_layout(Format format);

GLenum gl_topology(Topology topology);
GLenum gl_compare(Compare compare);
GLenum gl_equation(BlendEquation equation);
GLenum gl_factor(BlendFactor factor);

// State that all passes share: depth from 0 to 1, point sizes from the shader, no sRGB, dither or
// multisampling, tight rows in memory. Once for each context.
void set_common_state();
// Masks and depth of a pass are opened wide, so that clears reach everything.
void open_masks();
// Depth, culling, blending and masks of a pass.
void set_pass_state(const PassDefinition& definition);

}  // namespace caustics::gl
