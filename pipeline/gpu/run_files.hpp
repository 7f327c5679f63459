// The files that one run reads and writes: no output may replace an input, nor another output.
//
// Each file is told to the list before anything is drawn or written; the first that clashes with an earlier
// one is refused. Two names are of one file when they lead to the same path, through symbolic links and other
// spellings too, or, where the files exist, to the same bytes on the disk (hard links). `-` is standard input
// or standard output, which may be sent from or to a file as well.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace caustics {

// The path with all symbolic links followed, also one that leads to nothing: what a write to `path` replaces.
std::filesystem::path followed(const std::filesystem::path& path);

class RunFiles {
 public:
  // `what` names the file in messages: "the scene", "the image of --environment". Both throw Error
  // (WrongUsage) where the file is one that the run also writes; writes() also where the run reads it.
  void reads(const std::filesystem::path& file, const std::string& what);
  void writes(const std::filesystem::path& file, const std::string& what);
  // A folder in which the run may write any file whose name `is_own` says yes to: neither it nor any of these
  // may be another file of the run, told before or after.
  void writes_in(const std::filesystem::path& folder, const std::string& what,
                 std::function<bool(const std::string& name)> is_own);

 private:
  struct Known {
    std::string what;
    bool written = false;
  };
  // Where the bytes of an existing file are.
  using Place = std::pair<std::uint64_t, std::uint64_t>;
  struct Folder {
    std::filesystem::path path;
    std::string what;
    std::function<bool(const std::string& name)> is_own;
  };

  void add(const std::filesystem::path& file, const Known& known);
  std::filesystem::path key_of(const std::filesystem::path& file, bool written);
  [[noreturn]] static void refuse(const std::filesystem::path& file, const Known& earlier,
                                  const Known& later);

  std::map<std::filesystem::path, Known> by_path_;
  std::map<Place, Known> by_place_;
  std::vector<Folder> folders_;
  // The folder of the last file, and where it leads: the frames of a film stand in one.
  std::filesystem::path last_folder_, last_followed_;
};

}  // namespace caustics
