// Properties of frames over random scenes (RapidCheck), to find what nobody thought of. A failure prints the
// choices that led to it, made as small as they go, and the RC_PARAMS that repeat it.
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "tests/stability/hard_case.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// The same scenes in every run of the tests; RC_PARAMS asks for others, and for more.
void fix_seed() { setenv("RC_PARAMS", "seed=20261122 max_success=60", 0); }

// RapidCheck begins with small numbers and lets them grow; a body a millimetre wide is no simpler than one of
// a metre.
int from(int low, int end) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, end)); }

float between(float low, float high) {
  return low + (high - low) * static_cast<float>(from(0, 1001)) * 1e-3f;
}

// Powers of ten, both signs of the exponent.
float magnitude(int most) { return std::pow(10.0f, static_cast<float>(from(-most, most + 1))); }

Mesh random_body(int material) {
  const double x = static_cast<double>(between(-0.6f, 0.6f)), y = static_cast<double>(between(-0.1f, 1.2f)),
               size = static_cast<double>(between(0.01f, 0.8f));
  switch (from(0, 5)) {
    case 0:
      return sphere({x, y, 0.1}, size, from(0, 4), material);
    case 1:
      return box({x, y, -0.3}, {x + size, y + static_cast<double>(between(1e-6f, 0.5f)), 0.3}, material);
    case 2:
      return wave_sheet(size, y, static_cast<double>(between(0.0f, 0.2f)),
                        static_cast<double>(between(0.1f, 30.0f)), 12, material);
    case 3:
      return ring(0.5 * size, size, static_cast<double>(between(0.01f, 0.5f)), from(3, 24), material);
    default:
      return half_ring(size, static_cast<double>(between(0.01f, 0.5f)), from(2, 24), material);
  }
}

Material random_caster() {
  if (from(0, 4) == 0) return metal(glm::vec3(between(0.0f, 1.0f), between(0.0f, 1.0f), between(0.0f, 1.0f)));
  Material material = glass(*rc::gen::element(1.0f, 1.000001f, 1.33f, 1.5f, 2.42f, 4.0f, 0.9f, 0.5f, 100.0f));
  material.thickness = static_cast<float>(from(0, 2));
  material.attenuation_distance = *rc::gen::element(INFINITY, INFINITY, INFINITY, 1.0f, 1e-9f, 1e9f);
  material.attenuation_color = glm::vec3(between(0.0f, 1.0f), between(0.0f, 1.0f), 1.0f);
  material.dispersion = *rc::gen::element(0.0f, 0.0f, 0.3f, 20.0f);
  return material;
}

Light random_light() {
  Light light =
      sun({static_cast<double>(between(-1.5f, 1.5f)), static_cast<double>(between(-2.0f, 0.1f)), 0.2},
          magnitude(20));
  light.type = *rc::gen::element(LightType::Directional, LightType::Point, LightType::Spot);
  light.position = {static_cast<double>(between(-2.0f, 2.0f)), static_cast<double>(between(0.5f, 4.0f)),
                    static_cast<double>(between(-1.0f, 1.0f))};
  light.outer_cone = between(0.01f, 1.57f);
  light.inner_cone = light.outer_cone * between(0.0f, 1.0f);
  return light;
}

// Most lights in most scenes would shine past the casters: three of four are turned to one, from above.
void aim(Light& light, const Mesh& caster) {
  if (from(0, 4) == 0) return;
  const glm::dvec3 centre = 0.5 * glm::dvec3(caster.lower + caster.upper);
  light.position.y = centre.y + static_cast<double>(between(0.3f, 4.0f));
  if (light.type == LightType::Directional) light.direction.y = static_cast<double>(between(-3.0f, -0.5f));
  if (light.type != LightType::Directional) light.direction = centre - light.position;
  light.direction = glm::normalize(light.direction);
}

// Nothing speaks against following light from surface to surface. Meshes are bodies of their own, or parts of
// one.
void follow(HardCase& c) {
  Settings& s = c.settings;
  s.further_share = 0.0f;
  s.bounces = *rc::gen::element(16, 5, 2);
  s.splits = *rc::gen::element(2, 0, 1, 3);
  s.least_share = *rc::gen::element(1e-3f, 0.0f, 0.5f);
  s.interfaces = Interfaces::Auto;
  s.thickness = Thickness::Map;
  if (s.estimator == Estimator::Impostor) s.estimator = Estimator::Secant;
  for (Mesh& mesh : c.scene.meshes) mesh.object = from(0, 3);
}

HardCase random_case() {
  HardCase c{"a random scene", "", {}};
  Material blended = diffuse(0.5f);
  blended.alpha_mode = AlphaMode::Blend;
  blended.base_color.a = between(0.0f, 1.0f);
  blended.double_sided = from(0, 2) == 1;
  c.scene.materials = {diffuse(0.8f), random_caster(), random_caster(), blended};
  c.scene.meshes = {floor(3.0, 0.0, 0)};
  const int bodies = from(1, 4);
  c.scene.meshes.push_back(random_body(1));
  for (int i = 1; i < bodies; ++i) c.scene.meshes.push_back(random_body(*rc::gen::element(1, 1, 2, 0, 3)));
  c.scene.lights = {random_light()};
  aim(c.scene.lights[0], c.scene.meshes[1]);
  c.scene.cameras = {
      camera_down(static_cast<double>(between(0.1f, 5.0f)), static_cast<double>(between(0.1f, 4.0f)))};
  Settings& s = c.settings;
  s = small_settings(*rc::gen::element(24, 24, 24, 40, 40, 9, 2, 1), *rc::gen::element(24, 24, 40, 7, 1), 12);
  s.estimator =
      *rc::gen::element(Estimator::Secant, Estimator::Paper, Estimator::Newton, Estimator::Impostor);
  s.splat = *rc::gen::element(Splat::Cell, Splat::Point, Splat::Gaussian);
  s.interfaces = *rc::gen::element(Interfaces::Auto, Interfaces::One, Interfaces::Two);
  s.thickness = *rc::gen::element(Thickness::Map, Thickness::Wyman);
  s.reflections = from(0, 2) == 1;
  s.cube = Cube::Off;
  if (from(0, 2) == 1) follow(c);
  return c;
}

