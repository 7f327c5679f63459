// Which caustics are to be expected, by the scene and by what became of the light.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "app/flux.hpp"

namespace caustics::app {

// One for each light as a person knows it and each mesh that looks as if it threw a caustic. Where a
// light was followed (`ledgers`), the reason says what share of its flux lands, or why none does.
std::vector<Expectation> known_expectations(const Scene& scene, const Effects& effects,
                                            const std::vector<LightLedger>& ledgers);

// "light 'sun': 3.2% of the light onto its casters leaves its maps ..."; empty for 1 % and less.
std::string leaving_sentence(const Scene& scene, const LightLedger& ledger);

// "light 'sun': 66.3% of the light onto 'cup' is given up: its smooth normals lean ..."; empty where normals
// are not to blame, or less than a fifth of a caster's light is.
std::string leaning_sentence(const Scene& scene, const LightLedger& ledger);

// Casters that throw no caustic, for one reason.
struct NoCaustic {
  std::string casters;  // "light 'sun' through 'pane' (and 3 more)"
  std::string reason;
  std::set<int> meshes{};  // indices into Scene::meshes; none where nothing looks as if it threw one
  std::size_t count = 0;   // with each light
  std::string sentence() const { return casters.empty() ? reason : casters + ": " + reason; }
};
// Those of the most casters first.
std::vector<NoCaustic> missing_caustics(const Scene& scene, const std::vector<Expectation>& expectations);

std::string mesh_label(const Scene& scene, int mesh);

}  // namespace caustics::app
