#include "tests/stability/hard_case.hpp"

#include <algorithm>
#include <cmath>

namespace caustics::test {

double DrawnCase::leaves() const {
  return share(&Ledger::in_map) + share(&Ledger::missed) + share(&Ledger::outside) +
         share(&Ledger::not_converged) + share(&Ledger::exit_not_found) + share(&Ledger::kernel_edge) +
         share(&Ledger::rounding);
}

DrawnCase draw_case(const HardCase& hard_case, Device& device, Device& pilot) {
  DrawnCase drawn{hard_case.scene,
                  hard_case.settings,
                  render_on(device, hard_case.scene, hard_case.settings, {}, &pilot),
                  {}};
  for (int light = 0; light < static_cast<int>(hard_case.scene.lights.size()); ++light) {
    const bool throws = drawn.rendering.images.count(light_texture(kCausticMap, light)) > 0;
    drawn.ledgers.push_back(throws ? ledger_of(drawn.rendering, hard_case.settings, light) : Ledger{});
  }
  return drawn;
}

Invariants invariants_of(const DrawnCase& drawn) {
  Invariants found;
  for (const auto& [name, image] : drawn.rendering.images) {
    ++found.textures;
    const std::size_t count = count_non_finite(image);
    found.non_finite += count;
    if (count > 0 && found.first_non_finite.empty()) found.first_non_finite = name;
  }
  for (const Ledger& ledger : drawn.ledgers) {
    found.residual = std::max(found.residual, ledger.residual());
    for (std::size_t c = 0; c < 3; ++c) {
      if (ledger.entered[c] <= 0.0) continue;
      found.rounding = std::max(found.rounding, std::fabs(ledger.rounding[c]) / ledger.entered[c]);
      found.rounding_bound = std::max(found.rounding_bound, ledger.rounding_bound[c] / ledger.entered[c]);
    }
  }
  return found;
}

}  // namespace caustics::test
