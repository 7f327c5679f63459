// How fine grid and maps have to be for what a picture shows.
#pragma once
#include <vector>

#include "pipeline/effects/effects.hpp"
#include "pipeline/measure/landing_survey.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

// Does the frame choose both sides itself? Not where one is given, where landings are drawn as points, whose
// number belongs to the map's, or where water moves, whose pictures are to be alike.
bool chooses_sides(const Scene& scene, const Settings& settings);

// The settings with sides that are given: those that are chosen by themselves stay at the least, 512.
Settings with_least_sides(Settings settings);

// The same, with the least sides for which maps blur no more of the caustics' light over their edges, as the
// camera sees them, than 0.4 %, or the largest that may be expected to take at most twice the time of the
// least. `surveys` and `views` by Scene::lights. Lights that are drawn by several samples do not count: their
// edges are soft. `is_followed`: light meets further surfaces, and the grid grows less.
Settings with_sides_for_picture(Settings settings, const Scene& scene, bool is_followed,
                                const std::vector<LandingSurvey>& surveys,
                                const std::vector<LightViews>& views, const View& camera);

}  // namespace caustics
