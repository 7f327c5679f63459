// On what rays of light are followed before a frame is planned.
#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

class Device;

// The software device, whatever device draws, so that every device draws the same frames. Both must outlive
// what is made from it.
struct Pilot {
  Device& device;
  const Registry& registry;
};

}  // namespace caustics
