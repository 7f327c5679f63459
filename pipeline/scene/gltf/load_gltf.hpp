// Reads a glTF 2.0 file (.gltf or .glb, told apart by content) into a Scene.
//
// The file is not trusted: every number in it is checked before it is used, and nothing is
// allocated on its word. What cannot be a scene throws Error(ExitCode::BadInput) with one line that
// says file, JSON path (such as `materials[2].extensions.KHR_materials_ior.ior`), what is wrong and
// what to do. What can be a scene but not all of it becomes a Scene whose `notes` say what was
// assumed or left out. Source: glTF 2.0 specification and the Khronos extensions named in
// gltf/check.cpp.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/gpu/process_memory.hpp"
#include "pipeline/scene/animated_scene.hpp"

namespace caustics {

// Limits on what a file may ask for. Beyond one of them the file is refused, images apart: those
// are left out with a note.
struct LoadOptions {
  std::uint64_t max_bytes = std::uint64_t{512} << 20;  // the file and its buffers and images together
  std::uint64_t max_json_values = 4'000'000;
  int max_json_depth = 128;
  int max_node_depth = 128;
  std::uint64_t max_nodes = 1'000'000;        // nodes and instances visited, and primitives placed
  std::uint64_t max_lights = 1024;            // each has maps and passes of its own
  std::uint64_t max_lit_meshes = 16'000'000;  // lights times placed meshes: each pair is judged by itself
  std::uint64_t max_vertices = 50'000'000;    // after instancing
  std::uint64_t max_triangles = 50'000'000;
  double max_coordinate = 1e12;                     // metres; beyond it, products overflow single precision
  std::uint64_t max_animation_values = 32'000'000;  // moments and what they hold, of one animation
  std::uint64_t max_water_cells = std::uint64_t{32} << 20;  // of all waters together
  double max_water_updates = 1e11;  // cells times the steps that they make before time 0, of all waters
  // The animation to show: its name or else its number; "" the first, "none" the scene at rest.
  std::string animation;
  // The file's bytes where they do not lie under its path, which then only names them. Such a file can refer
  // to no other.
  std::shared_ptr<const std::vector<std::uint8_t>> content = nullptr;
  int max_image_side = 16384;  // pixels
  // Of all images together, each counted once for each way of reading it (colour, data, normals). Where they
  // are more, the largest are halved, with a note, until they fit.
  std::uint64_t max_image_pixels = std::uint64_t{128} << 20;
  // What the process may take while it loads. What needs more is refused before it is taken, with
  // Error(ExitCode::WrongUsage). None: nothing is.
  std::optional<MemoryBudget> memory{};
};

// The scene at 0 s of its animation.
Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options = {});

// The scene at any moment: docs/animation.md says what moves. An unknown LoadOptions::animation
// throws Error(ExitCode::WrongUsage).
AnimatedScene load_animated(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace caustics