constexpr double kLedgerTolerance = 1e-5;

// What a failure needs to be told.
std::string description(const HardCase& c, const DrawnCase& drawn) {
  std::ostringstream text;
  text.precision(9);
  const Settings& s = c.settings;
  text << "grid " << s.grid << ", map " << s.map << ", " << name_of(s.estimator) << ", " << name_of(s.splat)
       << ", interfaces " << name_of(s.interfaces) << ", thickness " << name_of(s.thickness)
       << (s.reflections ? ", reflections" : "");
  if (drawn.rendering.effects.further_surfaces.active)
    text << ", followed through " << s.bounces << " surfaces, " << s.splits << " splits, down to "
         << s.least_share;
  text << "\n";
  for (const Mesh& mesh : c.scene.meshes)
    text << mesh.name << " of material " << mesh.material << ", " << mesh.indices.size() / 3
         << " triangles, from " << mesh.lower.x << " " << mesh.lower.y << " " << mesh.lower.z << " to "
         << mesh.upper.x << " " << mesh.upper.y << " " << mesh.upper.z << "\n";
  for (const Material& m : c.scene.materials)
    text << m.name << ": index " << m.ior << ", dispersion " << m.dispersion << ", thickness " << m.thickness
         << ", attenuation over " << m.attenuation_distance << "\n";
  const Light& light = c.scene.lights[0];
  text << "light of type " << static_cast<int>(light.type) << " at " << light.position.x << " "
       << light.position.y << " " << light.position.z << " along " << light.direction.x << " "
       << light.direction.y << " " << light.direction.z << ", cone " << light.inner_cone << " to "
       << light.outer_cone << "\n";
  const Ledger& l = drawn.ledger();
  const std::pair<const char*, FluxRgb> accounts[] = {{"entered", l.entered},
                                                      {"in map", l.in_map},
                                                      {"fresnel", l.fresnel},
                                                      {"absorbed", l.absorbed},
                                                      {"total reflection", l.total_reflection},
                                                      {"missed", l.missed},
                                                      {"outside", l.outside},
                                                      {"not converged", l.not_converged},
                                                      {"exit not found", l.exit_not_found},
                                                      {"given up", l.given_up},
                                                      {"kernel edge", l.kernel_edge},
                                                      {"rounding", l.rounding},
                                                      {"rounding bound", l.rounding_bound}};
  for (const auto& [name, flux] : accounts)
    text << name << " " << flux[0] << " " << flux[1] << " " << flux[2] << "\n";
  return text.str();
}

}  // namespace

TEST_CASE("random scenes: every texel is finite and every ledger closes") {
  fix_seed();
  const auto device = make_software_device();
  CHECK(rc::check("finite texels, closed ledgers", [&] {
    const HardCase c = random_case();
    const DrawnCase drawn = draw_case(c, *device, *device);
    const Invariants found = invariants_of(drawn);
    RC_LOG() << description(c, drawn);
    RC_CLASSIFY(drawn.ledger().in_map[1] > 0.0, "light lands");
    RC_CLASSIFY(!(drawn.ledger().entered[1] > 0.0), "no light enters");
    RC_CLASSIFY(drawn.rendering.effects.further_surfaces.active, "light is followed");
    RC_ASSERT(found.first_non_finite == "");
    RC_ASSERT(found.residual < kLedgerTolerance);
    for (const Ledger& ledger : drawn.ledgers)
      RC_ASSERT(ledger.in_map[1] <= ledger.entered[1] * 1.00001 + 1e-30);
  }));
}

TEST_CASE("random scenes: a light's intensity changes no map") {
  fix_seed();
  const auto device = make_software_device();
  CHECK(rc::check("maps are relative to the light", [&] {
    HardCase c = random_case();
    const DrawnCase once = draw_case(c, *device, *device);
    HardCase brighter = c;
    brighter.scene.lights[0].intensity *= 4.0f;
    const DrawnCase more = draw_case(brighter, *device, *device);
    for (const auto& [name, image] : once.rendering.images)
      if (name.starts_with("caustic_map") || name.starts_with("landing"))
        RC_ASSERT(sha256(image) == sha256(more.rendering[name]));
  }));
}

TEST_CASE("random scenes: threads and lanes change no bit") {
  fix_seed();
  CHECK(rc::check("the same on any number of scalar threads", [&] {
    const HardCase c = random_case();
    // One device at a time: oneTBB gives all that live no more threads than the one that asks for fewest.
    auto device = make_software_device();
    const DrawnCase a = draw_case(c, *device, *device);
    device.reset();
    device = make_software_device({.threads = from(1, 8), .lanes = Lanes::Scalar});
    const DrawnCase b = draw_case(c, *device, *device);
    for (const auto& [name, image] : a.rendering.images)
      RC_ASSERT(sha256(image) == sha256(b.rendering[name]));
  }));
}
