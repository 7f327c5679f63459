// Every hard case on both backends: finite texels, closed ledgers, equal bits, and what each promises.
// docs/stability.md has the table that the hidden test prints.
#include <cstdio>
#include <iostream>

#include "pipeline/gpu/difference.hpp"
#include "tests/gl/gl_or_skip.hpp"
#include "tests/stability/hard_case.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kLedgerTolerance = 1e-5;

void check_invariants(const DrawnCase& drawn) {
  const Invariants found = invariants_of(drawn);
  INFO("first texture with values that are not finite: " << found.first_non_finite);
  CHECK(found.non_finite == 0);
  CHECK(found.residual < kLedgerTolerance);
  CHECK(found.textures > 0);
}

std::size_t differing_values(const Rendering& a, const Rendering& b, std::string& first) {
  std::size_t differing = 0;
  for (const auto& [name, image] : a.images) {
    const ImageDifference d = difference(image, b[name]);
    if (d.all.differing > 0 && first.empty()) first = name;
    differing += d.all.differing;
  }
  return differing;
}

void check_group(const HardCaseGroup& group) {
  const auto software = make_software_device();
  const std::unique_ptr<GlDevice> gl = gl_if_any();
  const bool exact = gl && driver_class(*gl) == DriverClass::LlvmpipeFused;
  for (const HardCase& hard_case : group.cases()) {
    INFO(hard_case.name);
    const DrawnCase drawn = draw_case(hard_case, *software, *software);
    check_invariants(drawn);
    hard_case.expect(drawn);
    if (!gl) continue;
    INFO("on OpenGL");
    const DrawnCase on_gl = draw_case(hard_case, *gl, *software);
    check_invariants(on_gl);
    hard_case.expect(on_gl);
    std::string first;
    const std::size_t differing = differing_values(drawn.rendering, on_gl.rendering, first);
    INFO("first texture that differs: " << first);
    if (exact) CHECK(differing == 0);
  }
  if (!gl) gl_or_skip();
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100.0 * share);
  return text;
}

// Books in words: where the light of all lights went, the largest shares first in a fixed order.
std::string books(const DrawnCase& drawn) {
  if (drawn.ledgers.empty() || !(drawn.ledger().entered[1] > 0.0)) return "nothing enters";
  const std::pair<const char*, FluxRgb Ledger::*> accounts[] = {
      {"in the map", &Ledger::in_map},
      {"Fresnel", &Ledger::fresnel},
      {"absorbed", &Ledger::absorbed},
      {"total reflection", &Ledger::total_reflection},
      {"missed", &Ledger::missed},
      {"outside", &Ledger::outside},
      {"not converged", &Ledger::not_converged},
      {"exit not found", &Ledger::exit_not_found},
      {"given up", &Ledger::given_up},
      {"map's edge", &Ledger::kernel_edge}};
  std::string text;
  for (const auto& [name, account] : accounts)
    if (std::fabs(drawn.share(account)) > 5e-5)
      text += (text.empty() ? "" : ", ") + std::string(name) + " " + percent(drawn.share(account));
  return text;
}

std::string backends(const HardCase& hard_case, const DrawnCase& drawn, GlDevice* gl, Device& software) {
  if (!gl) return "software only";
  std::string first;
  const std::size_t differing =
      differing_values(drawn.rendering, draw_case(hard_case, *gl, software).rendering, first);
  return differing == 0 ? "equal" : std::to_string(differing) + " values differ";
}

}  // namespace

TEST_CASE("hard cases: optics") { check_group(kHardCaseGroups[0]); }
TEST_CASE("hard cases: estimators and receivers") { check_group(kHardCaseGroups[1]); }
TEST_CASE("hard cases: meshes") { check_group(kHardCaseGroups[2]); }
TEST_CASE("hard cases: lights and cameras") { check_group(kHardCaseGroups[3]); }
TEST_CASE("hard cases: scale") { check_group(kHardCaseGroups[4]); }
TEST_CASE("hard cases: maps and sums") { check_group(kHardCaseGroups[5]); }
TEST_CASE("hard cases: light that is followed") { check_group(kHardCaseGroups[6]); }

TEST_CASE("hard cases: a table of what becomes of each", "[.hard_cases]") {
  const auto software = make_software_device();
  const std::unique_ptr<GlDevice> gl = gl_if_any();
  for (const HardCaseGroup& group : kHardCaseGroups) {
    std::cout << "| " << group.name
              << " | behaviour | where the light went | residual | rounding / its bound | backends |\n"
              << "|---|---|---|---|---|---|\n";
    for (const HardCase& hard_case : group.cases()) {
      const DrawnCase drawn = draw_case(hard_case, *software, *software);
      const Invariants found = invariants_of(drawn);
      char sums[64];
      std::snprintf(sums, sizeof sums, "%.0e | %.0e / %.0e", found.residual, found.rounding,
                    found.rounding_bound);
      std::cout << "| " << hard_case.name << " | " << hard_case.behaviour << " | " << books(drawn) << " | "
                << sums << " | " << backends(hard_case, drawn, gl.get(), *software) << " |\n";
      CHECK(found.non_finite == 0);
    }
    std::cout << "|\n";
  }
}
