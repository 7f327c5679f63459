#include "app/inspect/record_parts.hpp"

#include <utility>

#include "app/flux.hpp"
#include "app/json.hpp"
#include "app/output/uniform_values.hpp"

namespace caustics::app {

namespace {

std::string text_of(Topology topology) {
  return topology == Topology::Triangles ? "triangles"
         : topology == Topology::Points  ? "points"
                                         : "rectangles";
}

std::string text_of(Compare compare) {
  constexpr const char* kNames[] = {"always",           "less",  "less or equal", "greater",
                                    "greater or equal", "equal", "never"};
  return kNames[static_cast<std::size_t>(compare)];
}

std::string text_of(BlendEquation equation) {
  return equation == BlendEquation::Add ? "add" : equation == BlendEquation::Min ? "min" : "max";
}

// What a ledger's accounts mean.
constexpr std::pair<const char*, const char*> kAccountMeanings[] = {
    {"entered", "light that meets the casters"},
    {"in_map", "light that is in the caustic map"},
    {"fresnel", "light mirrored at the surfaces, and not followed"},
    {"absorbed", "light that the material takes"},
    {"total_reflection", "light that cannot leave the caster at its second surface"},
    {"medium", "light that the haze takes"},
    {"missed", "light that meets no receiver"},
    {"outside", "light that lands beyond the maps"},
    {"not_converged", "light whose search for a receiver did not end on one"},
    {"exit_not_found", "light whose way out of the caster was not found"},
    {"given_up", "light too weak, or through too many surfaces, to be followed"},
    {"kernel_edge", "parts of splats beyond the map's edge"}};

}  // namespace

Json state_json(const PassDefinition& definition) {
  Json depth, cull, blend;
  const DepthState& state = definition.depth_state;
  if (definition.depth) depth = text_of(state.compare) + (state.write ? ", written" : "");
  if (definition.cull != Cull::None) cull = definition.cull == Cull::Back ? "back" : "front";
  for (const ColorWrite& write : definition.writes)
    if (write.blend.enabled)
      blend = write.blend == kMultiply ? std::string("multiply") : text_of(write.blend.equation);
  return {{"topology", text_of(definition.topology)}, {"depth", depth}, {"cull", cull}, {"blend", blend}};
}

Json uniforms_json(const PassDefinition& definition, const PassRun& run) {
  Json list = Json::array();
  if (run.draws.empty()) return list;
  for (const NamedUniform& uniform : uniform_values(definition, run.draws.front()))
    list.push_back(
        {{"name", uniform.name},
         {"value", uniform.values.size() == 1 ? Json(uniform.values.front()) : Json(uniform.values)},
         {"meaning", uniform.meaning}});
  return list;
}

Json status_names() {
  Json names = Json::array();
  for (int s = 0; s < kLandingStatuses; ++s)
    names.push_back(std::string(name_of(static_cast<LandingStatus>(s))));
  return names;
}

Json ledger_accounts(const Ledger& ledger) {
  Json list = Json::array();
  for (const auto& [name, flux] : accounts(ledger)) {
    std::string meaning;
    for (const auto& [account, text] : kAccountMeanings)
      if (std::string(name) == account) meaning = text;
    list.push_back({{"account", name}, {"meaning", meaning}, {"flux", flux}});
  }
  return list;
}

}  // namespace caustics::app
