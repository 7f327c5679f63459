// The memory that a frame takes, told before its textures exist.
#pragma once
#include <cstdint>
#include <string>

namespace caustics {
struct FramePlan;
struct Scene;
struct Settings;
}  // namespace caustics

namespace caustics::app {

// What the process occupies at its most when `render` draws the plan on the software device, makes the
// ledgers and writes a PNG file, in bytes. Measured frames are within a tenth of it.
std::uint64_t memory_needed(const FramePlan& plan, const Scene& scene, const Settings& settings);
// Throws Error (WrongUsage) when so much is more than three quarters of this machine's memory; `advice`: what
// to lower.
void check_memory(std::uint64_t needed, const std::string& advice);

}  // namespace caustics::app
