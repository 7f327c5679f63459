// A scene file and, behind it, eight bytes that choose settings: a whole tiny frame whose values are finite
// and whose light is accounted for. A .glb of its corpus is also a file for the program, which ignores what
// follows its end.
#include "tests/fuzz/fuzzed_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace caustics;
  using namespace caustics::fuzz;
  if (size <= kSettingsBytes) return 0;
  const ByteSpan bytes(data, size);
  const FrameChoice choice = choice_of(bytes.last(kSettingsBytes));
  LoadOptions limits = small_limits();
  limits.max_nodes = 40;
  limits.max_lights = 4;
  limits.max_vertices = limits.max_triangles = 2000;
  const auto animated = load_bytes(bytes.first(size - kSettingsBytes), limits);
  if (!animated) return 0;
  const double seconds = choice.moment * animated->duration();
  if (auto scene = scene_at(*animated, seconds)) render_frame(std::move(*scene), choice.settings, seconds);
  return 0;
}
