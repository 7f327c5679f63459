// Any bytes as a .gltf or .glb: refused in one line, or a sound scene at two moments, completed or not.
#include "pipeline/renderer/stage.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/fuzz/fuzzed_scene.hpp"
#include "tests/support/pilot.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace caustics;
  using namespace caustics::fuzz;
  const auto animated = load_bytes({data, size}, small_limits());
  if (!animated) return 0;
  check_sound(animated->start());
  if (const auto later = scene_at(*animated, 0.37 * animated->duration())) check_sound(*later);
  Scene scene = animated->start();
  try {
    complete_scene(scene, Settings{}, test::pilot());
    check_sound(scene);
  } catch (const Error& error) {
    // Water that is no refractor, for example.
    check_refusal(error);
  }
  return 0;
}
