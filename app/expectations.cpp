#include "app/expectations.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/output/light_groups.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/measure/leaning_normals.hpp"
#include "pipeline/measure/meshes_in_the_way.hpp"
#include "pipeline/scene/defaults.hpp"

namespace caustics::app {

namespace {

// A larger share than this that leaves the maps is worth a warning.
constexpr double kMostLeaving = 0.01;

// From here on a caster's normals are named where so much of its light is given up.
constexpr double kLeaningDegrees = 20.0, kMostGivenUp = 0.2;

const Outcome* find_outcome(const std::vector<LightLedger>& ledgers, const Expectation& e) {
  for (const LightLedger& ledger : ledgers) {
    if (ledger.light != e.light) continue;
    const auto found = std::find_if(ledger.outcomes.begin(), ledger.outcomes.end(),
                                    [&](const Outcome& outcome) { return outcome.mesh == e.mesh; });
    if (found != ledger.outcomes.end()) return &*found;
  }
  return nullptr;
}

// With the name of what stands before the caster.
std::string named_reason(const Scene& scene, const Expectation& e, const MeshesInTheWay& meshes) {
  const int before = meshes.before(e.mesh, samples_of(scene, e.light));
  return before < 0 ? kNoLightReachesIt
                    : "no light reaches it: " + mesh_label(scene, before) + " stands before it";
}

}  // namespace

std::vector<Expectation> known_expectations(const Scene& scene, const Effects& effects,
                                            const std::vector<LightLedger>& ledgers) {
  const bool has_ground = std::any_of(scene.meshes.begin(), scene.meshes.end(),
                                      [](const Mesh& mesh) { return mesh.name == kGroundName; });
  std::vector<Expectation> known = expectations_by_source(scene, effects);
  std::optional<MeshesInTheWay> in_the_way;
  for (Expectation& e : known) {
    const Outcome* outcome = e.expected ? find_outcome(ledgers, e) : nullptr;
    if (!outcome) continue;
    const std::string why_not = why_no_caustic(*outcome, has_ground);
    e.expected = why_not.empty();
    e.reason = e.expected ? e.reason + "; " + percent(outcome->share(LandingStatus::Landed)) + " of it lands"
                          : why_not;
    if (why_not != kNoLightReachesIt) continue;
    if (!in_the_way) in_the_way.emplace(scene);
    e.reason = named_reason(scene, e, *in_the_way);
  }
  return known;
}

std::string mesh_label(const Scene& scene, int mesh) {
  const std::string& name = scene.meshes[static_cast<std::size_t>(mesh)].name;
  return name.empty() ? "mesh " + std::to_string(mesh) : "'" + one_line(name) + "'";
}

std::vector<NoCaustic> missing_caustics(const Scene& scene, const std::vector<Expectation>& expectations) {
  std::vector<NoCaustic> groups;
  for (const Expectation& e : expectations) {
    if (e.expected) continue;
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const NoCaustic& each) { return each.reason == e.reason; });
    if (group == groups.end())
      group = groups.insert(
          group,
          {"light " + light_label(scene, e.light) + " through " + mesh_label(scene, e.mesh), e.reason});
    group->meshes.insert(e.mesh);
    ++group->count;
  }
  if (expectations.empty())
    groups.push_back(
        {{},
         "nothing in the scene bends or mirrors light: glass needs KHR_materials_transmission and "
         "KHR_materials_volume, a mirror metallic 1 and roughness 0"});
  for (NoCaustic& group : groups)
    if (group.count > 1) group.casters += " (and " + std::to_string(group.count - 1) + " more)";
  std::stable_sort(groups.begin(), groups.end(),
                   [](const NoCaustic& a, const NoCaustic& b) { return a.count > b.count; });
  return groups;
}

std::string leaving_sentence(const Scene& scene, const LightLedger& ledger) {
  if (!(ledger.leaves() > kMostLeaving)) return {};
  return "light " + light_label(scene, ledger.light) + ": " + percent(ledger.leaves()) +
         " of the light onto its casters leaves its maps and is not drawn";
}

std::string leaning_sentence(const Scene& scene, const LightLedger& ledger) {
  for (const Outcome& outcome : ledger.outcomes) {
    const double share = outcome.share(LandingStatus::GivenUp);
    if (share < kMostGivenUp) continue;
    const double degrees = glm::degrees(mean_lean(scene.meshes[static_cast<std::size_t>(outcome.mesh)]));
    if (degrees < kLeaningDegrees) continue;
    return "light " + light_label(scene, ledger.light) + ": " + percent(share) + " of the light onto " +
           mesh_label(scene, outcome.mesh) + " is given up: its smooth normals lean " +
           std::to_string(std::lround(degrees)) +
           " degrees away from its triangles; split them at sharp edges (in Blender: Shade Auto Smooth)";
  }
  return {};
}

}  // namespace caustics::app
