#include "pipeline/settings/presets.hpp"

#include <string>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// The grid and the iterations are those of its figures, the start that of its appendix.
constexpr PresetValue kPaper[] = {
    {"grid", "128"},
    {"iterations", "3"},
    {"estimator", "paper"},
    {"search.start", "0.1"},
    {"thickness", "wyman"},
    {"splat", "point"},
    {"unconverged", "draw"},
    {"weights", "paper"},
    {"pixel_means", "off"},
    {"cascades", "off"},
    {"hidden_receivers", "off"},
    {"highlights", "off"},
    {"ambient.occlusion", "off"},
    {"further.share", "1"},
};

constexpr Preset kPresets[] = {{"paper", "the frame of Shah, Konttinen and Pattanaik (2007)", kPaper}};

constexpr PresetValue kQuick[] = {
    {"width", "640"},
    {"height", "360"},
    {"samples", "1"},
    {"grid", "192"},
    {"map", "256"},
    {"shadow", "512"},
    {"further.share", "1"},
    {"cascades", "off"},
    {"hidden_receivers", "off"},
    {"light.samples", "4"},
    {"shafts", "48"},
    {"medium.steps", "16"},
    {"ambient.occlusion", "off"},
};

constexpr Preset kPreview{"preview", "a quick look", kQuick};

}  // namespace

const Preset& preview() { return kPreview; }

void apply(Settings& settings, const Preset& preset) {
  for (const PresetValue& each : preset.values) set_option(settings, each.setting, each.value);
}

std::span<const Preset> all_presets() { return kPresets; }

void apply_preset(Settings& settings, std::string_view name) {
  std::string names;
  for (const Preset& preset : kPresets) {
    names += (names.empty() ? "'" : ", '") + std::string(preset.name) + "'";
    if (preset.name != name) continue;
    return apply(settings, preset);
  }
  throw Error(ExitCode::WrongUsage,
              "there is no preset " + in_quotes(std::string(name)) + "; there is " + names);
}

}  // namespace caustics
