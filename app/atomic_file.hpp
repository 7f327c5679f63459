// Files that are complete or not there at all.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace caustics::app {

// Throws Error (CannotWrite) unless a file could be made or replaced at this path: tries it with a
// temporary file beside it. Called before the rendering, so that no work is lost.
void require_writable(const std::filesystem::path& path);

// Writes to a temporary file in the same folder, flushes it to the disk and renames it over `path`.
// On any failure the temporary is removed, what was there before stays, and Error (CannotWrite) is
// thrown. A symbolic link is followed, so that its target is replaced.
void write_atomically(const std::filesystem::path& path, const void* data, std::size_t size);
void write_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace caustics::app
