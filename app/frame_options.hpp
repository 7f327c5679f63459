// The options by which every sub-command that renders says what it renders.
#pragma once
#include <filesystem>
#include <optional>

#include "app/backend.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

struct FrameRequest {
  std::filesystem::path scene;
  std::optional<std::filesystem::path> environment;
  std::string animation;          // --animation; "": the first
  std::optional<double> seconds;  // --time; 0 where it was not given
  Settings settings;
  BackendRequest backend;
};

// -r, --camera, --grid and so on, and -D; they write into `request`, which must outlive the parser.
// `several`, `thread_counts`: see add_backend_options.
void add_frame_options(Parser& parser, FrameRequest& request, std::vector<Backend>* several = nullptr,
                       std::vector<int>* thread_counts = nullptr);

// --animation and --time alone.
void add_moment_options(Parser& parser, FrameRequest& request);

// Throws Error (WrongUsage) when no scene was named or a size is beyond its limits.
void check_request(const FrameRequest& request, const std::string& command);

}  // namespace caustics::app
