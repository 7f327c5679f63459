// The memory that a frame takes, told before its textures exist, and whether it may be drawn.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "pipeline/gpu/process_memory.hpp"
#include "pipeline/plan/pass.hpp"

namespace caustics {

struct Effects;
struct FramePlan;
struct PassDefinition;
struct Scene;
struct Settings;

// What a device takes beside textures and meshes.
struct DeviceMemory {
  // For a draw of so many vertices of a mesh, or none, and so many primitives, in bytes.
  std::function<std::size_t(const PassDefinition& definition, std::size_t vertices, std::size_t primitives)>
      draw;
  std::size_t kept = 0;       // bytes of draws that it keeps for the next pass at the most
  std::uint64_t driver = 0;   // bytes of its driver that the process has not taken when the frame is planned
  bool copies_looks = false;  // Device::look_at gives a copy
};

struct FrameCost {
  const FramePlan& plan;
  const Registry& registry;
  const Scene& scene;
  const Effects& effects;
  const Settings& settings;
  DeviceMemory device;
  // What the process has taken when the frame is planned: libraries, scene, meshes on the device, the pilot's
  // and the loader's work, the plan itself.
  ResidentMemory taken;
  std::uint64_t outputs = 0;  // bytes that writing what is wanted takes beside the textures
};

// What the process occupies at its most when the frame is drawn, its ledgers are made and its files written,
// in bytes: what it has taken, and what the plan adds to that. Textures count as if they lay in the process,
// as the software device's do and those of OpenGL drivers without a GPU.
std::uint64_t memory_needed(const FrameCost& cost);

// Why sizes that need so much are refused, a sentence without a full stop that says what to do; empty: they
// are not. `lower`: the options that make it less.
std::string memory_refusal(std::uint64_t needed, const MemoryBudget& budget, const std::string& lower);

}  // namespace caustics
