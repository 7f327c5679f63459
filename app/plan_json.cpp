#include "app/expectations.hpp"
#include "app/json.hpp"
#include "app/loaded_scene.hpp"
#include "app/output/light_groups.hpp"
#include "app/output/stats.hpp"
#include "app/plan_report.hpp"
#include "app/shell/version.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics::app {

namespace {

Json scene_json(const Scene& scene) {
  std::size_t triangles = 0;
  for (const Mesh& mesh : scene.meshes) triangles += mesh.indices.size() / 3;
  const Bounds bounds = bounds_of(scene);
  Json json = {{"file", scene.file},
               {"meshes", scene.meshes.size()},
               {"triangles", triangles},
               {"materials", scene.materials.size()},
               {"cameras", Json::array()}};
  for (const Camera& camera : scene.cameras) json["cameras"].push_back(camera.name);
  if (!bounds.empty()) {
    const glm::dvec3 lower = bounds.lower + scene.origin, upper = bounds.upper + scene.origin;
    json["bounds_metres"] = {{lower.x, lower.y, lower.z}, {upper.x, upper.y, upper.z}};
  }
  return json;
}

Json surfaces_json(const Scene& scene, const Effects& effects) {
  Json list = Json::array();
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i];
    const SurfaceRole& surface = effects.surfaces[i];
    list.push_back({{"mesh", mesh.name},
                    {"material", scene.materials[static_cast<std::size_t>(mesh.material)].name},
                    {"triangles", mesh.indices.size() / 3},
                    {"closedness", mesh.closedness},
                    {"role", caustics::name_of(surface.role)},
                    {"interfaces", surface.role == Role::Refractor ? surface.two_interfaces + 1 : 0},
                    {"reason", surface.reason}});
  }
  return list;
}

// Null for a light without a size.
Json size_json(const Light& light) {
  switch (light.shape) {
    case LightShape::None:
      return nullptr;
    case LightShape::Sphere:
      return {{"shape", "sphere"}, {"radius_metres", light.radius}};
    case LightShape::Rectangle:
      return {{"shape", "rectangle"}, {"metres", {exact::length(light.width), exact::length(light.height)}}};
    case LightShape::Disk:
      return {{"shape", "disk"}, {"angular_diameter_degrees", light.angular_radius * (360.0 / exact::kPi)}};
    case LightShape::Mesh:
      return {{"shape", "mesh"}, {"mesh", light.emitter}};
  }
  return nullptr;
}

Json lights_json(const Scene& scene) {
  Json list = Json::array();
  for (std::size_t i = 0; i < scene.sources.size(); ++i) {
    const Light& light = scene.sources[i];
    list.push_back({{"name", light.name},
                    {"type", name_of(light.type)},
                    {"intensity", light.intensity},
                    {"unit", intensity_unit(light)},
                    {"color", {light.color.x, light.color.y, light.color.z}},
                    {"size", size_json(light)},
                    {"samples", samples_of(scene, static_cast<int>(i)).size()}});
  }
  return list;
}

Json texture_json(const FramePlan& plan, const PlannedTexture& texture) {
  const bool in_frame = texture.until >= 0;
  return {{"name", texture.name},
          {"format", format_name(texture.format)},
          {"width", texture.width},
          {"height", texture.height},
          {"kept", texture.kept},
          {"until", in_frame ? Json(plan.passes[static_cast<std::size_t>(texture.until)].label) : Json()}};
}

Json passes_json(const PlanReport& report) {
  const FramePlan& plan = report.plan;
  Json list = Json::array();
  for (const PlannedSteps& steps : plan.before) {
    list.push_back({{"pass", steps.label},
                    {"reason", steps.reason},
                    {"reads", Json::array()},
                    {"writes", Json::array({texture_json(plan, steps.writes)})}});
  }
  for (const PlannedPass& pass : plan.passes) {
    Json reads = Json::array(), writes = Json::array();
    for (const int read : pass.reads) {
      if (read >= 0) reads.push_back(plan.textures[static_cast<std::size_t>(read)].name);
    }
    for (const int write : pass.attachments())
      writes.push_back(texture_json(plan, plan.textures[static_cast<std::size_t>(write)]));
    list.push_back({{"pass", pass.label},
                    {"reason", pass.reason},
                    {"draws_nothing", report.draws_nothing(pass)},
                    {"reads", reads},
                    {"writes", writes}});
  }
  return list;
}

}  // namespace

std::string plan_json(const PlanReport& report) {
  const Scene& scene = report.loaded.scene();
  const Effects& effects = report.effects;
  Json document = {{"format", 1},
                   {"program", version_line()},
                   {"scene", scene_json(scene)},
                   {"settings", settings_json(report.settings)},
                   {"camera", report.loaded.camera().name},
                   {"surfaces", surfaces_json(scene, effects)},
                   {"lights", lights_json(scene)},
                   {"expectations", Json::array()},
                   {"further_shares", Json::array()},
                   {"leaves_share", Json::array()},
                   {"model_error", Json::array()},
                   {"effects", Json::array()},
                   {"passes", passes_json(report)},
                   {"skipped", Json::array()},
                   {"texture_bytes", report.plan.bytes()},
                   {"seconds", report.seconds},
                   {"memory_bytes", report.memory.needed},
                   {"memory_budget_bytes", report.memory.budget.bytes},
                   {"refused", report.memory.refusal.empty() ? Json() : Json(report.memory.refusal)},
                   {"notes", report.notes()}};
  if (report.loaded.moves()) {
    document["animation"] = {{"seconds", report.loaded.duration()},
                             {"meshes", report.loaded.moving_meshes()}};
  }
  for (const Expectation& e : known_expectations(scene, effects, report.ledgers)) {
    document["expectations"].push_back(
        {{"light", e.light}, {"mesh", e.mesh}, {"expected", e.expected}, {"reason", e.reason}});
  }
  for (const FurtherShare& found : effects.further_shares)
    document["further_shares"].push_back(
        {{"light", scene.lights[static_cast<std::size_t>(found.light)].source},
         {"mesh", found.mesh},
         {"share", found.share},
         {"of_light", found.of_light},
         {"seen", found.seen}});
  for (const LightLedger& ledger : report.ledgers) {
    document["leaves_share"].push_back({{"light", ledger.light}, {"share", ledger.leaves()}});
    if (ledger.error.judged)
      document["model_error"].push_back({{"light", ledger.light},
                                         {"error", ledger.error.relative(ledger.error.model)},
                                         {"not_followed", ledger.error.relative(ledger.error.not_followed)}});
  }
  for (const NamedEffect& named : named_effects()) {
    const Effect& e = effects.*named.effect;
    document["effects"].push_back({{"name", named.name}, {"active", e.active}, {"reason", e.reason}});
  }
  for (const SkippedPass& pass : report.plan.skipped) {
    document["skipped"].push_back({{"pass", pass.name}, {"reason", pass.reason}});
  }
  return json_text(document);
}

}  // namespace caustics::app
