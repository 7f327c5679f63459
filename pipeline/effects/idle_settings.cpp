#include "pipeline/effects/idle_settings.hpp"

#include <algorithm>

#include "pipeline/settings/setting.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

struct Frame {
  const Scene& scene;
  const Settings& settings;
  const Effects& effects;
};

// Each says why the settings of its row change nothing, or "" where they do.
std::string no_further_surfaces(const Frame& frame) {
  const Effect& further = frame.effects.further_surfaces;
  if (further.active) return {};
  return further.reason.empty() ? "all light goes through two surfaces" : further.reason;
}

// Of the share that decides: what no pilot has measured is not decided by it.
std::string no_share(const Frame& frame) {
  return frame.effects.further_shares.empty() ? no_further_surfaces(frame) : "";
}

std::string no_caustic(const Frame& frame) {
  return frame.effects.caustics.active ? "" : "nothing throws a caustic";
}

std::string no_medium(const Frame& frame) {
  return frame.effects.scattering.active ? "" : "no haze scatters light towards the camera";
}

std::string no_shafts(const Frame& frame) {
  return frame.effects.light_shafts.active ? "" : "no haze shows the light of a caustic";
}

std::string no_samples(const Frame& frame) {
  const auto& sources = frame.scene.sources;
  const bool sized = std::any_of(sources.begin(), sources.end(),
                                 [](const Light& light) { return light.shape != LightShape::None; });
  return sized || frame.effects.emissive_lights.active ? "" : "no light has a size";
}

std::string no_dispersion(const Frame& frame) {
  if (frame.settings.wavelengths == 1 || frame.effects.dispersion.active) return {};
  return "no glass that throws a caustic disperses light (KHR_materials_dispersion)";
}

std::string no_search(const Frame& frame) {
  const Estimator estimator = frame.settings.estimator;
  return estimator == Estimator::Paper || estimator == Estimator::Newton
             ? ""
             : "the estimators paper and newton read it";
}

std::string no_newton(const Frame& frame) {
  return frame.settings.estimator == Estimator::Newton ? "" : "the estimator newton alone reads it";
}

struct Row {
  std::string_view setting;
  std::string (*why)(const Frame& frame);
};

constexpr Row kRows[] = {{"further.share", no_share},
                         {"bounces", no_further_surfaces},
                         {"splits", no_further_surfaces},
                         {"drawn", no_further_surfaces},
                         {"least_share", no_further_surfaces},
                         {"grid", no_caustic},
                         {"map", no_caustic},
                         {"iterations", no_caustic},
                         {"estimator", no_caustic},
                         {"splat", no_caustic},
                         {"splat.sigma", no_caustic},
                         {"weights", no_caustic},
                         {"thickness", no_caustic},
                         {"cascades", no_caustic},
                         {"outside_share", no_caustic},
                         {"reflections", no_caustic},
                         {"medium.steps", no_medium},
                         {"shafts", no_shafts},
                         {"light.samples", no_samples},
                         {"wavelengths", no_dispersion},
                         {"search.start", no_search},
                         {"newton.epsilon", no_newton},
                         {"newton.guard", no_newton}};

}  // namespace

std::vector<std::string> idle_settings(const std::vector<std::string>& given, const Scene& scene,
                                       const Settings& settings, const Effects& effects) {
  std::vector<std::string> sentences;
  for (const Row& row : kRows) {
    if (std::find(given.begin(), given.end(), row.setting) == given.end()) continue;
    const std::string why = row.why({scene, settings, effects});
    if (why.empty()) continue;
    const Setting& known = setting(row.setting);
    sentences.push_back(std::string(row.setting) + "=" + known.get(settings) +
                        " changes nothing here: " + why + ".");
  }
  return sentences;
}

}  // namespace caustics
