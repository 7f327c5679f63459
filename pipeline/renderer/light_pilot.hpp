// Where the maps of a light look.
#pragma once
#include <memory>
#include <vector>

#include "pipeline/measure/landing_survey.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/renderer/scene_on_device.hpp"

namespace caustics {

// Finds the views of every light (by Scene::lights), fitted to the casters and to where their light
// lands. Finds the latter by running the passes that lead to `landing` coarsely on the scene's device,
// which should be the software device whatever backend renders, so that every backend sees the same
// views. Its textures are kept from one call to the next, for scenes that move; what a call returns
// does not depend on earlier ones. All that it is made from must outlive it.
class LightPilot {
 public:
  LightPilot(const SceneOnDevice& scene, const Registry& registry);
  ~LightPilot();
  LightPilot(const LightPilot&) = delete;
  LightPilot& operator=(const LightPilot&) = delete;
  Device& device() const { return scene_.device(); }
  // Of the scene as it is now. `surveys`: takes what was found of each light's landings; nothing for
  // lights that are not fitted to them.
  std::vector<LightViews> fit(const Effects& effects, const Settings& settings,
                              std::vector<LandingSurvey>* surveys = nullptr);
  // What share of each light goes on from surface to surface, caster by caster; of the samples of a light
  // with a size the first alone. `effects`: nothing speaks against following it (why_not_followed).
  // `camera`: what the picture shows; null where there is none.
  std::vector<FurtherShare> further_shares(const Effects& effects, const Settings& settings,
                                           const View* camera) const;

 private:
  void fit_to_scouted(const Effects& effects, const Settings& settings, std::vector<LightViews>& views,
                      std::vector<LandingSurvey>* surveys);

  const SceneOnDevice& scene_;
  const Registry& registry_;
  std::unique_ptr<class LandingScout> scout_;
};

// The same for a scene that stands still.
std::vector<LightViews> fit_light_views(const SceneOnDevice& scene, const Effects& effects,
                                        const Settings& settings, const Registry& registry);

}  // namespace caustics
