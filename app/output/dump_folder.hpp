// The folder of a dump. It belongs to its manifest: what an earlier dump listed there goes, and everything
// else is somebody's own and stays.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pipeline/gpu/run_files.hpp"

namespace caustics::app {

inline constexpr char kManifestFile[] = "manifest.json", kSheetFile[] = "contact_sheet.png",
                      kPageFile[] = "index.html";

// Before anything is drawn: tells the run's list of the folder that `option` names. Throws Error: WrongUsage
// where it clashes with another file of the run or is `-`; CannotWrite where it cannot be written, or has a
// file that a dump would write and that no earlier one did, or that was changed since. `pictures`: is there
// to be a page?
void require_dump_folder(RunFiles& files, const std::filesystem::path& folder, const std::string& option,
                         bool pictures);

class DumpFolder {
 public:
  // Makes the folder, and removes the files that its manifest lists, the manifest last. Throws Error
  // (CannotWrite).
  DumpFolder(const std::filesystem::path& folder, bool pictures);
  DumpFolder(const DumpFolder&) = delete;
  DumpFolder& operator=(const DumpFolder&) = delete;
  // Takes away again what was written, unless finish() came: what no manifest lists would stay for ever.
  ~DumpFolder();

  // Where to write a file of this name.
  std::filesystem::path file(const std::string& name);
  // Writes the manifest, with the member `files` beside its own: the size in bytes of each file, by name. It
  // comes last, so that a folder with one is complete.
  void finish(nlohmann::ordered_json manifest);

 private:
  std::filesystem::path folder_;
  std::vector<std::string> written_;
  bool finished_ = false;
};

}  // namespace caustics::app
