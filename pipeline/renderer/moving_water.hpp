// All waters of a scene, shown at a moment: their waves computed, their meshes put there; and views for the
// lights' maps that hold whatever the waves do.
#pragma once
#include <memory>
#include <vector>

#include "pipeline/renderer/light_pilot.hpp"
#include "pipeline/renderer/run_plan.hpp"
#include "pipeline/renderer/water_simulation.hpp"
#include "pipeline/renderer/water_surface.hpp"

namespace caustics {

// A note of what moving the water to a moment has cost: as PassReport, one for each water.
using WaterReport = std::vector<PassReport>;

class MovingWater {
 public:
  // The scene's waters are at rest, and are again when it goes. Scene and device must outlive it.
  MovingWater(Scene& scene, Device& device, const Registry& registry);
  MovingWater(const MovingWater&) = delete;
  MovingWater& operator=(const MovingWater&) = delete;
  ~MovingWater() { show_level(0.0); }

  // Moves the scene's water meshes to a moment, seconds; and, where asked for, sets Water::before, for a
  // plan that has the last step as a pass. What devices hold of the scene is not touched: see
  // SceneOnDevice::renew_waters.
  WaterReport show(double seconds, bool with_state);
  // Moves all waters, flat as at rest, up by this share of their highest waves.
  void show_level(double share);

 private:
  struct Moving {
    Moving(const Water& water, const Mesh& mesh, Device& device, const Pass& pass)
        : simulation(water, device, pass), surface(water, mesh) {}
    WaterSimulation simulation;
    WaterSurface surface;
  };

  Mesh& mesh_of(const Water& water) { return scene_.meshes[static_cast<std::size_t>(water.mesh)]; }

  Scene& scene_;
  std::vector<std::unique_ptr<Moving>> waters_;
};

// The views of every light (fit_light_views), without cascades, of a scene whose water moves: the same at
// every moment, so that neither maps nor shadows crawl from frame to frame. They hold what is seen and lit
// with the water flat at the top and at the bottom of its bounds, and with the waves of three moments after
// the first plops. `device` as for fit_light_views. Leaves the water at rest.
std::vector<LightViews> fit_moving_views(Scene& scene, Device& device, const Effects& effects,
                                         const Settings& settings, const Registry& registry);

}  // namespace caustics
