#include "pipeline/renderer/pilot_rays.hpp"

#include <set>

namespace caustics {

std::vector<LightRay> pilot_rays(const Light& light, const View& casters, int step) {
  constexpr int kPlaces = 16, kSide = kPilotRaysASide * kPlaces;  // places a side in a ray's square
  const int texels = casters.cube ? casters.cube->side : kSide;
  std::vector<LightRay> rays;
  for (int y = 0; y < kPilotRaysASide; y += step)
    for (int x = 0; x < kPilotRaysASide; x += step) {
      const int column = x * kPlaces + (5 * x + 7 * y) % kPlaces,
                row = y * kPlaces + (11 * x + 3 * y) % kPlaces;
      rays.push_back(light_ray(light, casters, texels, column * texels / kSide, row * texels / kSide));
      rays.back().key = static_cast<std::uint64_t>(y) * kPilotRaysASide + static_cast<std::uint64_t>(x) + 1;
    }
  return rays;
}

int pilot_step(std::size_t lights) {
  std::size_t step = 1;
  while (step < 8 && lights > 16 * step * step) step *= 2;
  return static_cast<int>(step);
}

std::vector<int> lights_to_pilot(const Scene& scene, const Effects& effects) {
  std::vector<int> lights;
  std::set<int> sources;
  std::vector<bool> throws(scene.lights.size());
  for (const Expectation& e : effects.expectations)
    if (e.expected) throws[static_cast<std::size_t>(e.light)] = true;
  for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
    const int source = scene.lights[static_cast<std::size_t>(i)].source;
    const bool drawn = effects.lights[static_cast<std::size_t>(i)].size_is_drawn;
    if (throws[static_cast<std::size_t>(i)] && (source < 0 || drawn || sources.insert(source).second))
      lights.push_back(i);
  }
  return lights;
}

}  // namespace caustics
