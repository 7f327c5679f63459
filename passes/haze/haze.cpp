#include "passes/haze/haze.hpp"

namespace caustics {

extern const Shader haze_shader;

Pass haze_pass() {
  return {
      .name = "haze",
      .purpose = "adds what the medium scatters to the picture",
      .reason = "the camera sees the scattered light",
      .when = {&Effects::scattering},
      .reads = {{.name = "haze", .meaning = "what it scatters, nit"}},
      .writes = {{.name = "beauty",
                  .meaning = "rgb: radiance towards the camera, nit; a: 1",
                  .blend = kAccumulate,
                  .mask = kColorWithoutAlpha}},
      .shaders = {{&haze_shader}},
  };
}

}  // namespace caustics
