#include "app/output/dump_folder.hpp"

#include <algorithm>
#include <fstream>
#include <map>

#include "app/json.hpp"
#include "app/output/stats.hpp"
#include "app/shell/atomic_file.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

namespace fs = std::filesystem;

namespace {

constexpr char kFiles[] = "files";

// What a manifest says of its folder: bytes by name.
using Listed = std::map<std::string, std::uintmax_t>;

// May a dump write a file of this name? 07_landing_sun.landing_front.exr, table_bodies.exr.
bool is_dumped_name(const std::string& name) {
  if (name == kManifestFile || name == kSheetFile || name == kPageFile) return true;
  if (name.starts_with("table_")) return name.ends_with(".exr");
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  const bool numbered = digits >= 2 && digits < name.size() && name[digits] == '_';
  return numbered && std::count(name.begin(), name.end(), '.') >= 2 &&
         (name.ends_with(".exr") || name.ends_with(".png"));
}

[[noreturn]] void refuse_folder(const fs::path& file, const std::string& why) {
  throw Error(ExitCode::CannotWrite, one_line(file.string()) + ": " + why +
                                         "; name another folder for the dump, or move the file away");
}

// Of no folder, and of one without a manifest: nothing.
Listed listed_in(const fs::path& folder) {
  Listed listed;
  const fs::path path = folder / kManifestFile;
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return listed;
  std::ifstream in(path, std::ios::binary);
  const Json manifest = Json::parse(in, nullptr, false);
  if (!manifest.is_object() || !manifest.contains(kFiles) || !manifest[kFiles].is_object())
    refuse_folder(path, "is not the manifest of a dump that this program wrote");
  for (const auto& [name, bytes] : manifest[kFiles].items())
    if (bytes.is_number_unsigned() && is_dumped_name(name)) listed[name] = bytes.get<std::uintmax_t>();
  return listed;
}

// Is it still the file that the manifest lists?
bool is_unchanged(const fs::path& file, std::uintmax_t bytes) {
  std::error_code error;
  return fs::symlink_status(file, error).type() == fs::file_type::regular &&
         fs::file_size(file, error) == bytes;
}

// Refuses what a dump would replace and no dump wrote. The page and the sheet are in no dump's way without
// pictures.
void refuse_foreign_files(const fs::path& folder, bool pictures) {
  const Listed listed = listed_in(folder);
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool of_page = name == kSheetFile || name == kPageFile;
    if (!is_dumped_name(name) || name == kManifestFile || (of_page && !pictures)) continue;
    const auto found = listed.find(name);
    if (found == listed.end()) refuse_folder(entry.path(), "is not listed in the folder's manifest.json");
    if (!is_unchanged(entry.path(), found->second))
      refuse_folder(entry.path(), "was changed since it was dumped");
  }
}

// The folder, or the nearest one above it that is there, can be written into.
void require_writable_folder(const fs::path& folder) {
  std::error_code error;
  fs::path there = fs::absolute(folder, error);
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, error))
    throw Error(ExitCode::CannotWrite,
                one_line(folder.string()) + ": cannot make this folder: a file is in its place");
  require_writable(there / kManifestFile);
}

}  // namespace

void require_dump_folder(RunFiles& files, const fs::path& folder, const std::string& option, bool pictures) {
  refuse_standard_output(folder, option, "a dump is a folder of files");
  files.writes_in(folder, option, is_dumped_name);
  require_writable_folder(folder);
  refuse_foreign_files(folder, pictures);
}

DumpFolder::DumpFolder(const fs::path& folder, bool pictures) : folder_(folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw Error(ExitCode::CannotWrite, one_line(folder.string()) + ": cannot make this folder: " +
                                           (error ? error.message() : "a file is in its place"));
  refuse_foreign_files(folder, pictures);
  for (const auto& [name, bytes] : listed_in(folder))
    if (is_unchanged(folder / name, bytes)) fs::remove(folder / name, error);
  fs::remove(folder / kManifestFile, error);
}

DumpFolder::~DumpFolder() {
  std::error_code error;
  if (finished_) return;
  for (const std::string& name : written_) fs::remove(folder_ / name, error);
}

fs::path DumpFolder::file(const std::string& name) {
  if (std::find(written_.begin(), written_.end(), name) == written_.end()) written_.push_back(name);
  return folder_ / name;
}

void DumpFolder::finish(Json manifest) {
  Json& files = manifest[kFiles] = Json::object();
  for (const std::string& name : written_) {
    std::error_code error;
    if (const auto bytes = fs::file_size(folder_ / name, error); !error) files[name] = bytes;
  }
  write_atomically(folder_ / kManifestFile, json_text(manifest));
  finished_ = true;
}

}  // namespace caustics::app
