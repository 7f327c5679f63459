// Which caustics are to be expected, by the scene and by what became of the light.
#pragma once
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

}  // namespace caustics::app
