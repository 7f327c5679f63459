// What follows rays of light while a test's scene is set up.
#pragma once
#include "passes/registry.hpp"
#include "pipeline/renderer/pilot.hpp"
#include "raster/software_device.hpp"

namespace caustics::test {

inline Pilot pilot() {
  static const std::unique_ptr<Device> device = make_software_device({.threads = 1});
  return {*device, pass_registry()};
}

}  // namespace caustics::test
