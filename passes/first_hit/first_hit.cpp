#include "passes/first_hit/first_hit.hpp"

namespace caustics::std140 {

struct FirstHit {
#include "passes/first_hit/first_hit_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader first_hit_shader;

Pass first_hit_pass() {
  return {
      .name = "first_hit",
      .purpose = "gathers the layers of the first surface in each pixel, glass included",
      .reason = "layers of the picture are wanted",
      .reads = {{.name = "view_position", .meaning = "opaque surfaces"},
                {.name = "view_normal", .meaning = "their normals and depth"},
                {.name = "direct",
                 .meaning = "direct irradiance, lux",
                 .optional = true,
                 .only_towards = "aov_direct"},
                {.name = "caustic",
                 .meaning = "caustic irradiance, lux",
                 .optional = true,
                 .only_towards = "aov_caustic"},
                {.name = "view_caster_position",
                 .meaning = "glass",
                 .texture_by = casters_beyond_panes,
                 .optional = true},
                {.name = "view_caster_normal",
                 .meaning = "its normals",
                 .texture_by = normals_beyond_panes,
                 .optional = true}},
      .writes = {{.name = "aov_direct", .meaning = "rgb: direct irradiance after shadows, lux; 0 on casters"},
                 {.name = "aov_caustic", .meaning = "rgb: irradiance from caustics, lux; 0 on casters"},
                 {.name = "aov_position",
                  .meaning = "xyz: position, metres, scene space; w: coverage, 0 or 1"},
                 {.name = "aov_normal",
                  .meaning = "xyz: unit normal, scene space; w: depth along the camera's axis, metres"}},
      .shaders =
          {{&first_hit_shader,
            block_of<[](const PassContext& c) { return std140::FirstHit{.view = shader_view(*c.camera)}; }>}},
  };
}

}  // namespace caustics
