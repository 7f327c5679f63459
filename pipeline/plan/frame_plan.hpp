// The plan of a frame: which passes run, in which order, on which textures, and why. Data only.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/plan/pass.hpp"

namespace caustics {

// A texture of the frame. One that belongs to a light is named "name[light]", one of a branch
// "name[light branch]", that of an instance "name.label[light]".
struct PlannedTexture {
  std::string name;
  Format format = Format::RGBA32F;
  int width = 0, height = 0;
  bool external = false;  // uploaded with the scene, not written by a pass
  bool kept = true;       // holds its contents until the next frame; else only until its last reader has run
  int light = -1;         // index into Scene::lights of whom it belongs to, -1: to the frame or a water
  bool kept_for_light = false;  // holds its contents until that light's last pass has run
  // The last pass at whose end it holds its contents, an index into FramePlan::passes.
  int until = -1;
  int memory = -1;       // index into FramePlan::memory; of an external texture none
  std::string unread{};  // why a pass that could read it does not: the reason of an effect
  bool operator==(const PlannedTexture&) const = default;
};

// A texture of the device, which planned textures of its kind take one after the other.
struct TextureMemory {
  Format format = Format::RGBA32F;
  int width = 0, height = 0;
};

struct PlannedPass {
  static constexpr int kMaterial = -1;  // in `reads`: the drawn material's texture
  static constexpr int kNothing = -2;   // in `reads`: an optional texture this frame lacks; in `writes`: an
                                        // attachment that nobody needs

  int pass = 0;                                      // index into the registry
  const DrawnFor* drawn_for = nullptr;               // of the registry's pass
  std::shared_ptr<const PassDefinition> definition;  // what a device runs; instances share it
  int light = -1;                                    // index into Scene::lights, -1 for a pass of the frame
  int branch = -1;  // index into Effects::branches, -1 for a pass of the frame or of a light
  int water = -1;   // index into Scene::waters, -1 for all other passes
  int sample =
      0;  // of each pixel, counted from 1; 0 for what the camera's samples share, and for their middle
  std::string label;  // "caustic_map[sun]", "landing[sun].far"
  std::string reason;
  std::vector<int> reads{};  // indices into FramePlan::textures, or the constants above
  std::vector<int> writes{};
  int depth = -1;
  std::vector<bool> keep{};  // as PassRun::keep
  int width = 0, height = 0;
  // Queries, numbered from 1 on; 0: none. A pass that finds whether the light reaches its casters, how many
  // rays are under way, or whether there is a layer of blended surfaces, counts for those that follow, which
  // draw nothing where the count is 0 (PassRun).
  int counts_into = 0, only_if = 0;
  bool ends_light = false;  // no pass of its light follows, but for samples of pixels

  // The textures that it writes: colours in turn, depth last.
  std::vector<int> attachments() const;
};

// Why its query counts nothing, if so.
std::string_view why_left_out(const PlannedPass& pass);

// A pass of a water: run before the frame's passes (pipeline/renderer/moving_water.hpp).
struct PlannedSteps {
  std::string label;   // "water_step[pool]"
  std::string reason;  // with the number of steps
  PlannedTexture writes;
};

// A pass, or one of its instances, that does not run, and the effect that did not call for it.
struct SkippedPass {
  std::string name;
  std::string reason;
};

struct FramePlan {
  std::vector<PlannedTexture> textures;
  std::vector<TextureMemory> memory;
  std::vector<PlannedSteps> before;  // in turn, before `passes`
  std::vector<PlannedPass> passes;
  std::vector<SkippedPass> skipped;
  std::map<std::string, int, std::less<>> by_name{};  // the textures; of a plan in the making empty
  // Index of a texture by its full name, or -1.
  int find(std::string_view name) const;
  // Bytes of the memory of all textures that passes write.
  std::size_t bytes() const;
};

// What is wanted of a frame. A name without "[light]" means the frame's texture and each light's own.
struct PlanGoal {
  // Only the passes that these depend on are planned. Empty: everything that the effects call for, and every
  // texture is kept.
  std::vector<std::string> textures{};
  // Kept too, where a pass that writes them runs anyway.
  std::vector<std::string> beside{};
  // A light's own textures are kept until its last pass has run and no longer, for those who look at them
  // while the frame is drawn: memory does not depend on how many lights there are.
  bool light_by_light = false;
};

// Throws Error (InternalError) when a pass reads what nothing writes.
FramePlan make_plan(const Scene& scene, const Effects& effects, const Settings& settings,
                    const Registry& registry, const PlanGoal& goal = {});

// The full name of a light's own texture, and of a branch's.
std::string light_texture(std::string_view name, int light);
std::string branch_texture(std::string_view name, int light, const Branch& branch);
// And of a water: "name[water 0]".
std::string water_texture(std::string_view name, std::size_t water);

}  // namespace caustics
