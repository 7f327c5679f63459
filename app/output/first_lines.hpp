// The first three lines of what `render` says, for a person who has brought a scene.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/flux.hpp"
#include "pipeline/measure/seen_caustic.hpp"

namespace caustics::app {

// What was added to the scene; how much of the light makes a caustic and where the picture shows it, or why
// there is none and what to do; how sure that is. `ledgers`: empty where the caustics were not drawn.
std::string first_lines(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers,
                        const std::optional<SeenCaustic>& seen);

// Does the frame call for no caustics, or land none of their light?
bool shows_none(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers);

}  // namespace caustics::app
