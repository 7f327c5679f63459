// What `caustics bench` measured with one number of threads, as text and as JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/bench_frames.hpp"

namespace caustics::app {

// A pass's instances in one row.
std::string bench_text(const BenchRun& run);
// Each instance by itself.
nlohmann::ordered_json bench_json(const BenchRun& run);

}  // namespace caustics::app
