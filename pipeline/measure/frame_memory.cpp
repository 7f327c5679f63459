#include "pipeline/measure/frame_memory.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/effects/textured_casters.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/measure/landing_images.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/hierarchy_tables.hpp"
#include "pipeline/scene/scene.hpp"
#include "pipeline/scene/triangle_tree.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// The device and images hold floats whatever the format.
template <class TextureOrMemory>
std::uint64_t float_bytes(const TextureOrMemory& texture) {
  return static_cast<std::uint64_t>(texture.width) * static_cast<std::uint64_t>(texture.height) *
         static_cast<std::uint64_t>(channel_count(texture.format)) * sizeof(float);
}

// The tree of casters, which tells what the camera sees of where rays for the model's error land.
std::uint64_t tree_bytes(const Scene& scene) {
  std::uint64_t indices = 0;
  for (const Mesh& mesh : scene.meshes) indices += mesh.indices.size();
  return TriangleTree::building_bytes(indices / 3);
}

// The hierarchy that passes walk: what its tables take (hierarchy_tables.hpp: seven texels a triangle, where
// a leaf has four; and five where casters have textures; two a point of a lamp), and what making them takes
// beside.
struct HierarchyBytes {
  std::uint64_t held = 0, making = 0;
};

HierarchyBytes hierarchy_bytes(const FrameCost& cost) {
  const auto walks = [&](const PlannedPass& pass) {
    const std::vector<Read>& reads = cost.registry[static_cast<std::size_t>(pass.pass)].reads;
    return std::any_of(reads.begin(), reads.end(), [](const Read& r) { return r.name == kHierarchyNodes; });
  };
  if (std::none_of(cost.plan.passes.begin(), cost.plan.passes.end(), walks)) return {};
  std::uint64_t indices = 0;
  for (const Mesh& mesh : cost.scene.meshes) indices += mesh.indices.size();
  const std::uint64_t texels =
      light_meets_textures(cost.effects) || sight_meets_textures(cost.effects) ? 7 + kTexelsOfUv : 7;
  const std::uint64_t points = 2 * std::uint64_t{kPointsOfLamp} * lamps_of_points(cost.scene).size();
  return {(indices / 3 * texels + points) * sizeof(glm::vec4), TriangleTree::building_bytes(indices / 3)};
}

// The largest of the pass's draws and those that are sorted into tiles with it, beside textures.
std::uint64_t drawing_bytes(const PlannedPass& pass, const FrameCost& cost) {
  const auto points = [&](std::uint64_t count) { return cost.device.draw(*pass.definition, 0, count); };
  const auto grid = static_cast<std::uint64_t>(cost.settings.grid);
  const auto beams = static_cast<std::uint64_t>(beams_a_side(cost.settings));
  const DrawSet draws = cost.registry[static_cast<std::size_t>(pass.pass)].draws;
  switch (draws) {
    case DrawSet::FullScreen:
      return 0;
    case DrawSet::GridVertices:
    case DrawSet::GridCells:
      return points(grid * grid);
    case DrawSet::GridColumns:
      return points(grid);
    case DrawSet::Beams:
      return points(2 * beams * beams);
    case DrawSet::Receivers:
    case DrawSet::Casters:
    case DrawSet::Shadowing:
    case DrawSet::SolidCasters:
    case DrawSet::LightTinters:
      break;
  }
  // Triangles between the pixels' middles are dropped before they take memory: a surface and its back leave
  // no more than these.
  const std::uint64_t seen =
      std::uint64_t{4} * static_cast<std::uint64_t>(pass.width) * static_cast<std::uint64_t>(pass.height);
  std::uint64_t largest = 0, all = 0;
  const LightEffects* light =
      pass.light >= 0 ? &cost.effects.lights[static_cast<std::size_t>(pass.light)] : nullptr;
  for (std::size_t i = 0; i < cost.scene.meshes.size(); ++i) {
    if (!draws_mesh(draws, *pass.drawn_for, cost.effects, i, light)) continue;
    const Mesh& mesh = cost.scene.meshes[i];
    const std::uint64_t draw = cost.device.draw(*pass.definition, mesh.vertices.size(),
                                                std::min<std::uint64_t>(mesh.indices.size() / 3, seen));
    largest = std::max(largest, draw);
    all += draw;
  }
  const std::uint64_t waiting = std::min<std::uint64_t>(all, largest + cost.device.kept);
  // The pilot has drawn the meshes: what the device keeps of that has been taken.
  return waiting > cost.device.kept ? waiting : 0;
}

// Whether a light's ledger looks at a texture, and the texture's name without the light's.
std::optional<std::string> name_in_ledger(const PlannedTexture& texture) {
  static const std::vector<std::string> looked_at = ledger_textures();
  if (texture.light < 0 || !texture.kept_for_light) return std::nullopt;
  std::string name = texture.name.substr(0, texture.name.find('['));
  if (std::find(looked_at.begin(), looked_at.end(), name) == looked_at.end()) return std::nullopt;
  return name;
}

