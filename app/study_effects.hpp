// `study --effects`: how each effect that a scene calls for is left out.
#pragma once
#include <string>
#include <vector>

#include "app/frame_options.hpp"
#include "pipeline/effects/effects.hpp"

namespace caustics::app {

// An effect on caustics, and what leaving it out changes: settings, the loaded scene, or nothing but the
// effect itself.
struct Omission {
  const char* name;
  bool (*called_for)(const Scene&, const Effects&, const Settings&);
  void (*settings)(Settings&) = nullptr;
  void (*scene)(Scene&, const Effects&) = nullptr;
  Effect Effects::*effect = nullptr;
};

// Those that the scene calls for with these settings.
std::vector<std::string> omissions_for(const FrameRequest& request);
// By its name.
const Omission& omission(const std::string& name);

}  // namespace caustics::app
