#include "app/output/status_colors.hpp"

namespace caustics::app {

NamedColor color_of(LandingStatus status) {
  constexpr NamedColor kEmpty{{0.16, 0.16, 0.16}, "dark grey"};
  switch (status) {
    case LandingStatus::Empty:
      return kEmpty;
    case LandingStatus::Landed:
      return {{0.0, 0.62, 0.45}, "green"};
    case LandingStatus::Missed:
      return {{0.34, 0.71, 0.91}, "sky blue"};
    case LandingStatus::Outside:
      return {{0.0, 0.45, 0.7}, "blue"};
    case LandingStatus::TotalReflection:
      return {{0.94, 0.89, 0.26}, "yellow"};
    case LandingStatus::Absorbed:
      return {{0.0, 0.0, 0.0}, "black"};
    case LandingStatus::NotConverged:
      return {{0.84, 0.37, 0.0}, "vermilion"};
    case LandingStatus::ExitNotFound:
      return {{0.9, 0.62, 0.0}, "orange"};
    case LandingStatus::Stopped:
      return {{0.8, 0.47, 0.65}, "pale purple"};
    case LandingStatus::GivenUp:
      return {{1.0, 1.0, 1.0}, "white"};
  }
  return kEmpty;
}

}  // namespace caustics::app
