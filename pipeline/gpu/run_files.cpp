#include "pipeline/gpu/run_files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <optional>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics {

namespace fs = std::filesystem;

namespace {

constexpr int kMostLinks = 40;  // as Linux has it

std::optional<struct stat> status_of(const fs::path& file, bool written) {
  struct stat found {};
  const bool there = file == "-" ? fstat(written ? STDOUT_FILENO : STDIN_FILENO, &found) == 0
                                 : stat(file.c_str(), &found) == 0;
  if (!there || !S_ISREG(found.st_mode)) return {};
  return found;
}

}  // namespace

fs::path followed(const fs::path& path) {
  std::error_code error;
  fs::path file = fs::absolute(path, error);
  if (!file.has_filename()) file = file.parent_path();  // "folder/"
  for (int links = 0; links < kMostLinks; ++links) {
    fs::path whole = fs::weakly_canonical(file, error);
    if (error) return file.lexically_normal();
    if (!fs::is_symlink(whole, error)) return whole;
    file = whole.parent_path() / fs::read_symlink(whole, error);  // a link that leads to nothing yet
  }
  return file;
}

void RunFiles::reads(const fs::path& file, const std::string& what) { add(file, {what, false}); }
void RunFiles::writes(const fs::path& file, const std::string& what) { add(file, {what, true}); }

fs::path RunFiles::key_of(const fs::path& file, bool written) {
  if (file == "-") return written ? "standard output" : "standard input";  // no absolute paths
  std::error_code error;
  const fs::path path = fs::absolute(file, error), name = path.filename();
  if (name.empty() || name == "." || name == ".." || fs::is_symlink(path, error)) return followed(path);
  if (path.parent_path() != last_folder_) {
    last_folder_ = path.parent_path();
    last_followed_ = followed(last_folder_);
  }
  return last_followed_ / name;
}

void RunFiles::add(const fs::path& file, const Known& known) {
  const fs::path key = key_of(file, known.written);
  const auto look = [&](const Known& earlier) {
    if (earlier.written || known.written) refuse(file, earlier, known);
  };
  if (const auto found = by_path_.find(key); found != by_path_.end()) look(found->second);
  for (const Folder& folder : folders_)
    if (key == folder.path || (key.parent_path() == folder.path && folder.is_own(key.filename().string())))
      refuse(file, {folder.what, true}, known);
  by_path_.emplace(key, known);
  const std::optional<struct stat> status = status_of(file, known.written);
  if (!status) return;
  const Place place{status->st_dev, status->st_ino};
  if (const auto found = by_place_.find(place); found != by_place_.end()) look(found->second);
  by_place_.emplace(place, known);
}

void RunFiles::writes_in(const fs::path& folder, const std::string& what,
                         std::function<bool(const std::string& name)> is_own) {
  const fs::path path = followed(folder);
  for (const auto& [file, known] : by_path_)
    if (file == path || (file.parent_path() == path && is_own(file.filename().string())))
      refuse(file, known, {what, true});
  for (const Folder& other : folders_)
    if (other.path == path) refuse(folder, {other.what, true}, {what, true});
  folders_.push_back({path, what, std::move(is_own)});
}

void RunFiles::refuse(const fs::path& file, const Known& earlier, const Known& later) {
  const std::string name = file == "-" ? "standard output" : one_line(file.string());
  const Known& writer = later.written ? later : earlier;
  const Known& other = later.written ? earlier : later;
  if (other.written)
    throw Error(ExitCode::WrongUsage, name + ": " +
                                          (earlier.what == later.what ? later.what + " names it twice"
                                                                      : earlier.what + " and " + later.what +
                                                                            " would both write it") +
                                          "; give each output a name of its own");
  throw Error(ExitCode::WrongUsage, name + ": " + writer.what + " would replace " + other.what +
                                        ", which is read; give the output another name");
}

}  // namespace caustics
