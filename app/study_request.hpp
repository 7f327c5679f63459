// What `caustics study` was asked for, and the knobs that this means.
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/frame_options.hpp"
#include "app/shell/parser.hpp"
#include "app/study_trace.hpp"
#include "lab/study/sweep.hpp"

namespace caustics::app {

inline constexpr std::size_t kMostRuns = 1000;
// Beside img/ and what is traced.
inline constexpr const char* kStudyFiles[] = {"study.json", "study.csv", "effects.csv", "report.html",
                                              "error_time.svg"};

struct StudyRequest {
  FrameRequest frame;
  std::vector<Backend> backends;                            // empty: frame.backend's
  std::vector<std::pair<std::string, std::string>> varied;  // key, "a,b,c"
  std::filesystem::path folder = "study";
  std::filesystem::path truth;  // "": the finest setting, or `traced`
  TracedTruth traced;
  bool says_how_long = false;  // --truth-error, --truth-seconds
  std::filesystem::path mask;  // "": everything counts
  int repeat = 5;
  bool effects = false, cross = false, resume = false, quiet = false;
  std::string command;  // as it was typed
};

// False when only the help was asked for. Throws Error (WrongUsage).
bool parse_study(const Arguments& arguments, StudyRequest& request);

// With --effects, whether each effect that the scene calls for is left out; else those of --vary, the values
// checked and written as the program writes them, each once. Throws Error (WrongUsage) that
// names the nearest key or value.
std::vector<study::Knob> knobs_of(const StudyRequest& request);

std::string name_of(Backend backend);

}  // namespace caustics::app
