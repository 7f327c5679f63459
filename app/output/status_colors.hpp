// The colours of what becomes of light, in pictures: those of Okabe and Ito ("Color universal design", 2008),
// which people tell apart whatever their eyes do.
#pragma once
#include <string_view>

#include "app/output/color_scale.hpp"
#include "pipeline/measure/ledger.hpp"

namespace caustics::app {

struct NamedColor {
  Color color;
  std::string_view name;
};
NamedColor color_of(LandingStatus status);

}  // namespace caustics::app
