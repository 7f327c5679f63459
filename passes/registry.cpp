#include "passes/registry.hpp"

#include "passes/ambient_occlusion/ambient_occlusion.hpp"
#include "passes/ambient_rays/ambient_rays.hpp"
#include "passes/average_samples/average_samples.hpp"
#include "passes/beams/beams.hpp"
#include "passes/caster_exit_map/caster_exit_map.hpp"
#include "passes/caster_flux/caster_flux.hpp"
#include "passes/caster_map/caster_map.hpp"
#include "passes/caustic_cells/caustic_cells.hpp"
#include "passes/caustic_footprints/caustic_footprints.hpp"
#include "passes/caustic_map/caustic_map.hpp"
#include "passes/cells/cells.hpp"
#include "passes/compose/compose.hpp"
#include "passes/first_hit/first_hit.hpp"
#include "passes/glass/glass.hpp"
#include "passes/haze/haze.hpp"
#include "passes/hidden_ends/hidden_ends.hpp"
#include "passes/hidden_landings/hidden_landings.hpp"
#include "passes/impostor_map/impostor_map.hpp"
#include "passes/landing/landing.hpp"
#include "passes/light_haze/light_haze.hpp"
#include "passes/light_shading/light_shading.hpp"
#include "passes/light_shafts/light_shafts.hpp"
#include "passes/light_step/light_step.hpp"
#include "passes/occluder_depth/occluder_depth.hpp"
#include "passes/pane_light/pane_light.hpp"
#include "passes/receiver_map/receiver_map.hpp"
#include "passes/shadow_bounds/shadow_bounds.hpp"
#include "passes/shadow_map/shadow_map.hpp"
#include "passes/stretches/stretches.hpp"
#include "passes/tone_map/tone_map.hpp"
#include "passes/view_medium/view_medium.hpp"
#include "passes/view_range/view_range.hpp"
#include "passes/view_surfaces/view_surfaces.hpp"
#include "passes/walk/walk.hpp"
#include "passes/water_step/water_step.hpp"

namespace caustics {

namespace {

Registry registered() {
  Registry registry = {
      // Of pilots: what light does before a frame is planned.
      light_step_pass(),
      // Of each water: its waves.
      water_step_pass(),
      // Of the casters: what lies around them.
      impostor_map_pass(),
      // Of each light: what its casters do.
      occluder_depth_pass(),
      caster_map_pass(),
      caster_flux_pass(),
      caster_exit_map_pass(),
      receiver_map_pass(),
      shadow_map_pass(),
      pane_light_pass(),
      landing_pass(),
      walk_pass(),
      hidden_landings_pass(),
      stretches_pass(),
      beams_pass(),
      cells_pass(),
      caustic_cells_pass(),
      caustic_map_pass(),
      caustic_footprints_pass(),
      // Of the camera: the scene without glass, in the picture and where only glass shows it.
      view_surfaces_pass(),
      hidden_ends_pass(),
      view_range_pass(),
      light_shading_pass(),
      ambient_rays_pass(),
      ambient_occlusion_pass(),
      compose_pass(),
      // And with it.
      glass_pass(),
      // And the air before it.
      view_medium_pass(),
      shadow_bounds_pass(),
      light_haze_pass(),
      light_shafts_pass(),
      haze_pass(),
      // And what all its samples saw.
      average_samples_pass(),
      first_hit_pass(),
      tone_map_pass(),
  };
  validate(registry);
  return registry;
}

}  // namespace

const Registry& pass_registry() {
  static const Registry registry = registered();
  return registry;
}

}  // namespace caustics
