#include "app/frame_memory.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "app/flux.hpp"
#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/scene/scene.hpp"
#include "pipeline/scene/triangle_tree.hpp"
#include "pipeline/settings/settings.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

// Measured, in bytes: the program and its libraries.
constexpr std::uint64_t kProgram = 20'000'000;

// The device and images hold floats whatever the format.
template <class TextureOrMemory>
std::uint64_t float_bytes(const TextureOrMemory& texture) {
  return static_cast<std::uint64_t>(texture.width) * static_cast<std::uint64_t>(texture.height) *
         static_cast<std::uint64_t>(channel_count(texture.format)) * sizeof(float);
}

// Meshes, here and on the device, and images, which the software device reads here.
std::uint64_t scene_bytes(const Scene& scene) {
  std::uint64_t sum = 0, densities = 0, texels = 0;
  for (const Mesh& mesh : scene.meshes) {
    sum += mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * sizeof(std::uint32_t);
    densities += mesh.vertices.size() * sizeof(glm::vec2);
  }
  for (const auto* images : {&scene.images, &scene.coarser})
    for (const Image& image : *images) texels += image.values.size() * sizeof(float);
  return 2 * sum + densities + texels;
}

// Of the trees of casters and receivers, which rays for the model's error are followed through.
std::uint64_t tree_bytes(const Scene& scene) {
  std::uint64_t indices = 0;
  for (const Mesh& mesh : scene.meshes) indices += mesh.indices.size();
  return TriangleTree::building_bytes(indices / 3);
}

// The largest of the pass's draws and those that are sorted into tiles with it, beside textures.
std::uint64_t drawing_bytes(const PlannedPass& pass, const Scene& scene, const Settings& settings) {
  const auto points = [&](std::uint64_t count) { return draw_bytes(*pass.definition, 0, count); };
  const auto grid = static_cast<std::uint64_t>(settings.grid);
  const auto beams = static_cast<std::uint64_t>(beams_a_side(settings));
  switch (pass_registry()[static_cast<std::size_t>(pass.pass)].draws) {
    case DrawSet::FullScreen:
      return 0;
    case DrawSet::GridVertices:
    case DrawSet::GridCells:
      return points(grid * grid);
    case DrawSet::GridColumns:
      return points(grid);
    case DrawSet::Beams:
      return draw_bytes(*pass.definition, 0, 2 * beams * beams);
    case DrawSet::Receivers:
    case DrawSet::Casters:
    case DrawSet::SolidCasters:
    case DrawSet::ThinPanes:
    case DrawSet::LightTinters:
      break;
  }
  std::uint64_t largest = 0, all = 0;
  for (const Mesh& mesh : scene.meshes) {
    const std::uint64_t draw = draw_bytes(*pass.definition, mesh.vertices.size(), mesh.indices.size() / 3);
    largest = std::max(largest, draw);
    all += draw;
  }
  return std::min<std::uint64_t>(all, largest + kMostKeptOfDraws);
}

// Of the light that a pass ends, beside its textures, which are looked at where they lie: where the farthest
// receivers are searched, its landings merged; and the error estimate's planes of one double a texel for each
// map that shading looks up: its own, what is coarser (a quarter), and their difference.
std::uint64_t ledger_bytes(const FramePlan& plan, int light) {
  static const std::vector<std::string> looked_at = ledger_textures();
  std::uint64_t images = 0, quarter_planes = 0, texels = 0;
  for (const PlannedTexture& texture : plan.textures) {
    const std::string name = texture.name.substr(0, texture.name.find('['));
    if (texture.light != light || !texture.kept_for_light ||
        std::find(looked_at.begin(), looked_at.end(), name) == looked_at.end())
      continue;
    if (name.ends_with(".far") && name != far_texture(kCausticMap)) images += float_bytes(texture);
    if (name == kCausticMap || name == kCascadeMap) quarter_planes += 9;
    if (name == kCausticMap)
      texels = static_cast<std::uint64_t>(texture.width) * static_cast<std::uint64_t>(texture.height);
  }
  return images + quarter_planes * texels / 4 * sizeof(double);
}

// The memory of the machine, or of the container that the process runs in.
std::uint64_t machine_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  std::uint64_t bytes = std::uint64_t{8} << 30;
  if (pages > 0 && size > 0) {
    bytes = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size);
  }
  for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::uint64_t limit = 0;
    if (std::ifstream(file) >> limit) bytes = std::min(bytes, limit);
  }
  return bytes;
}

}  // namespace

std::uint64_t memory_needed(const FramePlan& plan, const Scene& scene, const Settings& settings) {
  std::uint64_t held = kProgram + scene_bytes(scene), most = held, largest_kept = 0, drawing = 0;
  std::vector<bool> drawn_into(plan.memory.size());
  for (const PlannedPass& pass : plan.passes) {
    for (const int index : pass.attachments()) {
      // A texture takes no memory before the first pass that draws into it.
      const PlannedTexture& texture = plan.textures[static_cast<std::size_t>(index)];
      const auto memory = static_cast<std::size_t>(texture.memory);
      if (texture.memory >= 0 && !drawn_into[memory]) held += float_bytes(plan.memory[memory]);
      if (texture.memory >= 0) drawn_into[memory] = true;
      if (texture.kept) largest_kept = std::max(largest_kept, float_bytes(texture));
    }
    const std::uint64_t draw = drawing_bytes(pass, scene, settings);
    most = std::max(most, held + draw);
    drawing = std::max(drawing, std::min<std::uint64_t>(draw, kMostKeptOfDraws));
    const std::uint64_t ledger = pass.ends_light ? ledger_bytes(plan, pass.light) : 0;
    if (ledger == 0) continue;
    most = std::max(most, held + drawing + ledger);
  }
  return std::max({most, held + largest_kept, held + drawing + tree_bytes(scene)});
}

void check_memory(std::uint64_t needed, const std::string& advice) {
  const std::uint64_t allowed = machine_memory() / 4 * 3;
  if (needed <= allowed) return;
  throw Error(ExitCode::WrongUsage,
              "these sizes need " + bytes_text(static_cast<double>(needed)) + " of memory, more than the " +
                  bytes_text(static_cast<double>(allowed)) + " that this machine can spare; lower " + advice);
}

}  // namespace caustics::app
