// Files that are complete or not there at all, and standard output.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "pipeline/gpu/run_files.hpp"

namespace caustics::app {

// `-` as an output.
inline bool is_standard_output(const std::filesystem::path& path) { return path == "-"; }

// Throws Error (CannotWrite) unless a file could be made or replaced at this path: tries it with a
// temporary file beside it. Called before the rendering, so that no work is lost.
void require_writable(const std::filesystem::path& path);

// What a file holds: a terminal shows text, and is spared everything else.
enum class Content { Text, Binary };

// Tells the run's list of a file that `option` writes. Throws Error: WrongUsage where it clashes with another
// of the run's files, or is `-` and standard output is a terminal that cannot show it; CannotWrite.
void require_output(RunFiles& files, const std::filesystem::path& path, const std::string& option,
                    Content content);
// Throws Error (WrongUsage) where `-` stands for what is more than one file, or none to be read from its
// beginning.
void refuse_standard_output(const std::filesystem::path& path, const std::string& option,
                            const std::string& why);

// A new file beside `path`, to be filled by whoever knows its name; removed again unless it was moved
// into place. A signal that ends the program removes it too.
class PendingFile {
 public:
  // Throws Error (CannotWrite). A symbolic link is followed, so that its target is replaced.
  explicit PendingFile(const std::filesystem::path& path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::string& name() const { return name_; }
  void write_all(const char* data, std::size_t size);
  // Flushes it to the disk and renames it: the moment at which the file appears under its name.
  void move_into_place();

 private:
  std::filesystem::path target_;
  std::string name_;
  int descriptor_ = -1;
  bool moved_ = false;
};

// Writes to a temporary file in the same folder, flushes it to the disk and renames it over `path`.
// On any failure the temporary is removed, what was there before stays, and Error (CannotWrite) is
// thrown. A symbolic link is followed, so that its target is replaced. `-` is standard output.
void write_atomically(const std::filesystem::path& path, const void* data, std::size_t size);
void write_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace caustics::app
