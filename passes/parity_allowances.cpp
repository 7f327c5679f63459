#include "passes/parity_allowances.hpp"

namespace caustics {

const std::vector<Allowance>& parity_allowances() {
  static const std::vector<Allowance> allowances = {};
  return allowances;
}

}  // namespace caustics
