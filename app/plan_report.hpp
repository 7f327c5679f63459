// What `plan` prints, for people and for programs.
#pragma once
#include <string>
#include <vector>

#include "app/flux.hpp"

namespace caustics::app {

struct PlanReport {
  const LoadedScene& loaded;
  const Effects& effects;
  const Settings& settings;
  const FramePlan& plan;
  MemoryJudgement memory;            // of a PNG picture
  double seconds = 0.0;              // of all processors, that it will take
  std::vector<std::string> idle;     // idle_settings
  std::vector<LightLedger> ledgers;  // of a coarse run; empty where nothing throws a caustic

  // As far as a coarse run tells: does the pass draw nothing, since its light reaches no caster?
  bool draws_nothing(const PlannedPass& pass) const;
  std::size_t passes_that_draw_nothing() const;
  // Of the scene, then of settings.
  std::vector<std::string> notes() const;
};

std::string plan_text(const PlanReport& report, bool colour);
std::string plan_json(const PlanReport& report);

const char* name_of(LightType type);

}  // namespace caustics::app
