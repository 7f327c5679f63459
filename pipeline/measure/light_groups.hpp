// Scenes of very many lights: a caustic that stands for those of several lights near one another.
#pragma once
#include <vector>

#include "pipeline/effects/effects.hpp"

namespace caustics {

// Leaves `most` lights (0: any number) that are drawn on their own, or more where groups would be wider than
// about a radian; of the others LightShare::drawn_with says with which, whose `share` and `of_others` grow by
// theirs, so that all light that the casters send on stays. Lights are near one another as the casters see
// them: a distance is an angle from the nearest caster, and those of another type are far. The order of
// choice: the light that adds most, then again and again that whose light, times the square of its distance
// from those chosen, is largest; of each group then the one that is nearest to all of it.
void group_lights(const Scene& scene, const Effects& effects, int most, std::vector<LightShare>& shares);

}  // namespace caustics
