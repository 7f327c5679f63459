#include "app/expectations.hpp"

#include <algorithm>

#include "app/output/light_groups.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

// A larger share than this that leaves the maps is worth a warning.
constexpr double kMostLeaving = 0.01;

const Outcome* find_outcome(const std::vector<LightLedger>& ledgers, const Expectation& e) {
  for (const LightLedger& ledger : ledgers) {
    if (ledger.light != e.light) continue;
    const auto found = std::find_if(ledger.outcomes.begin(), ledger.outcomes.end(),
                                    [&](const Outcome& outcome) { return outcome.mesh == e.mesh; });
    if (found != ledger.outcomes.end()) return &*found;
  }
  return nullptr;
}

}  // namespace

std::vector<Expectation> known_expectations(const Scene& scene, const Effects& effects,
                                            const std::vector<LightLedger>& ledgers) {
  std::vector<Expectation> known = expectations_by_source(scene, effects);
  for (Expectation& e : known) {
    const Outcome* outcome = e.expected ? find_outcome(ledgers, e) : nullptr;
    if (!outcome) continue;
    const std::string why_not = why_no_caustic(*outcome);
    e.expected = why_not.empty();
    e.reason = e.expected ? e.reason + "; " + percent(outcome->share(LandingStatus::Landed)) + " of it lands"
                          : why_not;
  }
  return known;
}

std::string leaving_sentence(const Scene& scene, const LightLedger& ledger) {
  if (!(ledger.leaves() > kMostLeaving)) return {};
  return "light " + light_label(scene, ledger.light) + ": " + percent(ledger.leaves()) +
         " of the light onto its casters leaves its maps and is not drawn";
}

}  // namespace caustics::app
