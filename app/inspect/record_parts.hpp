// Parts of a run as the page reads it, each from one value.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "pipeline/gpu/pass_run.hpp"
#include "pipeline/measure/ledger.hpp"

namespace caustics::app {

// Topology, depth test, culling and blending, in words.
nlohmann::ordered_json state_json(const PassDefinition& definition);
// Of its first draw: names, values and meanings.
nlohmann::ordered_json uniforms_json(const PassDefinition& definition, const PassRun& run);
// Names of LandingStatus by number.
nlohmann::ordered_json status_names();
// Each with what it means.
nlohmann::ordered_json ledger_accounts(const Ledger& ledger);

}  // namespace caustics::app
