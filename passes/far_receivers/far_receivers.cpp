#include "passes/far_receivers/far_receivers.hpp"

#include <algorithm>

#include "passes/caustic_cells/caustic_cells.hpp"
#include "passes/caustic_map/caustic_map.hpp"
#include "passes/cells/cells.hpp"
#include "passes/landing/landing.hpp"
#include "passes/receiver_map/receiver_map.hpp"

namespace caustics {

namespace {

std::optional<std::string> called_for(const Effects& effects) {
  if (!effects.hidden_receivers.active) return {};
  return "light lands where other receivers hide it from the light's own view";
}

std::optional<std::string> called_for_cells(const Effects& effects) {
  return effects.cells.active ? called_for(effects) : std::nullopt;
}

template <std::optional<std::string> (*called_for)(const Effects&), bool coloured>
std::optional<std::string> called_for_in(const Effects& effects) {
  return effects.coloured_caustics.active == coloured ? called_for(effects) : std::nullopt;
}

bool has_window(const Effects& effects, int light) {
  return effects.lights[static_cast<std::size_t>(light)].all_around.empty();
}

// The textures of which there is one for the nearest receivers and one for the farthest.
bool is_layered(const std::string& name) {
  static const char* const names[] = {"receiver_position", "receiver_depth", kLanding,  kLandingFlux, kLandingFresnel,
                                      kLandingAbsorbed,    kCellNear,        kCellFar,  kCellFlux,    kCausticMap};
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

// The same pass for the farthest receivers instead of the nearest.
Pass far(Pass pass, std::optional<std::string> (*reason)(const Effects&)) {
  const auto rename = [](std::string& name) {
    if (is_layered(name)) name = far_texture(name);
  };
  pass.definition.name = far_texture(pass.definition.name);
  for (TextureRead& read : pass.definition.reads) rename(read.name);
  for (ColorWrite& write : pass.definition.writes) rename(write.name);
  if (pass.definition.depth) rename(pass.definition.depth->name);
  pass.called_for_by = reason;
  pass.light_needs = has_window;
  return pass;
}

}  // namespace

Pass far_receiver_map_pass() {
  Pass pass = far(receiver_map_pass(), called_for);
  pass.definition.purpose = "finds the last receiver that lies behind the casters, seen from the light";
  pass.definition.depth->clear = 0.0f;
  pass.definition.depth_state.compare = Compare::Greater;
  return pass;
}

Pass far_landing_pass() {
  Pass pass = far(landing_pass(), called_for);
  pass.definition.purpose = "follows what has not landed on the nearest receivers to the farthest";
  for (TextureRead& read : pass.definition.reads)
    if (read.name == kLandedBefore) read = {.name = kLanding, .meaning = "what has landed already"};
  pass.uniforms = [](const PassContext& context) {
    LandingUniforms uniforms = landing_uniforms(context);
    uniforms.variant.w = 1;
    return uniform_bytes(uniforms);
  };
  return pass;
}

Pass far_cells_pass() { return far(cells_pass(), called_for_cells); }
Pass far_caustic_cells_pass() { return far(caustic_cells_pass(), called_for_in<called_for_cells, true>); }
Pass far_caustic_cells_grey_pass() { return far(caustic_cells_grey_pass(), called_for_in<called_for_cells, false>); }
Pass far_caustic_map_pass() { return far(caustic_map_pass(), called_for_in<called_for, true>); }
Pass far_caustic_map_grey_pass() { return far(caustic_map_grey_pass(), called_for_in<called_for, false>); }

}  // namespace caustics
