#include "app/sample_scenes.hpp"

#include <algorithm>
#include <filesystem>

#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> scenes_in(const fs::path& folder) {
  std::vector<std::string> scenes;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".glb" || extension == ".gltf") scenes.push_back(entry.path().string());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

}  // namespace

std::vector<std::string> sample_scenes() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  fs::path folder = program.parent_path();
  // A build folder lies at most a few levels below the sources.
  for (int level = 0; level < 5 && !folder.empty(); ++level, folder = folder.parent_path()) {
    for (const char* place : {"scenes", "share/caustics/scenes"}) {
      std::vector<std::string> scenes = scenes_in(folder / place);
      if (!scenes.empty()) return scenes;
    }
    if (folder == folder.parent_path()) break;
  }
  throw Error(ExitCode::BadInput, "no sample scenes lie near the program; name a scene");
}

}  // namespace caustics::app
