#include "app/output/light_groups.hpp"

#include <algorithm>

#include "app/shell/terminal.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics::app {

std::vector<int> samples_of(const Scene& scene, int source) {
  std::vector<int> samples;
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (scene.lights[i].source == source) samples.push_back(static_cast<int>(i));
  return samples;
}

bool is_first_sample(const Scene& scene, int light) {
  return light == 0 || scene.lights[static_cast<std::size_t>(light - 1)].source !=
                           scene.lights[static_cast<std::size_t>(light)].source;
}

std::string size_text(const Scene& scene, int source) {
  const Light& light = scene.sources[static_cast<std::size_t>(source)];
  std::string text;
  switch (light.shape) {
    case LightShape::None:
      return {};
    case LightShape::Sphere:
      text = "sphere of radius " + significant(light.radius, 3) + " m";
      break;
    case LightShape::Rectangle:
      text = "rectangle of " + significant(exact::length(light.width), 3) + " x " +
             significant(exact::length(light.height), 3) + " m";
      break;
    case LightShape::Disk:
      text = "disk of " + significant(light.angular_radius * (360.0 / exact::kPi), 3) + " degrees";
      break;
    case LightShape::Mesh:
      text = "mesh that shines";
      break;
  }
  const std::size_t samples = samples_of(scene, source).size();
  return text + ", " + std::to_string(samples) + (samples == 1 ? " sample" : " samples");
}

std::vector<Expectation> expectations_by_source(const Scene& scene, const Effects& effects) {
  std::vector<Expectation> groups;
  for (Expectation e : effects.expectations) {
    e.light = scene.lights[static_cast<std::size_t>(e.light)].source;
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Expectation& group) {
      return group.light == e.light && group.mesh == e.mesh;
    });
    if (same == groups.end()) {
      groups.push_back(e);
    } else if (e.expected && !same->expected) {
      *same = e;
    }
  }
  return groups;
}

}  // namespace caustics::app
