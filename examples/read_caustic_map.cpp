// Draws the first light's caustic map of a scene and reads it as floats: flux in each texel, relative to the
// light's own intensity.
#include <cstdio>

#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/renderer/frame_renderer.hpp"
#include "pipeline/renderer/stage.hpp"
#include "pipeline/scene/gltf/load_gltf.hpp"
#include "pipeline/settings/settings.hpp"
#include "raster/software_device.hpp"

int main(int count, char** arguments) try {
  if (count != 2) return std::fprintf(stderr, "usage: read_caustic_map SCENE\n"), 2;
  caustics::Scene scene = caustics::load_gltf(arguments[1]);
  const auto device = caustics::make_software_device();
  caustics::complete_scene(scene, {}, {*device, caustics::pass_registry()});
  caustics::FrameRenderer renderer(scene, caustics::Settings{}, caustics::pass_registry(), *device,
                                   {.goal = {{"caustic_map[0]"}}});
  renderer.run();
  const caustics::Image map = renderer.read("caustic_map[0]");
  double flux = 0.0;
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) flux += static_cast<double>(map.at(x, y, 0));
  std::printf("%dx%d texels, %.9g in all\n", map.width(), map.height(), flux);
} catch (const caustics::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return static_cast<int>(error.code());
}
