// Which casters a light can be expected to throw a caustic through, told from where things stand.
#pragma once
#include <string>
#include <vector>

#include "pipeline/effects/effects.hpp"
#include "pipeline/effects/surface_role.hpp"

namespace caustics {

// Gives no light: its intensity or its colour is 0.
bool is_dark(const Light& light);

// Why no light of this kind gets from the light straight to a mesh (index into Scene::meshes), or nothing.
std::string why_not_lit(const Scene& scene, const Light& light, std::size_t mesh);

// One for each light and each mesh that looks as if it threw a caustic. With IOR 1 there is no focus, but the
// light has to be carried through, so what the plan does is the same. `judgements` by Scene::meshes.
std::vector<Expectation> expectations_of(const Scene& scene, const std::vector<Judgement>& judgements);

}  // namespace caustics
