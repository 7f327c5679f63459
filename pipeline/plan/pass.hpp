// A pass as the plan knows it: its definition, what calls for it, and what it is drawn with.
#pragma once
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/gpu/pass_definition.hpp"
#include "pipeline/effects/effects.hpp"
#include "pipeline/scene/view.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

// How often a pass runs in a frame. What belongs to a Water runs before the frame's passes, as many times
// as its waves need steps (pipeline/water); a plan that is to be looked at in full has the last step again.
enum class Each : std::uint8_t { Frame, Light, Branch, Water };

// What a pass draws.
enum class DrawSet : std::uint8_t {
  FullScreen,      // one triangle over all pixels
  Receivers,       // every mesh that is a Receiver
  Casters,         // every Refractor and Mirror
  SolidCasters,    // every Refractor with two interfaces
  ThinPanes,       // every ThinPane
  GridVertices,    // grid * grid points
  GridCells,       // (grid - 1) * (grid - 1) points
  GridCellQuads,   // (grid - 1) * (grid - 1) quadrilaterals of two triangles
  Beams,           // beams * beams quadrilaterals of two triangles
};

// Size of a pass's targets.
// Wide is half the picture's size over three times its view, for what glass shows of the surroundings.
// Beams is the grid's size, coarser where one beam stands for several grid vertices.
// Receiver is the map's size, or twice as wide and high where receivers can hide others from the light: then its texels,
// not planes, tell where light lands.
enum class Extent : std::uint8_t { Picture, Wide, Grid, Map, Receiver, Shadow, Water, Beams };

// What a pass's uniforms are made from. `mesh` and `material` are null for DrawSets without meshes.
struct PassContext {
  const Scene* scene = nullptr;
  const Settings* settings = nullptr;
  const Effects* effects = nullptr;
  const LightViews* views = nullptr;  // Each::Light and Each::Branch
  const View* camera = nullptr;
  const View* surroundings = nullptr;  // three times as wide and high as the camera's view
  const Light* light = nullptr;         // Each::Light and Each::Branch
  const Branch* branch = nullptr;       // Each::Branch only
  const Water* water = nullptr;         // Each::Water only
  std::int64_t water_step = 0;          // likewise: which step, counted from rest
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  int material_row = 0;   // row of `caster_materials`: the mesh's material
  int mesh_index = 0;
  int width = 0, height = 0;  // of the pass's targets
  int face = 4;           // of a cube view: the face that is drawn
  float exposure = 1.0f;  // factor from nit to display white
};

using UniformBytes = std::vector<std::byte>;

// The bytes of a uniform struct, as a draw carries them.
template <class T>
UniformBytes uniform_bytes(const T& block) {
  static_assert(sizeof(T) % 16 == 0);
  UniformBytes bytes(sizeof(T));
  std::memcpy(bytes.data(), &block, sizeof(T));
  return bytes;
}

struct Pass {
  PassDefinition definition;
  // The reason why this frame needs the pass, or nothing.
  std::optional<std::string> (*called_for_by)(const Effects&) = nullptr;
  Each each = Each::Frame;
  DrawSet draws = DrawSet::FullScreen;
  Extent extent = Extent::Picture;
  UniformBytes (*uniforms)(const PassContext&) = nullptr;
  // Of a pass that draws its meshes once for each face of a cube of its own: that cube.
  View (*all_around)(const PassContext&) = nullptr;
  // Of a pass that only some lights need: which ones.
  bool (*light_needs)(const Effects&, int light) = nullptr;
  // To whom the attachments belong: a pass of each light may add to the frame's, one of each branch to
  // its light's.
  Each owner = each;
};

// Passes in the order in which they run. passes/registry.hpp has the only list.
using Registry = std::vector<Pass>;

// Resources that exist before the first pass, and what other rooms look up by name.
inline constexpr char kCasterMaterials[] = "caster_materials";
inline constexpr char kEnvironment[] = "environment";
inline constexpr char kCasterNormal[] = "caster_normal";
inline constexpr char kWaterStep[] = "water_step";
inline constexpr char kWaterBefore[] = "water_before";
inline constexpr char kLanding[] = "landing";
inline constexpr char kLandingFlux[] = "landing_flux";
inline constexpr char kLandingFresnel[] = "landing_fresnel";
inline constexpr char kLandingAbsorbed[] = "landing_absorbed";
// In `landing`: the status of each grid vertex after an earlier search, where there was one.
inline constexpr char kLandedBefore[] = "landed_before";
// Of scenes with a medium only.
inline constexpr char kLandingMedium[] = "landing_medium";
inline constexpr char kCausticMap[] = "caustic_map";
// A finer map of a part of it, for lights with a cascade.
inline constexpr char kCascadeMap[] = "cascade_map";
inline constexpr char kCellNear[] = "cell_near";
inline constexpr char kCellFar[] = "cell_far";
inline constexpr char kCellFlux[] = "cell_flux";

// The same texture, or pass, for the farthest receivers that the light sees (passes/far_receivers/).
inline std::string far_texture(const std::string& name) { return "far_" + name; }

}  // namespace caustics
