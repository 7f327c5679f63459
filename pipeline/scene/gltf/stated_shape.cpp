#include "pipeline/scene/gltf/stated_shape.hpp"

#include "pipeline/scene/gltf/extras.hpp"

namespace caustics::gltf {

namespace {

constexpr std::size_t kMostWaves = 64;
// Farther, sines lose digits.
constexpr double kLargestPhase = 1e4;

SineWave wave_at(const Cursor& cursor) {
  if (!cursor.json().is_object()) cursor.fail("is no object", "write amplitude, k and phase");
  check_keys(cursor, {"amplitude", "k", "phase"});
  SineWave wave{.amplitude = cursor.member("amplitude").number()};
  const Cursor k = cursor.member("k");
  if (!k.present()) k.fail("is missing", "write [radians per unit along x, along z]");
  const std::vector<double> numbers = k.numbers(2);
  wave.k = {numbers[0], numbers[1]};
  wave.phase = cursor.member("phase").number(0.0);
  if (!(wave.phase >= -kLargestPhase && wave.phase <= kLargestPhase))
    cursor.member("phase").fail("must be from -10000 to 10000 radians", "take out whole turns");
  return wave;
}

HeightField field_of(const Cursor& shape, const Placement& placement, const Scene& scene) {
  check_keys(shape, {"level", "waves"});
  HeightField field{.level = shape.member("level").number(0.0)};
  const Cursor waves = shape.member("waves");
  if (!waves.present() || !waves.json().is_array() || waves.size() == 0 || waves.size() > kMostWaves)
    waves.fail("must be a list of 1 to 64 waves",
               "write { \"amplitude\": a, \"k\": [kx, kz], \"phase\": p } for each");
  for (std::size_t i = 0; i < waves.size(); ++i) field.waves.push_back(wave_at(waves.element(i)));
  const exact::Affine& to_world = placement.to_world;
  field.axes = glm::dmat3(to_world.x, to_world.y, to_world.z);
  field.origin = to_world.translation - scene.origin;
  return field;
}

bool is_word(const Cursor& cursor, std::string_view word) {
  return cursor.json().is<std::string>() && cursor.json().as<std::string>() == word;
}

}  // namespace

void read_stated_shapes(const Cursor& root, const std::vector<Placement>& placements, Scene& scene) {
  for (std::size_t object = 0; object < placements.size(); ++object) {
    const Cursor shape = extra_of(root, placements[object], "exact_shape");
    if (!shape.present()) continue;
    StatedShape stated{.mesh = only_mesh(shape, scene, static_cast<int>(object))};
    if (shape.json().is_object()) {
      stated.kind = ShapeKind::Waves;
      stated.field = field_of(shape, placements[object], scene);
    } else if (is_word(shape, "cylinder")) {
      stated.kind = ShapeKind::Cylinder;
    } else if (!is_word(shape, "sphere")) {
      shape.fail("is no shape that is known",
                 "write \"sphere\", \"cylinder\" or { \"level\": y, \"waves\": [...] }");
    }
    scene.stated_shapes.push_back(std::move(stated));
  }
}

}  // namespace caustics::gltf
