// The closing lines of `render`, on stderr.
#pragma once
#include <filesystem>
#include <vector>

#include "app/output/stats.hpp"

namespace caustics::app {

// `drawn` is the number of frames of a row, 0 for a single picture.
void print_summary(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers, const Timing& timing,
                   const std::vector<std::filesystem::path>& outputs, int drawn);

// Why some caster throws no caustic, one sentence each, equal reasons gathered: "light 'sun'
// through 'pane': thin wall ...".
std::vector<std::string> missing_caustics(const Scene& scene, const std::vector<Expectation>& expectations);

std::string mesh_label(const Scene& scene, int mesh);

}  // namespace caustics::app
