// The folder of a report, of `study` or of `paper`: its first run makes it, and later ones write it anew.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace caustics::app {

// Makes the folder; gives whether it was missing. Throws Error (CannotWrite) where it cannot be made, or
// holds what the report would replace, `replaces(path)`, and no `mark`: the report's JSON document by this
// program.
bool make_report_folder(const std::filesystem::path& folder, const std::string& mark,
                        const std::function<bool(const std::filesystem::path&)>& replaces);

}  // namespace caustics::app
