#include "pipeline/views/all_around.hpp"

#include "pipeline/scene/cube_view.hpp"
#include "pipeline/settings/check_settings.hpp"

namespace caustics {

LightViews views_all_around(const Scene& scene, const Effects& effects, const Settings& settings,
                            const Light& light) {
  const auto shone_on = [&](std::size_t i) { return light.emitter != static_cast<int>(i); };
  const View all = cube_view(light.position, distances_from(light.position, scene, shone_on));
  const Distances casters = distances_from(light.position, scene, [&](std::size_t i) {
    return shone_on(i) && is_caster(effects.surfaces[i].role);
  });
  const View map = with_atlas(all, settings.map), shadow = with_atlas(all, settings.shadow);
  // The landings' maps alike: what reaches over an edge must be as wide in both tiles.
  View grid = with_atlas(all, settings.grid);
  View caustic = with_atlas(all, settings.map, caustic_guard(settings));
  grid.cube->square = caustic.cube->square = true;
  LightViews views{.caster = grid,
                   .receiver = map,
                   .caustic = caustic,
                   .shadow = shadow,
                   .panes = shadow,
                   .column = map,
                   .cascade = {}};
  // Mirrored light can land on what stands nearer than all casters; refracted light goes on.
  const bool comes_back = effects.mirrors.active || effects.reflections.active;
  views.casters_nearest = casters.empty() || comes_back ? 0.0 : casters.nearest * 0.999;
  return views;
}

}  // namespace caustics