// Bytes of each light's ledger that are copies of textures, on a device that copies what is looked at: the
// maps, all that one branch has, and of each branch what rays are compared with (ModelError).
std::vector<std::uint64_t> copied_bytes(const FramePlan& plan, std::size_t lights) {
  struct Copies {
    std::uint64_t maps = 0, compared = 0;
    std::map<int, std::uint64_t> branches;
  };
  std::vector<Copies> copies(lights);
  for (const PlannedPass& pass : plan.passes) {
    for (const int index : pass.attachments()) {
      const PlannedTexture& texture = plan.textures[static_cast<std::size_t>(index)];
      const std::optional<std::string> name = name_in_ledger(texture);
      if (!name) continue;
      Copies& of_light = copies[static_cast<std::size_t>(texture.light)];
      (pass.branch < 0 ? of_light.maps : of_light.branches[pass.branch]) += float_bytes(texture);
      if (*name == kLanding || *name == kLandingFlux || *name == kLandingFresnel)
        of_light.compared += float_bytes(texture);
    }
  }
  std::vector<std::uint64_t> bytes;
  for (const auto& [maps, compared, branches] : copies) {
    std::uint64_t branch = 0;
    for (const auto& [_, of_branch] : branches) branch = std::max(branch, of_branch);
    bytes.push_back(maps + compared + branch);
  }
  return bytes;
}

// The bytes that each light's ledger takes when its last pass has run, where textures are looked at where
// they lie: its landings merged, where the farthest receivers are searched; what counts the splats in a texel
// (SplatCounts); and the error estimate's planes of one double a texel for each map that shading looks up:
// what the grid has wrong, the map itself, what is coarser (a quarter), and the difference.
std::vector<std::uint64_t> ledgers_bytes(const FramePlan& plan, std::size_t lights) {
  struct Books {
    std::uint64_t images = 0, quarter_planes = 0, texels = 0;
  };
  std::vector<Books> books(lights);
  for (const PlannedTexture& texture : plan.textures) {
    const std::optional<std::string> name = name_in_ledger(texture);
    if (!name) continue;
    auto& [images, quarter_planes, texels] = books[static_cast<std::size_t>(texture.light)];
    if (name->ends_with(".far") && *name != far_texture(kCausticMap)) images += float_bytes(texture);
    if (*name == kCausticMap || *name == kCascadeMap) quarter_planes += 13;
    if (*name == kCausticMap)
      texels = static_cast<std::uint64_t>(texture.width) * static_cast<std::uint64_t>(texture.height);
  }
  std::vector<std::uint64_t> bytes;
  bytes.reserve(lights);
  for (const auto& [images, quarter_planes, texels] : books)
    bytes.push_back(images + texels * sizeof(std::int32_t) + quarter_planes * texels / 4 * sizeof(double));
  return bytes;
}

// Of the textures of a branch's rays the software device touches no page where no caster is: of the window
// around a ball that covers pi / 4, and pages at its edge are whole.
std::uint64_t touched_bytes(const PlannedPass& pass, const TextureMemory& memory,
                            const DeviceMemory& device) {
  constexpr double kCovered = 0.9;
  const std::uint64_t whole = float_bytes(memory);
  if (device.copies_looks || pass.branch < 0) return whole;
  return static_cast<std::uint64_t>(kCovered * static_cast<double>(whole));
}

}  // namespace

std::uint64_t memory_needed(const FrameCost& cost) {
  const FramePlan& plan = cost.plan;
  std::uint64_t held = cost.taken.now + cost.device.driver, most = std::max(held, cost.taken.peak),
                drawing = 0;
  std::vector<std::uint64_t> ledgers = ledgers_bytes(plan, cost.scene.lights.size());
  if (cost.device.copies_looks) {
    const std::vector<std::uint64_t> copies = copied_bytes(plan, cost.scene.lights.size());
    for (std::size_t i = 0; i < ledgers.size(); ++i) ledgers[i] += copies[i];
  }
  std::vector<bool> drawn_into(plan.memory.size());
  // A pilot on the same device has made it: it has been taken.
  const bool made = !cost.device.copies_looks && !cost.effects.further_shares.empty();
  const HierarchyBytes hierarchy = made ? HierarchyBytes{} : hierarchy_bytes(cost);
  most = std::max(most, held + hierarchy.held + hierarchy.making);
  held += hierarchy.held;
  for (const PlannedPass& pass : plan.passes) {
    for (const int index : pass.attachments()) {
      // A texture takes no memory before the first pass that draws into it.
      const auto memory = static_cast<std::size_t>(plan.textures[static_cast<std::size_t>(index)].memory);
      if (memory >= plan.memory.size() || drawn_into[memory]) continue;
      held += touched_bytes(pass, plan.memory[memory], cost.device);
      drawn_into[memory] = true;
    }
    const std::uint64_t draw = drawing_bytes(pass, cost);
    most = std::max(most, held + draw);
    drawing = std::max(drawing, std::min<std::uint64_t>(draw, cost.device.kept));
    if (pass.ends_light)
      most = std::max(most, held + drawing + ledgers[static_cast<std::size_t>(pass.light)]);
  }
  return std::max({most, held + drawing + cost.outputs, held + drawing + tree_bytes(cost.scene)});
}

std::string memory_refusal(std::uint64_t needed, const MemoryBudget& budget, const std::string& lower) {
  if (needed <= budget.bytes) return "";
  return "these sizes need " + bytes_text(static_cast<double>(needed)) + " of memory, more than the " +
         bytes_text(static_cast<double>(budget.bytes)) + " " + budget.whose + "; lower " + lower +
         ", or raise --memory";
}

}  // namespace caustics
