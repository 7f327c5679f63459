// From where and through which windows one light is looked along.
#pragma once
#include <optional>

#include "pipeline/scene/view.hpp"

namespace caustics {

// The views of one light. All share their origin, and but for `receiver`, `caustic`, `cascade` and `column`
// of a light that looks aside (LightEffects::looks) their axes; only the windows and depth ranges differ. All
// of them are cubes, or none is.
struct LightViews {
  View caster;    // on the casters: caster map, exit map
  View receiver;  // from the casters to where their light lands: receiver map
  View caustic;   // on where the light lands: caustic map
  View shadow;    // on everything that can throw or catch a shadow
  View panes;     // on the thin panes
  // z of the casters' nearest point: what lies before it within the column's window stands between light and
  // casters, and is no receiver of their light. Refracted light goes on forwards, so the column has
  // everything in it; mirrored light, and light that is followed, comes back, so it is the casters' own.
  double casters_nearest = 0.0;  // in cubes a distance
  View column;
  std::optional<View>
      cascade;  // a part of `caustic` that has a finer map of its own (pipeline/views/cascades.hpp)
};

}  // namespace caustics
