#include "passes/ambient_occlusion/ambient_occlusion.hpp"

#include "passes/ambient_rays/ambient_rays.hpp"

namespace caustics {

extern const Shader ambient_occlusion_shader;

Pass ambient_occlusion_pass() {
  return {
      .name = "ambient_occlusion",
      .purpose = "the mean of ambient_rays over neighbours on the same surface",
      .reason = "surfaces keep the environment's light from others near by",
      .when = {&Effects::ambient_occlusion},
      .coarser = kAmbientPixels,
      .reads = {{.name = "ambient_rays", .meaning = "the points, and how open the sky is there"},
                {.name = "view_normal", .meaning = "the surfaces' normals"}},
      .writes = {{.name = "ambient_occlusion",
                  .meaning = "xyz: the point, metres, scene space; w: 1 and the share of the environment's "
                             "light that arrives, 0 where there is no surface"}},
      .shaders = {{&ambient_occlusion_shader}},
  };
}

}  // namespace caustics
