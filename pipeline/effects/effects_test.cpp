#include "pipeline/effects/effects.hpp"

#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

Mesh box(const char* name, int material, glm::vec3 lower, glm::vec3 upper) {
  Mesh mesh;
  mesh.name = name;
  mesh.material = material;
  mesh.closedness = 1.0f;
  mesh.lower = lower;
  mesh.upper = upper;
  return mesh;
}

Material solid_glass() {
  Material glass;
  glass.name = "glass";
  glass.metallic = 0.0f;
  glass.roughness = 0.0f;
  glass.transmission = 1.0f;
  glass.thickness = 1.0f;
  return glass;
}

// A glass box from (-1, 1, -1) to (1, 2, 1) over a floor, under a light that shines down.
Scene glass_over_floor(const Material& glass = solid_glass()) {
  Scene scene;
  Material floor;
  floor.name = "floor";
  floor.metallic = 0.0f;
  scene.materials = {glass, floor};
  scene.meshes = {box("block", 0, {-1, 1, -1}, {1, 2, 1}), box("floor", 1, {-5, 0, -5}, {5, 0, 5})};
  Light sun;
  sun.name = "sun";
  sun.direction = {0, -1, 0};
  scene.lights = {sun};
  return scene;
}

Effects judged(const Scene& scene, const Settings& settings = {}) { return effects_of(scene, settings); }

