#include "app/texture_label.hpp"

#include <algorithm>
#include <string_view>

namespace caustics::app {

namespace {

constexpr std::string_view kWater = "water ";

// "sun 656.3nm" for "0 656.3nm", "pool" for "water 0".
std::string named_owner(const std::string& owner, int light, const Scene& scene) {
  if (light >= 0) {
    const std::string& name = scene.lights[static_cast<std::size_t>(light)].name;
    return name.empty() ? owner : name + owner.substr(std::to_string(light).size());
  }
  for (std::size_t water = 0; water < scene.waters.size(); ++water)
    if (owner == std::string(kWater) + std::to_string(water) && !scene.waters[water].name.empty())
      return scene.waters[water].name;
  return owner;
}

}  // namespace

std::string texture_label(const PlannedTexture& texture, const Scene& scene) {
  const std::string& name = texture.name;
  const std::size_t open = name.find('[');
  if (open == name.npos) return name;
  const std::size_t dot = std::min(name.find('.'), open);
  const std::string owner = name.substr(open + 1, name.size() - open - 2);
  return name.substr(0, dot) + "[" + named_owner(owner, texture.light, scene) + "]" +
         name.substr(dot, open - dot);
}

}  // namespace caustics::app
