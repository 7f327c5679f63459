#include "pipeline/effects/medium_effects.hpp"

#include "pipeline/effects/surface_role.hpp"

namespace caustics {

namespace {

// "0.3", or "0.3 0.2 0.1" where the channels differ.
std::string per_channel(const glm::vec3& value) {
  if (value.x == value.y && value.y == value.z) return rounded_text(value.x);
  return rounded_text(value.x) + " " + rounded_text(value.y) + " " + rounded_text(value.z);
}

std::string description(const Medium& medium) {
  std::string text = "scattering " + per_channel(medium.scattering) + ", absorption " +
                     per_channel(medium.absorption) + " per metre";
  if (medium.anisotropy != 0.0f) text += ", anisotropy " + rounded_text(medium.anisotropy);
  return text;
}

}  // namespace

void add_medium(const Scene& scene, Effects& effects) {
  const Medium& medium = scene.medium;
  effects.medium = {medium.present(), medium.present() ? description(medium) : "the scene's air is clear"};
  const bool scatters = medium.scatters() && effects.light.active;
  effects.scattering = {scatters, scatters            ? "the medium scatters light towards the camera"
                                  : medium.scatters() ? "no light shines"
                                  : medium.present()  ? "the medium only absorbs"
                                                      : "there is no medium"};
  const bool shafts = scatters && effects.caustics.active;
  effects.light_shafts = {shafts, shafts     ? "the casters' light is seen on its way"
                                  : scatters ? "there is no caustic"
                                             : "nothing scatters"};
}

}  // namespace caustics
