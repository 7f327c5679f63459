// The closing lines of `render`, on stderr.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/output/stats.hpp"
#include "pipeline/measure/seen_caustic.hpp"

namespace caustics::app {

// What the picture shows, its light, and notes; of what was added why only when verbose.
void print_summary(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers,
                   const std::optional<SeenCaustic>& seen, const std::vector<std::string>& given,
                   bool verbose);

// What was written, and what it took. `drawn` is the number of frames of a row, 0 for a single picture.
void print_work(const RenderedFrame& frame, const Timing& timing,
                const std::vector<std::filesystem::path>& outputs, int drawn);

}  // namespace caustics::app
