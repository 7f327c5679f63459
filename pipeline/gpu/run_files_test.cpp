// Files that a run reads and writes, in a folder of the test's own.
#include "pipeline/gpu/run_files.hpp"

#include <unistd.h>

#include <fstream>

#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
namespace fs = std::filesystem;

namespace {

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("caustics-run-files-" + std::to_string(getpid()))) {
    fs::create_directories(path_ / "below");
    std::ofstream(path_ / "scene.glb") << "scene";
  }
  ~Folder() { fs::remove_all(path_); }
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

template <typename Use>
std::string refusal(const Use& use) {
  try {
    use();
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::WrongUsage);
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("An output may not be an input, by whatever name") {
  const Folder folder;
  fs::create_symlink(folder / "scene.glb", folder / "link.json");
  fs::create_hard_link(folder / "scene.glb", folder / "hard.json");
  fs::create_directory_symlink(folder / "below", folder / "linked");
  for (const char* name :
       {"scene.glb", "below/../scene.glb", "./scene.glb", "link.json", "hard.json", "linked/../scene.glb"}) {
    INFO(name);
    RunFiles files;
    files.reads(folder / "scene.glb", "the scene");
    CHECK(refusal([&] {
            files.writes(folder / name, "--stats");
          }).ends_with(": --stats would replace the scene, which is read; give the output another name"));
    RunFiles later;  // the other way round: the scene's own files are known last
    later.writes(folder / name, "--stats");
    CHECK_FALSE(refusal([&] { later.reads(folder / "scene.glb", "the scene"); }).empty());
  }
  RunFiles files;
  files.reads(folder / "scene.glb", "the scene");
  files.reads(folder / "hard.json", "the mask");
  files.writes(folder / "below/scene.glb", "-o");
}

TEST_CASE("Two outputs may not be one, though neither is there yet") {
  const Folder folder;
  fs::create_symlink(folder / "a.png", folder / "to_a.png");  // leads to nothing yet
  RunFiles files;
  files.writes(folder / "a.png", "-o");
  CHECK(refusal([&] {
          files.writes(folder / "below/../a.png", "--stats");
        }).ends_with(": -o and --stats would both write it; give each output a name of its own"));
  CHECK(refusal([&] { files.writes(folder / "to_a.png", "-o"); }).find("-o names it twice") !=
        std::string::npos);
  files.writes(folder / "b.png", "-o");
  files.writes("-", "-o");
  CHECK(refusal([&] { files.writes("-", "--stats"); }).starts_with("standard output: "));
}

TEST_CASE("A folder's own names are nobody else's") {
  const Folder folder;
  const auto is_own = [](const std::string& name) { return name.ends_with(".exr"); };
  RunFiles files;
  files.writes_in(folder / "below", "--dump", is_own);
  CHECK_FALSE(refusal([&] { files.writes(folder / "below/a.exr", "-o"); }).empty());
  CHECK_FALSE(refusal([&] { files.reads(folder / "below/../below/b.exr", "the truth"); }).empty());
  CHECK_FALSE(refusal([&] { files.writes(folder / "below", "-o"); }).empty());
  files.writes(folder / "below/a.png", "-o");
  files.writes(folder / "a.exr", "-o");
  RunFiles other;
  other.reads(folder / "below/a.exr", "the truth");
  CHECK_FALSE(refusal([&] { other.writes_in(folder / "below/", "--dump", is_own); }).empty());
  CHECK_FALSE(refusal([&] { other.writes_in(folder / "below/a.exr", "--dump", is_own); }).empty());
}

TEST_CASE("A folder that is written into is no output, however it is spelled") {
  const Folder folder;
  fs::create_directories(folder / "below/deeper");
  fs::create_directory_symlink(folder / "below", folder / "linked");
  for (const char* name : {"below", "below/", "below/.", "below/deeper/..", "linked", "linked/."}) {
    INFO(name);
    RunFiles files;
    files.writes_in(folder / "below", "--dump", [](const std::string&) { return false; });
    CHECK_FALSE(refusal([&] { files.writes(folder / name, "-o"); }).empty());
  }
}
