#include "pipeline/scene/gltf/medium.hpp"

#include <cmath>

#include "pipeline/scene/gltf/cursor.hpp"

namespace caustics::gltf {

namespace {

// Denser than any fog: at 1000 per metre light is gone after a centimetre.
constexpr double kDensest = 1000.0;
// Beyond, the lobe around the light is narrower than single precision and the steps can follow.
constexpr double kMostForward = 0.99;

// The scene in use, as place_nodes chooses it.
Cursor scene_in_use(const Cursor& root) {
  const Cursor scenes = root.member("scenes");
  const auto chosen = root.member("scene").optional_index("scenes", scenes.size());
  if (scenes.size() == 0) return {root.context(), nullptr, "scenes[0]"};
  return scenes.element(static_cast<std::size_t>(chosen.value_or(0)));
}

// One number for all channels, or three.
glm::vec3 read_coefficient(const Cursor& cursor) {
  if (!cursor.present()) return glm::vec3(0.0f);
  std::vector<double> values;
  if (cursor.json().is_array()) {
    values = cursor.numbers(3);
  } else {
    values.assign(3, cursor.number());
  }
  glm::vec3 result;
  for (int c = 0; c < 3; ++c) {
    const double value = values[static_cast<std::size_t>(c)];
    if (!(value >= 0.0 && value <= kDensest))
      cursor.fail("must be from 0 to 1000 per metre, one number or [r, g, b]", "correct it");
    result[c] = static_cast<float>(value);
  }
  return result;
}

}  // namespace

Medium read_medium(Context& context, const Document& document) {
  const Cursor extras = scene_in_use(document.root(context)).member("extras");
  // `extras` may be anything; only objects say something about a medium.
  if (!extras.present() || !extras.json().is_object()) return {};
  const Cursor cursor = extras.member("medium");
  if (!cursor.present()) return {};
  if (!cursor.json().is_object())
    cursor.fail("must be an object", "give it scattering, absorption or both, per metre");
  Medium medium;
  medium.scattering = read_coefficient(cursor.member("scattering"));
  medium.absorption = read_coefficient(cursor.member("absorption"));
  const Cursor anisotropy = cursor.member("anisotropy");
  const double g = anisotropy.number(0.0);
  if (!(std::fabs(g) <= kMostForward))
    anisotropy.fail("must be from -0.99 to 0.99", "0 scatters to all sides alike");
  medium.anisotropy = static_cast<float>(g);
  return medium;
}

}  // namespace caustics::gltf
