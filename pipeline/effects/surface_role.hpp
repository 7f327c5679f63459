// What one surface does to light, judged from its material, its mesh and the settings (effects.cpp
// puts the judgements of a scene together).
#pragma once
#include <string>

#include "pipeline/effects/effects.hpp"

namespace caustics {

// A surface's role, and for one that people expect a caustic from why it throws none.
struct Judgement {
  SurfaceRole role;
  bool looks_specular = false;  // transmissive, a mirror, or alpha-blended as if it were glass
  std::string no_caustic;       // short reason; empty for a caster
};

Judgement judge(const Mesh& mesh, const Material& material, const Settings& settings);

// Three significant digits, or as many as asked for, at least one decimal, the same in every locale: "1.0",
// "1.33", "0.05".
std::string rounded_text(double value, int digits = 3);

// "material 'glass'", or "material 3" where it has no name.
std::string quoted_name(const std::string& kind, const std::string& name, std::size_t index);

}  // namespace caustics
