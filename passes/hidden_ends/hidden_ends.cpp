#include "passes/hidden_ends/hidden_ends.hpp"

#include "passes/shared/sight_uniforms.hpp"

namespace caustics {

extern const Shader hidden_ends_shader;

namespace {

std140::HiddenEnds hidden_ends_uniforms(const PassContext& context) {
  std140::HiddenEnds block{};
  set_sight(block, context);
  if (context.sample > 0)
    block.drawn_from =
        static_cast<float>(context.sample - 1) / static_cast<float>(samples_a_pixel(*context.settings));
  return block;
}

int mirrors(const PassContext& context) {
  return context.drawn_for && context.drawn_for->camera == CameraView::Mirrored ? 1 : 0;
}

}  // namespace

Pass hidden_ends_pass() {
  return {
      .name = "hidden_ends",
      .purpose = "finds what glass and metal show that the picture does not",
      .reason = kBeyond,
      .when = {&Effects::seen_casters},
      .drawn_for = {kHiddenBehind, kHiddenMirrored},
      .reads = {{.name = "picture_position", .meaning = "what the picture shows", .texture = "view_position"},
                kReadSeenCasters,
                kReadSeenNormals,
                {.name = kCasterMaterials, .meaning = "indices, absorption, tint; receivers' colours"},
                kReadHierarchyNodes,
                kReadHierarchyTriangles,
                kReadHierarchyNormals,
                kReadCasterTexels},
      .writes = {{.name = "view_position",
                  .meaning = "xyz: where the camera's ray ends, metres, scene space; w: 1 where the "
                             "picture does not show that, else 0; 2: a blended surface on the way there"},
                 {.name = "view_normal",
                  .meaning = "xyz: the receiver's unit normal there, towards the ray, scene space; w: 0"},
                 {.name = "view_albedo",
                  .meaning = "rgb: its colour, linear; a: how much of it is shown, less than 1 where an "
                             "added ground fades"},
                 {.name = "view_emission",
                  .meaning = "rgb: emitted radiance, nit",
                  .needed_if = with<&Effects::emission>}},
      .count_samples = true,
      .shaders = {{&hidden_ends_shader, block_of<hidden_ends_uniforms>}},
      .choices = {{"mirrors", mirrors}, kSightHasTextures, kSightHasRough, kHasWalls, kSightHasSheets},
  };
}

}  // namespace caustics
