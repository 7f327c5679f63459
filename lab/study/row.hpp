// What a study knows of one setting on one backend.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lab/study/sweep.hpp"
#include "lab/study/times.hpp"

namespace caustics::study {

// A pass, all of its runs in a frame together (one for each light, sample and branch).
struct PassTime {
  std::string name;
  int runs = 0;          // a frame
  bool caustic = false;  // a caustic map depends on it
  double median = 0.0;   // milliseconds a frame
};

// Against the truth; a figure that does not exist is none (lab/metrics/image_metrics.hpp).
struct Figures {
  std::optional<double> relative_l1{}, rmse{}, flux_ratio{}, flip_mean{};
  std::optional<double> relative_mse_1{}, relative_mse_4{}, relative_mse_16{};
};

struct StudyRow {
  Point point{};
  std::string backend;                // "software", "gl"
  std::string device{};               // as it describes itself
  nlohmann::ordered_json settings{};  // all of them, as --stats writes them
  int repeat = 0;                     // frames timed
  std::string problem{};              // why there are no figures: one line, else ""
  Figures figures{};
  Times frame{}, caustic{};
  std::uint64_t texture_bytes = 0;
  std::vector<PassTime> passes{};  // in the order in which they first ran
  std::string picture{};           // "img/grid256_map128.png", beside the page; "" for none
  // Found when all rows are there.
  bool on_front = false;           // of its backend
  bool reference_limited = false;  // the truth's own noise is more than a third of relative_l1
};

}  // namespace caustics::study
