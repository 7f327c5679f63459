// The layers that `caustics reference` writes: those of `render` that a light tracer can tell, and the
// error of its own.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/shell/parser.hpp"
#include "lab/reference/tracer/tracer.hpp"

namespace caustics::app {

// The layers of "caustic,direct"; throws Error (WrongUsage) for `beauty` and unknown ones.
std::vector<std::string> parse_reference_layers(const std::string& list);
std::vector<std::string> all_reference_layers();
// Lists names and meanings in the help.
void list_reference_layers(Parser& parser);

// Writes an EXR file of these layers. Throws Error (NumericFault) rather than write what is not finite.
void write_reference_layers(const std::filesystem::path& path, const std::vector<std::string>& layers,
                            const tracer::Tracer& tracer, int threads);

}  // namespace caustics::app
