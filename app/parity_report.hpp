// What `caustics parity` found, judged by the allowances, as text and as JSON.
#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pipeline/gpu/allowance.hpp"
#include "pipeline/renderer/parity.hpp"

namespace caustics::app {

enum class ParityVerdict : std::uint8_t { Equal, Allowed, Beyond };
const char* name_of(ParityVerdict verdict);

struct JudgedAttachment {
  AttachmentParity parity;
  ParityVerdict verdict = ParityVerdict::Equal;
  std::string reason;  // of the allowance
};

struct ParityReport {
  std::string scene, reference, tested, driver;
  bool measured = false;
  std::vector<JudgedAttachment> isolated, whole_frame;
  std::vector<PassCounts> counts;

  bool passes() const;  // nothing beyond the allowances, and all counts equal
  std::size_t differing_values() const;
};

// `pass_names`: the definition's name of each label.
std::vector<JudgedAttachment> judge(const std::vector<AttachmentParity>& found, AllowanceBook& book,
                                    const std::function<std::string(const std::string& label)>& pass_name);

std::string parity_text(const ParityReport& report);
nlohmann::ordered_json parity_json(const ParityReport& report);

}  // namespace caustics::app
