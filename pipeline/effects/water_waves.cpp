#include "pipeline/effects/water_waves.hpp"

#include "pipeline/effects/surface_role.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics {

namespace {

std::string water_text(const Water& water, std::size_t index) {
  const WaterSettings& s = water.settings;
  return quoted_name("water", water.name, index) + " has waves of " + rounded_text(s.speed) + " m/s on " +
         std::to_string(water.columns) + "x" + std::to_string(water.rows) + " cells, a plop every " +
         rounded_text(s.interval) + " s; pass water_step";
}

}  // namespace

void add_water_waves(const Scene& scene, Effects& effects) {
  std::string reason;
  for (std::size_t i = 0; i < scene.waters.size(); ++i) {
    const Water& water = scene.waters[i];
    const SurfaceRole& role = effects.surfaces[static_cast<std::size_t>(water.mesh)];
    if (role.role != Role::Refractor) {
      throw Error(ExitCode::BadInput, scene.file + ": " + quoted_name("water", water.name, i) +
                                          " is no refractor (" + role.reason +
                                          "); give it a smooth material with transmission and a volume");
    }
    reason += (i == 0 ? "" : "; ") + water_text(water, i);
  }
  effects.water_waves = {!scene.waters.empty(),
                         scene.waters.empty() ? "no mesh is water that moves" : reason};
}

}  // namespace caustics
