#include "app/reference_report.hpp"

#include <algorithm>
#include <cmath>

#include "app/expectations.hpp"
#include "app/flux.hpp"
#include "app/json.hpp"
#include "app/output/light_groups.hpp"
#include "app/output/stats.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"

namespace caustics::app {

namespace {

double total(const glm::dvec3& v) { return v.x + v.y + v.z; }

const char* name_of(tracer::Physics physics) { return physics == tracer::Physics::Full ? "full" : "single"; }

double rays_of(const tracer::Tracer& tracer) {
  double rays = 0.0;
  for (const tracer::Account& account : tracer.state().accounts) rays += account.rays;
  return rays;
}

// Receivers whose own textures bend their normals are lit as if they were smooth.
bool has_normal_textures(const Scene& scene, const Effects& effects) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (effects.surfaces[i].role == Role::Receiver &&
        scene.materials[static_cast<std::size_t>(scene.meshes[i].material)].normal_texture.present())
      return true;
  return false;
}

void print_notes(const Scene& scene, const Effects& effects) {
  for (const std::string& note : scene.notes) std::fprintf(stderr, "note: %s\n", one_line(note).c_str());
  if (has_normal_textures(scene, effects))
    std::fputs(
        "note: normal textures of receivers are left out: 'direct', 'normal' and 'caustic' have the "
        "smooth surface\n",
        stderr);
  for (const NoCaustic& each : missing_caustics(scene, expectations_by_source(scene, effects)))
    std::fprintf(stderr, "no caustic: %s\n", one_line(each.sentence()).c_str());
}

void print_ledger(const Scene& scene, int source, const tracer::Account& account) {
  const double entered = total(account.entered);
  if (!(entered > 0.0)) return;
  std::string line = "light " + light_label(scene, source) + ": ", separator;
  for (const auto& [name, flux] : accounts(account)) {
    if (std::string(name) == "entered" || !(std::fabs(total(flux)) > 1e-4 * entered)) continue;
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    line += separator + words + " " + percent(total(flux) / entered);
    separator = ", ";
  }
  std::fprintf(stderr, "%s of the light onto its casters\n", line.c_str());
}

Json account_json(const Scene& scene, int source, const tracer::Account& account, double batches) {
  const Light& light = scene.sources[static_cast<std::size_t>(source)];
  Json flux = {{"unit", flux_unit(light)}};
  for (const auto& [name, value] : accounts(account)) {
    const glm::dvec3 mean = value / batches;
    flux[name] = {mean.x, mean.y, mean.z};
  }
  const glm::dvec3 gap = account.gap() / batches;
  flux["residual"] = {gap.x, gap.y, gap.z};
  return {{"light", source},
          {"name", light.name},
          {"intensity", light.intensity},
          {"intensity_unit", intensity_unit(light)},
          {"flux", flux},
          {"rays", account.rays},
          {"rays_onto_casters", account.hits},
          {"landings", account.landings}};
}

// To the nearest tenth; shares of light are rounded down.
std::string traced_error_text(double share) { return percent(share + 0.0005); }

}  // namespace

std::vector<std::pair<const char*, glm::dvec3>> accounts(const tracer::Account& a) {
  return {{"entered", a.entered},
          {"landed", a.landed},
          {"fresnel", a.fresnel},
          {"absorbed", a.absorbed},
          {"total_reflection", a.total_reflection},
          {"missed", a.missed},
          {"lost", a.lost},
          {"cut", a.cut}};
}

void print_reference(const ReferenceRequest& request, const Scene& scene, const Effects& effects,
                     const tracer::Tracer& tracer, const ReferenceTiming& timing) {
  print_notes(scene, effects);
  for (std::size_t i = 0; i < tracer.state().accounts.size(); ++i)
    print_ledger(scene, static_cast<int>(i), tracer.state().accounts[i]);
  const auto rays = static_cast<std::uint64_t>(rays_of(tracer));
  std::fprintf(
      stderr,
      "%s: %dx%d, %s batches of %d x %d rays a light (%s rays), error %s of the caustics' light (noise "
      "%s, given up %s), %s\n",
      one_line(request.output.string()).c_str(), request.trace.width, request.trace.height,
      grouped(tracer.state().batches).c_str(), request.trace.side, request.trace.side, grouped(rays).c_str(),
      traced_error_text(tracer.relative_error() + tracer.given_up()).c_str(),
      traced_error_text(tracer.relative_error()).c_str(), traced_error_text(tracer.given_up()).c_str(),
      duration_text(timing.total).c_str());
  std::error_code error;
  const auto bytes = std::filesystem::file_size(request.state_file(), error);
  if (!error)
    std::fprintf(stderr, "%s: %s, to go on from with --resume\n",
                 one_line(request.state_file().string()).c_str(),
                 bytes_text(static_cast<double>(bytes)).c_str());
}

std::string reference_stats(const ReferenceRequest& request, const Scene& scene, const tracer::Tracer& tracer,
                            const ReferenceTiming& timing) {
  const double batches = std::max(static_cast<double>(tracer.state().batches), 1.0);
  Json settings = settings_json(request.frame.settings, traced_parts());
  settings["rays"] = request.trace.side;
  settings["physics"] = name_of(request.trace.physics);
  Json document = {
      {"format", 1},
      {"program", version_line()},
      {"scene", scene.file},
      {"embree", tracer::ray_queries_version()},
      {"settings", settings},
      {"batches", tracer.state().batches},
      {"batches_of_this_run", timing.batches},
      {"rays", rays_of(tracer)},
      {"relative_error", tracer.relative_error() + tracer.given_up()},
      {"noise", tracer.relative_error()},
      {"given_up", tracer.given_up()},
      {"milliseconds", {{"prepare", timing.prepare}, {"trace", timing.trace}, {"total", timing.total}}}};
  document["exact"] = Json::array();
  for (const tracer::ExactShape& shape : request.trace.exact)
    document["exact"].push_back(
        {{"mesh", scene.meshes[static_cast<std::size_t>(shape.mesh)].name}, {"shape", name_of(shape)}});
  document["lights"] = Json::array();
  for (std::size_t i = 0; i < tracer.state().accounts.size(); ++i)
    if (tracer.state().accounts[i].rays > 0.0)
      document["lights"].push_back(
          account_json(scene, static_cast<int>(i), tracer.state().accounts[i], batches));
  document["notes"] = scene.notes;
  return json_text(document);
}

}  // namespace caustics::app
