// The options by which every sub-command that renders says what it renders.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/backend.hpp"
#include "pipeline/gpu/process_memory.hpp"
#include "pipeline/gpu/run_files.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

struct FrameRequest {
  std::filesystem::path scene;
  std::optional<std::filesystem::path> environment;
  std::string animation;          // --animation; "": the first
  std::optional<double> seconds;  // --time; 0 where it was not given
  bool preview = false;           // --preview, which `settings` have
  Settings settings;
  std::vector<std::string>
      given;  // the names of those that were given one by one, not by --preview or --preset
  BackendRequest backend;
  RunFiles files;  // that the run reads and writes; the scene's own are added as it is loaded
  std::optional<std::uint64_t> memory{};  // --memory, bytes

  MemoryBudget budget() const { return memory_budget(memory); }
};

// -r, --camera, --grid and so on, and -D; they write into `request`, which must outlive the parser.
// `several`, `thread_counts`: see add_backend_options.
void add_frame_options(Parser& parser, FrameRequest& request, std::vector<Backend>* several = nullptr,
                       std::vector<int>* thread_counts = nullptr);

// --memory alone.
void add_memory_option(Parser& parser, FrameRequest& request);

// --animation and --time alone.
void add_moment_options(Parser& parser, FrameRequest& request);

// Samples a pixel of pictures to look at, where nothing is said.
inline constexpr int kShownSamples = 4;

// The help's words for SCENE.
inline constexpr char kSceneMeaning[] = "a glTF 2.0 file, .gltf or .glb; - reads one from standard input";
inline bool is_standard_input(const std::filesystem::path& scene) { return scene == "-"; }
// What outputs without a name of their own are named after: "glass" of "scenes/glass.glb".
std::string name_of_scene(const FrameRequest& request);

// Throws Error (WrongUsage) when no scene was named or a size is beyond its limits. Reads standard input, if
// it is the scene. Tells request.files of the files that are read.
void check_request(FrameRequest& request, const std::string& command);

// Throws Error (WrongUsage) when a command that looks at the pixels' middles alone is asked for more samples.
void require_one_sample(const Settings& settings, const std::string& command);

}  // namespace caustics::app
