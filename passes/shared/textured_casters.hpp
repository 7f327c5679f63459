#pragma once
#include "passes/shared/material_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

// The uniform block of passes that draw casters with their textures into a view.
struct TexturedCasters {
#include "passes/shared/textured_casters_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// `surface`: what the material's colour means, what it lets through or what it mirrors. `of_light`: a light
// sees it, for which the texture of transmission counts; what a camera sees of it is a layer.
std140::TexturedCasters textured_casters_uniforms(const View& view, const Material& material,
                                                  const SurfaceRole& surface, int material_row,
                                                  int first_triangle = 0, bool of_light = true);
// Of the mesh that is drawn.
std140::TexturedCasters textured_casters(const PassContext& context);

}  // namespace caustics
