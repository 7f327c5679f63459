// JSON documents whose members keep the order in which they were set.
#pragma once
#include <nlohmann/json.hpp>

// Compiled once, in app/json.cpp, instead of in every source that writes JSON.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace caustics::app {

using Json = nlohmann::ordered_json;

}  // namespace caustics::app
