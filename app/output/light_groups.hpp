// Lights as a person knows them, where an area light is drawn by many samples.
#pragma once
#include <string>
#include <vector>

#include "pipeline/effects/effects.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics::app {

// The indices into Scene::lights of the samples of sources[source], or of the light itself.
std::vector<int> samples_of(const Scene& scene, int source);

// Of an index into Scene::lights: of a light without a size always true.
bool is_first_sample(const Scene& scene, int light);

// "disk of 0.53 degrees, 16 samples"; nothing for a light without a size.
std::string size_text(const Scene& scene, int source);

// One expectation for each source and mesh, `light` being an index into Scene::sources: a caustic
// is expected where one sample's is.
std::vector<Expectation> expectations_by_source(const Scene& scene, const Effects& effects);

}  // namespace caustics::app
