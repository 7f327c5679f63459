// The waves of one water surface, computed on a device: two textures of heights that take turns.
#pragma once
#include <array>

#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/owned.hpp"
#include "pipeline/plan/pass.hpp"

namespace caustics {

// The pass that makes a water's steps (Each::Water). Throws Error (InternalError) where the registry has
// none.
const Pass& water_pass(const Registry& registry);

// The state is a function of the water's settings and the moment alone: whatever was computed before, the
// same bits come out. Both devices compute the same.
class WaterSimulation {
 public:
  // At rest, before the first step. `water`, `device` and `pass` must outlive it.
  WaterSimulation(const Water& water, Device& device, const Pass& pass);
  WaterSimulation(const WaterSimulation&) = delete;
  WaterSimulation& operator=(const WaterSimulation&) = delete;

  // Makes the steps up to the first that reaches this moment of the scene; from rest again where the moment
  // lies before what was reached.
  void advance_to(double seconds);
  // Makes one step. Its counters are added to `work`.
  void make_step();

  std::int64_t steps() const { return steps_; }  // made from rest on
  // RG32F, (height m, rate m/s): after the last step, and before it.
  Image state() const { return device_.read_back(textures_[current_].id()); }
  Image before() const { return device_.read_back(textures_[1 - current_].id()); }
  // Puts a state in the place of the present one, for tests of the scheme.
  void set_state(const Image& state);
  // What all steps since it was made have cost.
  const PassResult& work() const { return work_; }

 private:
  void rest();

  const Water& water_;
  Device& device_;
  const Pass& pass_;
  const PassDefinition definition_;
  std::array<OwnedTexture, 2> textures_{};
  std::size_t current_ = 0;
  std::int64_t steps_ = 0;
  PassResult work_;
};

}  // namespace caustics
