// What a plan says of its passes and textures.
#include <string>

#include "pipeline/plan/frame_plan.hpp"

namespace caustics {

std::vector<int> PlannedPass::attachments() const {
  std::vector<int> result;
  for (const int texture : writes)
    if (texture != kNothing) result.push_back(texture);
  if (depth >= 0) result.push_back(depth);
  return result;
}

std::string_view why_left_out(const PlannedPass& pass) {
  return pass.drawn_for->layer > 0 ? "the picture has no such layer of blended surfaces"
                                   : "no light comes here";
}

int FramePlan::find(std::string_view name) const {
  if (!by_name.empty()) {
    const auto found = by_name.find(name);
    return found == by_name.end() ? -1 : found->second;
  }
  for (std::size_t i = 0; i < textures.size(); ++i)
    if (textures[i].name == name) return static_cast<int>(i);
  return -1;
}

std::size_t FramePlan::bytes() const {
  std::size_t sum = 0;
  for (const TextureMemory& each : memory)
    sum += bytes_per_texel(each.format) * static_cast<std::size_t>(each.width) *
           static_cast<std::size_t>(each.height);
  return sum;
}

std::string light_texture(std::string_view name, int light) {
  return std::string(name) + "[" + std::to_string(light) + "]";
}

std::string branch_texture(std::string_view name, int light, const Branch& branch) {
  if (branch.name.empty()) return light_texture(name, light);
  return std::string(name) + "[" + std::to_string(light) + " " + branch.name + "]";
}

std::string water_texture(std::string_view name, std::size_t water) {
  return std::string(name) + "[water " + std::to_string(water) + "]";
}

}  // namespace caustics
