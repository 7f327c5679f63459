// Scenes of many lights: those that add little to the light on the casters have smaller grids and maps, and
// the weakest throw no caustic at all, so that a thousand lights take the time of some dozens.
#pragma once
#include <map>
#include <tuple>

#include "pipeline/effects/effects.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

// Up to so many lights each is drawn in full. The samples of a light with a size count once.
inline constexpr std::size_t kFewLights = 16;

// The effects with what was found of each light (by Scene::sources; nothing of few lights): the caustics of
// those that are left out are not expected, with the reason, and LightEffects::divide is set. Their direct
// light stays.
Effects with_dim_lights(Effects effects, const Scene& scene, const Settings& settings,
                        const std::vector<LightShare>& shares);

// What each light is drawn with: the frame's settings, or those with smaller sides.
class LightSettings {
 public:
  // Both must outlive it.
  LightSettings(const Settings& settings, const Effects& effects);
  // By Scene::lights; the frame's own for -1.
  const Settings& operator[](int light) const;

 private:
  // LightEffects::divide, shadow_divide, and whether it is drawn onto a cube.
  using Key = std::tuple<int, int, bool>;
  static Key key(const LightEffects& light);

  const Settings& whole_;
  const Effects& effects_;
  std::map<Key, Settings> smaller_;
};

}  // namespace caustics
