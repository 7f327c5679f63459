#include "passes/registry.hpp"

#include "passes/caster_exit_map/caster_exit_map.hpp"
#include "passes/caster_map/caster_map.hpp"
#include "passes/caustic_map/caustic_map.hpp"
#include "passes/landing/landing.hpp"
#include "passes/occluder_depth/occluder_depth.hpp"
#include "passes/receiver_map/receiver_map.hpp"

namespace caustics {

const Registry& pass_registry() {
  static const Registry registry = {
      occluder_depth_pass(), caster_map_pass(), caster_exit_map_pass(),
      receiver_map_pass(),   landing_pass(),    caustic_map_pass(),
  };
  return registry;
}

}  // namespace caustics
