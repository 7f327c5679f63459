// What `caustics parity` found, as text and as JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "pipeline/renderer/parity_judgement.hpp"

namespace caustics::app {

struct ParityReport {
  std::string scene, reference, tested;
  JudgedFrame judged;
};

std::string parity_text(const ParityReport& report);
nlohmann::ordered_json parity_json(const ParityReport& report);

}  // namespace caustics::app