bool mentions(const std::string& text, const char* part) {
  INFO(text << " should mention " << part);
  CHECK(text.find(part) != std::string::npos);
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("solid glass refracts through two interfaces and throws a caustic") {
  const Effects effects = judged(glass_over_floor());
  CHECK(effects.surfaces[0].role == Role::Refractor);
  CHECK(effects.surfaces[0].two_interfaces);
  CHECK(effects.surfaces[0].reason ==
        "material 'glass': transmission 1.0, IOR 1.5, closed mesh: light enters and leaves");
  CHECK(effects.surfaces[1].role == Role::Receiver);
  REQUIRE(effects.expectations.size() == 1);
  CHECK(effects.expectations[0].expected);
  for (const Effect& effect :
       {effects.light, effects.receivers, effects.caustics, effects.exit_surface, effects.seen_casters}) {
    CHECK(effect.active);
  }
  // The floor is flat and behind everything: it shadows nothing.
  for (const Effect& effect :
       {effects.occluders, effects.thin_panes, effects.mirrors, effects.dispersion, effects.rough_glass}) {
    CHECK_FALSE(effect.active);
  }
}

TEST_CASE("glass without a volume is a thin pane unless it is assumed solid") {
  Material thin = solid_glass();
  thin.thickness = 0.0f;
  const Effects effects = judged(glass_over_floor(thin));
  CHECK(effects.surfaces[0].role == Role::ThinPane);
  CHECK_FALSE(effects.caustics.active);
  CHECK_FALSE(effects.expectations[0].expected);
  mentions(effects.expectations[0].reason,
           "thin wall (no KHR_materials_volume thickness): bends nothing; --assume-solid");
  mentions(effects.thin_panes.reason, "1 thin pane");
  Settings settings;
  settings.assume_solid = true;
  CHECK(judged(glass_over_floor(thin), settings).surfaces[0].role == Role::Refractor);
}

TEST_CASE("rough glass is a refractor whose light is spread where it is followed") {
  Material rough = solid_glass();
  rough.roughness = 0.25f;
  const Effects effects = judged(glass_over_floor(rough));
  CHECK(effects.surfaces[0].role == Role::Refractor);
  CHECK(effects.surfaces[0].rough);
  mentions(effects.surfaces[0].reason, "roughness 0.25 above 0.2");
  mentions(effects.rough_glass.reason, "1 surface of rough glass: light is followed, and spread");
  Settings settings;
  settings.further_share = 1.0f;
  mentions(judged(glass_over_floor(rough), settings).rough_glass.reason, "as through smooth glass");
  settings = {};
  settings.interfaces = Interfaces::Two;
  mentions(judged(glass_over_floor(rough), settings).rough_glass.reason, "as through smooth glass");
  rough.roughness = 0.2f;
  CHECK_FALSE(judged(glass_over_floor(rough)).rough_glass.active);
}

TEST_CASE("a rough wall without a volume is a refractor that bends nothing") {
  Material frosted = solid_glass();
  frosted.thickness = 0.0f;
  frosted.roughness = 0.25f;
  const Effects effects = judged(glass_over_floor(frosted));
  CHECK(effects.surfaces[0].role == Role::Refractor);
  CHECK(effects.surfaces[0].thin);
  CHECK(effects.surfaces[0].two_interfaces);  // closed: two walls
  CHECK(effects.rough_glass.active);
  CHECK_FALSE(effects.thin_panes.active);
  CHECK(effects.expectations[0].expected);
  mentions(effects.surfaces[0].reason, "thin wall (no KHR_materials_volume thickness), roughness 0.25");
}

TEST_CASE("materials that look like glass but throw no caustic say why") {
  Material opaque_index = solid_glass();
  opaque_index.ior = 0.0f;
  mentions(judged(glass_over_floor(opaque_index)).expectations[0].reason, "never refracts");

  Material milk = solid_glass();
  milk.transmission = 0.005f;
  mentions(judged(glass_over_floor(milk)).expectations[0].reason, "transmission 0.005 is below 0.01");

  Material nearly_metal = solid_glass();
  nearly_metal.metallic = 0.995f;
  nearly_metal.roughness = 0.21f;
  mentions(judged(glass_over_floor(nearly_metal)).surfaces[0].reason, "is left beside the metal");

  Material blended = solid_glass();
  blended.transmission = 0.0f;
  blended.alpha_mode = AlphaMode::Blend;
  blended.base_color.a = 0.5f;
  mentions(judged(glass_over_floor(blended)).expectations[0].reason, "coverage, not glass");
}

TEST_CASE(
    "a material that lets a share through is glass, and for the rest a diffuse surface in the same place") {
  Material milky = solid_glass();
  milky.transmission = 0.4f;
  Effects effects = judged(glass_over_floor(milky));
  CHECK(effects.surfaces[0].role == Role::Refractor);
  CHECK(effects.surfaces[0].partly_diffuse);
  mentions(effects.surfaces[0].reason, ", 60.0% diffuse");
  CHECK(effects.layered.active);
  CHECK_FALSE(effects.blended.active);
  CHECK_FALSE(effects.tinted_light.active);  // casters take their share of light themselves
  milky.thickness = 0.0f;
  effects = judged(glass_over_floor(milky));
  CHECK(effects.surfaces[0].role == Role::ThinPane);
  CHECK(effects.surfaces[0].partly_diffuse);
  CHECK(effects.tinted_light.active);
  // Metal lets nothing through: 0.5 of what is half metal.
  Material half_metal = solid_glass();
  half_metal.metallic = 0.5f;
  half_metal.roughness = 0.21f;
  mentions(judged(glass_over_floor(half_metal)).surfaces[0].reason, ", 50.0% diffuse or metal");
  CHECK_FALSE(judged(glass_over_floor()).surfaces[0].partly_diffuse);
  CHECK_FALSE(judged(glass_over_floor()).layered.active);
}

TEST_CASE("a pane's alpha is coverage: a share of it is not there") {
  Material pane = solid_glass();
  pane.thickness = 0.0f;
  pane.alpha_mode = AlphaMode::Blend;
  pane.base_color.a = 0.25f;
  const SurfaceRole surface = judged(glass_over_floor(pane)).surfaces[0];
  CHECK(surface.role == Role::ThinPane);
  CHECK(surface.partly_diffuse);
  mentions(surface.reason, "alpha 0.25 of it is there");
}

TEST_CASE("alphaMode BLEND is coverage where it is not glass, metal or opaque all over") {
  Material material;
  material.metallic = 0.0f;
  material.alpha_mode = AlphaMode::Blend;
  const auto surface = [&] { return judged(glass_over_floor(material)).surfaces[0]; };
  CHECK(surface().role == Role::Receiver);
  CHECK_FALSE(surface().blended);
  mentions(surface().reason, "alpha 1 all over: opaque");
  material.base_color.a = 0.5f;
  CHECK(surface().role == Role::Blended);
  CHECK(surface().blended);
  CHECK(judged(glass_over_floor(material)).tinted_light.active);
  material.base_color.a = 1.0f;
  material.least_alpha = 0.0f;  // a texture that covers nothing here, all there
  CHECK(surface().role == Role::Receiver);
  CHECK(surface().blended);
  material.transmission = 1.0f;
  material.thickness = 1.0f;
  material.roughness = 0.0f;
  CHECK(surface().role == Role::Refractor);
  CHECK_FALSE(surface().blended);
  mentions(surface().reason, "alphaMode BLEND ignored");
}

TEST_CASE("the limits of roughness and metal are in the role that they name") {
  Material glass = solid_glass();
  glass.roughness = 0.2f;
  CHECK(judged(glass_over_floor(glass)).surfaces[0].role == Role::Refractor);
  Material metal;
  metal.metallic = 0.5f;
  metal.roughness = 0.2f;
  const Effects effects = judged(glass_over_floor(metal));
  CHECK(effects.surfaces[0].role == Role::Mirror);
  CHECK(effects.expectations[0].expected);
  mentions(effects.expectations[0].reason, "mirrored onto what stands around");
  CHECK(effects.caustics.active);
  CHECK(effects.mirrors.active);
  CHECK(effects.seen_casters.active);
  CHECK_FALSE(effects.exit_surface.active);
  metal.roughness = 0.21f;
  CHECK(judged(glass_over_floor(metal)).surfaces[0].role == Role::Receiver);
  CHECK(judged(glass_over_floor(metal)).expectations.empty());
}

TEST_CASE("holes decide on the number of interfaces") {
  Scene scene = glass_over_floor();
  scene.meshes[0].closedness = 0.99f;
  CHECK(judged(scene).surfaces[0].two_interfaces);
  mentions(judged(scene).surfaces[0].reason, "nearly closed mesh (holes of 1.0% of its area)");
  scene.meshes[0].closedness = 0.5f;
  CHECK_FALSE(judged(scene).surfaces[0].two_interfaces);
  mentions(judged(scene).surfaces[0].reason, "one interface, as a water surface");
  CHECK_FALSE(judged(scene).exit_surface.active);
  Settings settings;
  settings.interfaces = Interfaces::Two;
  CHECK(judged(scene, settings).surfaces[0].two_interfaces);
}

TEST_CASE("IOR 1 lets the light through without a focus") {
  Material air = solid_glass();
  air.ior = 1.0f;
  const Effects effects = judged(glass_over_floor(air));
  CHECK(effects.expectations[0].expected);
  CHECK(effects.caustics.active);
  mentions(effects.expectations[0].reason, "without a focus");
}

TEST_CASE("a light that cannot reach the glass or what lies behind it") {
  Scene scene = glass_over_floor();
  const auto reason = [&] {
    const Effects effects = judged(scene);
    CHECK_FALSE(effects.expectations[0].expected);
    CHECK_FALSE(effects.caustics.active);
    return effects.expectations[0].reason;
  };
  scene.lights[0].direction = {0, 1, 0};
  mentions(reason(), "no receiver lies behind it");
  scene.lights[0].direction = {0, -1, 0};
  scene.lights[0].intensity = 0.0f;
  mentions(reason(), "is 0");
  CHECK_FALSE(judged(scene).light.active);
  scene.lights[0].intensity = 1.0f;
  scene.lights[0].color = glm::vec3(0.0f);
  mentions(reason(), "is 0");

  Light spot;
  spot.type = LightType::Spot;
  spot.position = {0, 10, 0};
  spot.direction = {0, -1, 0};
  spot.outer_cone = 0.3f;
  scene.lights = {spot};
  CHECK(judged(scene).expectations[0].expected);
  // The cone's edge runs through the block: its middle is outside of it, a corner inside.
  scene.lights[0].position = {3.7, 10, 0};
  CHECK(judged(scene).expectations[0].expected);
  scene.lights[0].position = {0, 10, 0};
  scene.lights[0].direction = {1, 0, 0};
  mentions(reason(), "cone misses it");
  scene.lights[0].direction = {0, 1, 0};
  scene.lights[0].outer_cone = 1.5f;
  mentions(reason(), "cone misses it");
  scene.lights[0].direction = {0, -1, 0};
  scene.lights[0].range = 3.0f;
  mentions(reason(), "beyond the light's range of 3.0 m");
  scene.lights[0].range = 8.3f;  // to the block's top, not to its middle
  CHECK(judged(scene).expectations[0].expected);

  scene.lights[0].range = 100.0f;
  scene.meshes.pop_back();
  mentions(reason(), "no diffuse receiver");
}

TEST_CASE("an empty scene calls for nothing") {
  const Effects effects = judged(Scene{});
  CHECK(effects.surfaces.empty());
  CHECK(effects.expectations.empty());
  for (const NamedEffect& named : named_effects()) {
    const Effect& effect = effects.*named.effect;
    CHECK_FALSE(effect.active);
    CHECK_FALSE(effect.reason.empty());
  }
}

TEST_CASE("caustics have one channel unless a caster tints them") {
  CHECK(!judged(glass_over_floor()).coloured_caustics.active);
  Material amber = solid_glass();
  amber.attenuation_color = {0.9f, 0.6f, 0.2f};
  CHECK(!judged(glass_over_floor(amber)).coloured_caustics.active);  // at no finite distance
  amber.attenuation_distance = 0.5f;
  const Effects tinted = judged(glass_over_floor(amber));
  CHECK(tinted.coloured_caustics.active);
  CHECK(mentions(tinted.coloured_caustics.reason, "absorbs its colours unequally"));
  Material smoke = solid_glass();
  smoke.base_color = {0.5f, 0.5f, 0.5f, 1.0f};
  CHECK(!judged(glass_over_floor(smoke)).coloured_caustics.active);
  smoke.base_color.x = 0.6f;
  CHECK(judged(glass_over_floor(smoke)).coloured_caustics.active);
  Material flint = solid_glass();
  flint.dispersion = 0.5f;
  CHECK(judged(glass_over_floor(flint)).coloured_caustics.active);
  Settings one;
  one.wavelengths = 1;
  CHECK(!judged(glass_over_floor(flint), one).coloured_caustics.active);
}

TEST_CASE("a medium scatters light only where a light shines, and shows its way only through casters") {
  Scene scene = glass_over_floor();
  CHECK_FALSE(judged(scene).scattering.active);
  CHECK(judged(scene).scattering.reason == "there is no medium");
  scene.medium.absorption = glm::vec3(0.1f);
  CHECK_FALSE(judged(scene).scattering.active);
  CHECK(judged(scene).scattering.reason == "the medium only absorbs");
  scene.medium.scattering = glm::vec3(0.1f);
  CHECK(judged(scene).scattering.active);
  CHECK(judged(scene).light_shafts.active);
  scene.lights[0].intensity = 0.0f;
  CHECK_FALSE(judged(scene).scattering.active);
  CHECK(judged(scene).scattering.reason == "no light shines");
  CHECK_FALSE(judged(scene).light_shafts.active);
}
