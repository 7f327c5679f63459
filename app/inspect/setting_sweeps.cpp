#include "app/inspect/setting_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/flux.hpp"
#include "app/json.hpp"
#include "app/loaded_scene.hpp"
#include "app/shell/on_demand.hpp"

namespace caustics::app {

namespace {

constexpr int kLongerSide = 320;  // pixels

struct Row {
  const char* setting;
  std::vector<const char*> values;
};

const Row kRows[] = {{"iterations", {"1", "2", "3", "4", "5", "8"}},
                     {"grid", {"32", "64", "128", "256", "512", "1024"}}};

Json sweep(const FrameRequest& request, const std::shared_ptr<LoadedScene>& loaded, const Row& row,
           Blobs& blobs) {
  Json pictures = Json::array(), errors = Json::array();
  FrameRequest small = request;
  const int longer = std::max(small.settings.width, small.settings.height);
  small.settings.width = std::max(1, small.settings.width * kLongerSide / longer);
  small.settings.height = std::max(1, small.settings.height * kLongerSide / longer);
  for (const char* value : row.values) {
    set_option(small.settings, row.setting, value);
    RenderedFrame frame(small, loaded, goal_with_ledgers({"picture"}));
    LedgerReader ledgers;
    frame.run(ledgers.watch(frame));
    const Image picture = frame.read("picture");
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < picture.values.size(); ++i)
      if (picture.channels() < 4 || i % 4 != 3)
        bytes.push_back(static_cast<std::uint8_t>(std::lround(picture.values[i] * 255.0f)));
    pictures.push_back(blobs.add(std::span<const std::uint8_t>(bytes)));
    const ErrorEstimate error = error_of(frame, ledgers.ledgers());
    errors.push_back(error.landed > 0.0 ? Json(error.total()) : Json());
  }
  return {{"setting", row.setting},
          {"values", row.values},
          {"pictures", pictures},
          {"width", small.settings.width},
          {"height", small.settings.height},
          {"error", errors}};
}

}  // namespace

Json setting_sweeps(const FrameRequest& request, const std::shared_ptr<LoadedScene>& loaded, Blobs& blobs) {
  Json sweeps = Json::array();
  FrameRequest software = request;
  software.backend.backend = Backend::Software;
  for (const Row& row : kRows) sweeps.push_back(sweep(software, loaded, row, blobs));
  return sweeps;
}

}  // namespace caustics::app
