// What each effect of a scene brings: the study's rows with and without it, side by side.
#pragma once
#include <string>
#include <vector>

#include "lab/study/study.hpp"

namespace caustics::study {

struct EffectRow {
  std::string effect, backend;
  const StudyRow* with = nullptr;  // everything that the scene calls for
  const StudyRow* without = nullptr;
};

// Of a study whose knob is kWithout, those that brought most first; none of another study. Rows that were not
// measured are left out. They point into the study.
std::vector<EffectRow> effect_rows(const Study& study);

nlohmann::ordered_json effects_json(const Study& study);
std::string effects_csv(const Study& study);

}  // namespace caustics::study
