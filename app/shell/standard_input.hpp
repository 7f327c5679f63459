// What comes through standard input, for `-` as a scene.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

namespace caustics::app {

// Everything up to its end, at most a byte more than `most`: read once, however often it is asked for. Throws
// Error: WrongUsage where it is a terminal, BadInput where it cannot be read.
std::shared_ptr<const std::vector<std::uint8_t>> standard_input(std::uint64_t most);

}  // namespace caustics::app
