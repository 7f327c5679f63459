// Numerically hard cases: scenes that break renderers, each with the behaviour that docs/stability.md
// promises.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

namespace caustics::test {

// A whole frame of a hard case on one device, every texture of its plan read back.
struct DrawnCase {
  const Scene& scene;
  const Settings& settings;
  Rendering rendering;
  std::vector<Ledger> ledgers;  // by light; empty accounts where a light throws no caustic

  const Ledger& ledger() const { return ledgers.front(); }
  // Of what entered, in the green channel.
  double share(FluxRgb Ledger::*account) const {
    return ledger().entered[1] > 0.0 ? (ledger().*account)[1] / ledger().entered[1] : 0.0;
  }
  // Of what entered: what left the casters, wherever it went then.
  double leaves() const;
  const Image& of_light(const char* texture) const { return rendering[light_texture(texture, 0)]; }
};

struct HardCase {
  std::string name;       // what is hard
  std::string behaviour;  // what happens, for people
  Scene scene;
  Settings settings = through_two_surfaces(small_settings(48, 64, 24));
  // The case's own expectation, beside finite texels, closed ledgers and equal backends.
  std::function<void(const DrawnCase&)> expect = [](const DrawnCase&) {};
};

std::vector<HardCase> optics_cases();
std::vector<HardCase> estimator_cases();
std::vector<HardCase> geometry_cases();
std::vector<HardCase> light_cases();
std::vector<HardCase> scale_cases();
std::vector<HardCase> map_cases();
std::vector<HardCase> followed_cases();

// Draws the whole frame; `pilot` fits the light views (the software device, whichever draws).
DrawnCase draw_case(const HardCase& hard_case, Device& device, Device& pilot);

// What must hold for every frame of every scene: how many texels are not finite, and the worst residual of a
// ledger.
struct Invariants {
  std::size_t non_finite = 0;
  std::string first_non_finite;  // the texture's name
  double residual = 0.0;
  std::size_t textures = 0;
  double rounding = 0.0, rounding_bound = 0.0;  // of the map's sums, relative to what entered; the largest
};
Invariants invariants_of(const DrawnCase& drawn);

// A group's name and its cases, in the order of docs/stability.md.
struct HardCaseGroup {
  const char* name;
  std::vector<HardCase> (*cases)();
};
inline const HardCaseGroup kHardCaseGroups[] = {{"Optics", optics_cases},
                                                {"Estimators and receivers", estimator_cases},
                                                {"Meshes", geometry_cases},
                                                {"Lights and cameras", light_cases},
                                                {"Scale", scale_cases},
                                                {"Maps and sums", map_cases},
                                                {"Light that is followed", followed_cases}};

}  // namespace caustics::test
