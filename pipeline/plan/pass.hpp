// A pass as the plan knows it: what it does, what calls for it, for whom it is drawn, what it reads and
// writes, its state, its shader. All of it data: the planner (frame_plan.hpp) makes instances of it for a
// frame.
#pragma once
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/effects/effects.hpp"
#include "pipeline/gpu/pass_definition.hpp"
#include "pipeline/plan/texture_names.hpp"
#include "pipeline/scene/view.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

// How often a pass runs in a frame. What belongs to a Water runs before the frame's passes, as many times
// as its waves need steps (pipeline/renderer/moving_water.hpp); a plan that is to be looked at in full has
// the last step again.
// A Sample is one of a pixel, after all that the camera's passes see there (pipeline/plan/sample_passes.hpp).
// Rays are a pilot's, and part of no frame (pipeline/measure/light_paths.hpp).
enum class Each : std::uint8_t { Frame, Light, Branch, Water, Sample, Rays };

// Which of the receivers behind the casters, where one can hide another from the light.
enum class ReceiverLayer : std::uint8_t { Nearest, Farthest };
// Which caustic map of a light: the whole, or the finer one of its bright part.
enum class MapWindow : std::uint8_t { Whole, Cascade };
// What the camera sees: the picture, or what is shown only behind the first glass in a pixel, or only
// mirrored by the first glass or metal.
enum class CameraView : std::uint8_t { Picture, Behind, Mirrored };

struct TargetSize {
  int width = 0, height = 0;
};

// For whom a pass is drawn: once for the frame, each light, branch or water, and for which part of what these
// see.
struct DrawnFor {
  Each each = Each::Frame;
  // Behind the pass's name and owner: "landing[sun].far"; empty for the plain instance.
  std::string_view label{};
  // The instance writes textures of its own, named alike ("landing.far[0]"), and reads such where there are
  // any.
  bool own_textures = true;
  ReceiverLayer receivers = ReceiverLayer::Nearest;
  MapWindow window = MapWindow::Whole;
  CameraView camera = CameraView::Picture;
  TargetSize (*size)(const Settings&, const Effects&, const LightEffects*) = nullptr;  // null: the pass's
  int layer = 0;            // of the blended surfaces in a pixel: 1, the nearest, to kMostLayers; 0: no such
  bool with_panes = false;  // of Casters: thin panes as well
  Effect Effects::*also = nullptr;                // needed beside the pass's own effects
  bool (*lights)(const LightEffects&) = nullptr;  // which of the lights need it; null: all
  std::string_view reason{};                      // why a frame needs it; empty: for the pass's reason
};

// Whether something belongs to a frame that calls for these effects.
using Condition = bool (*)(const Effects&);
template <Effect Effects::*effect>
bool with(const Effects& effects) {
  return (effects.*effect).active;
}

inline bool sees_through_window(const LightEffects& light) { return light.all_around.empty(); }
inline bool has_cascade(const LightEffects& light) { return !light.cascade.empty(); }

inline constexpr std::string_view kBeyond = "glass may show what the picture does not";
inline constexpr std::string_view kHidden = "light falls on receivers that others hide from the light's view";
inline constexpr DrawnFor kFrame{};
inline constexpr DrawnFor kHiddenBehind{
    .label = "behind", .camera = CameraView::Behind, .also = &Effects::seen_casters, .reason = kBeyond};
inline constexpr DrawnFor kHiddenMirrored{
    .label = "in_mirrors", .camera = CameraView::Mirrored, .also = &Effects::seen_casters, .reason = kBeyond};
// Blended surfaces in the picture. Their instances come layer by layer, just before what the last pass that
// has such draws beside them.
std::vector<DrawnFor> with_layers(std::vector<DrawnFor> drawn_for);
std::string_view layer_label(int layer);
// What the lights draw, drawn for the camera: what it looks through and into; and what of that is no pane,
// which positions, haze and statements pass.
inline constexpr DrawnFor kCamera{.label = "camera",
                                  .with_panes = true,
                                  .also = &Effects::seen_casters,
                                  .reason = "the camera sees casters, and through them"};
inline constexpr DrawnFor kCameraBeyondPanes{
    .label = "beyond_panes", .also = &Effects::seen_panes, .reason = "panes hide nothing from the camera"};
inline bool is_of_casters_in_view(const DrawnFor& drawn_for) {
  return drawn_for.label == kCamera.label || drawn_for.label == kCameraBeyondPanes.label;
}
inline constexpr std::string_view kCastersBeyondPanes = "caster_position.beyond_panes";
inline std::string_view casters_beyond_panes(const Effects& effects, const DrawnFor& = {}) {
  return effects.seen_panes.active ? kCastersBeyondPanes : "caster_position.camera";
}
inline constexpr std::string_view kNormalsBeyondPanes = "caster_normal.beyond_panes";
inline std::string_view normals_beyond_panes(const Effects& effects, const DrawnFor& = {}) {
  return effects.seen_panes.active ? kNormalsBeyondPanes : "caster_normal.camera";
}
inline constexpr DrawnFor kLight{.each = Each::Light};
inline constexpr DrawnFor kLightBeyondPanes{.each = Each::Light,
                                            .label = "through_panes",
                                            .also = &Effects::seen_panes,
                                            .reason = "glass and metal behind panes mirror the light"};
inline constexpr DrawnFor kLightFar{.each = Each::Light,
                                    .label = "far",
                                    .receivers = ReceiverLayer::Farthest,
                                    .also = &Effects::hidden_receivers,
                                    .lights = sees_through_window,
                                    .reason = kHidden};
inline constexpr DrawnFor kLightBehind{.each = Each::Light,
                                       .label = "behind",
                                       .camera = CameraView::Behind,
                                       .also = &Effects::seen_casters,
                                       .reason = kBeyond};
inline constexpr DrawnFor kLightMirrored{.each = Each::Light,
                                         .label = "in_mirrors",
                                         .camera = CameraView::Mirrored,
                                         .also = &Effects::seen_casters,
                                         .reason = kBeyond};
inline constexpr DrawnFor kBranch{.each = Each::Branch};
inline constexpr DrawnFor kBranchFar{.each = Each::Branch,
                                     .label = "far",
                                     .receivers = ReceiverLayer::Farthest,
                                     .also = &Effects::hidden_receivers,
                                     .lights = sees_through_window,
                                     .reason = kHidden};
inline constexpr DrawnFor kBranchCascade{.each = Each::Branch,
                                         .label = "cascade",
                                         .window = MapWindow::Cascade,
                                         .also = &Effects::cascades,
                                         .lights = has_cascade,
                                         .reason = "most of the light falls on little of its map"};
inline constexpr DrawnFor kWater{.each = Each::Water};
inline constexpr DrawnFor kSample{.each = Each::Sample};
inline constexpr DrawnFor kRays{.each = Each::Rays};

// What a pass draws.
enum class DrawSet : std::uint8_t {
  FullScreen,    // one triangle over all pixels
  Receivers,     // every mesh that is a Receiver; for a layer: what is blended
  Casters,       // every Refractor and Mirror
  Shadowing,     // every Receiver, and with LightEffects::casters_shadow every Refractor and Mirror
  SolidCasters,  // every Refractor with two interfaces
  LightTinters,  // every ThinPane, and what is blended
  GridVertices,  // grid * grid points
  GridColumns,   // grid points
  GridCells,     // (grid - 1) * (grid - 1) rectangles
  Beams,         // beams * beams quadrilaterals of two triangles
};

// Is a mesh in the set? No mesh is in sets that draw none. `light`: whose pass it is,
// null: the frame's.
bool draws_mesh(DrawSet draws, const DrawnFor& drawn_for, const Effects& effects, std::size_t mesh,
                const LightEffects* light);

// What a pass's uniforms are made from. `mesh` and `material` are null for DrawSets without meshes.
struct PassContext {
  const Scene* scene = nullptr;
  const Settings* settings = nullptr;
  const Effects* effects = nullptr;
  const LightViews* views = nullptr;       // Each::Light and Each::Branch
  const View* camera = nullptr;            // the picture's view
  const Light* light = nullptr;            // Each::Light and Each::Branch
  const LightEffects* of_light = nullptr;  // likewise: what is judged of it
  const Branch* branch = nullptr;          // Each::Branch only
  const Water* water = nullptr;            // Each::Water only
  std::int64_t water_step = 0;             // likewise: which step, counted from rest
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  int material_row = 0;       // row of `caster_materials`: the mesh's material
  int first_triangle = 0;     // of the mesh in the hierarchy (pipeline/scene/hierarchy_tables.hpp), -1: none
  int first_receiver = 0;     // the hierarchy's first triangle that is no caster's
  int first_uv = 0;           // the first texel of texture coordinates in hierarchy_normals
  int first_point = -1;       // the first there of the light's points, where it is a mesh that shines
  float touch = 0.0f;         // metres: surfaces that are as near touch
  glm::vec4 eye_media{0.0f};  // the bodies that the camera is in (passes/shared/media.glsl)
  int mesh_index = 0;
  int sample = 0;                       // of a pixel, from 1 on; 0: its middle alone
  int width = 0, height = 0;            // of the pass's targets
  int face = 4;                         // of a cube view: the face that is drawn
  float exposure = 1.0f;                // factor from nit to display white
  float contrast = 1.0f;                // Exposure::contrast
  const DrawnFor* drawn_for = nullptr;  // null: the plain instance

  bool farthest() const { return drawn_for && drawn_for->receivers == ReceiverLayer::Farthest; }
  // What sees the casters that are drawn: the light, or the camera.
  const View& sees_casters() const { return views ? views->caster : *camera; }
  int layer() const { return drawn_for ? drawn_for->layer : 0; }
  // Of what the picture shows?
  bool of_picture() const { return !drawn_for || drawn_for->camera == CameraView::Picture; }
  // Of the mesh that is drawn.
  SurfaceRole surface_role() const {
    const auto i = static_cast<std::size_t>(mesh_index);
    return effects && i < effects->surfaces.size() ? effects->surfaces[i] : SurfaceRole{};
  }
  bool cascade() const { return drawn_for && drawn_for->window == MapWindow::Cascade; }
};

using UniformBytes = std::vector<std::byte>;

// The bytes of a uniform struct, as a draw carries them.
template <class T>
UniformBytes uniform_bytes(const T& block) {
  static_assert(sizeof(T) % 16 == 0, "std140 blocks end on 16 bytes: struct alignas(16)");
  UniformBytes bytes(sizeof(T));
  std::memcpy(bytes.data(), &block, sizeof(T));
  return bytes;
}

// What fills a shader's uniform block, but for its choices, and how long the block is.
struct UniformBlock {
  UniformBytes (*fill)(const PassContext&) = nullptr;
  std::size_t size = 0;
};

// By a function of the PassContext that returns the struct of the shader's own text.
template <auto filled>
inline constexpr UniformBlock block_of{
    [](const PassContext& context) { return uniform_bytes(filled(context)); },
    sizeof(filled(std::declval<const PassContext&>()))};

// A whole number of the uniform block, a CHOICE line of it, that effects, settings or whom the instance is
// drawn for choose for a whole draw: OpenGL compiles a program for each value.
struct Choice {
  std::string_view name;
  int (*value)(const PassContext&) = nullptr;
};
template <Effect Effects::*effect>
int chosen_by(const PassContext& context) {
  return (context.effects->*effect).active ? 1 : 0;
}
// Likewise, but never of what only glass shows.
template <Effect Effects::*effect>
int of_picture(const PassContext& context) {
  return context.of_picture() ? chosen_by<effect>(context) : 0;
}
// Is there a caustic map of the light?
int throws_caustic(const PassContext& context);

// A texture that the shader reads: `name` is that of its TEXTURE line.
// In the picture, where blended surfaces lie: of the next nearer layer (of all else: of the farthest), of the
// nearest layer, or, of layers, what lies behind them all.
enum class OfLayer : std::uint8_t { None, Before, First, Behind };
struct Read {
  std::string_view name;
  std::string_view meaning;
  std::string_view texture{};  // another name than the shader has for it
  // Likewise, where effects or the instance choose it.
  std::string_view (*texture_by)(const Effects&, const DrawnFor&) = nullptr;
  bool of_material = false;                // the drawn surface's material's, instead of one of the frame
  bool discards_where_zero = false;        // as TextureRead has it
  bool layers_discard_where_zero = false;  // likewise, of instances of layers
  bool hidden_discard_where_zero = false;  // likewise, of those of what only glass shows
  bool optional = false;                   // the frame may lack it; one texel of zeros is bound then
  bool of_picture = false;                 // an optional read: what only glass shows has none of it
  OfLayer layer = OfLayer::None;           // an optional read
  Condition only_with = nullptr;           // the shader declares it only then
  std::string_view only_for{};             // read only by the instance with this label; the others get zeros
  std::string_view only_towards{};         // an optional read: the only attachment that depends on it
  Effect Effects::*needed_with = nullptr;  // an optional read: otherwise what it holds changes nothing
  // An optional read of Each::Branch: of the branch that comes to the second surface as this one does.
  bool of_same_start = false;
};

// A colour attachment: `name` is that of the shader's OUTPUT line.
struct Write {
  std::string_view name;
  Format format = Format::RGBA32F;
  std::string_view meaning;  // what a texel means, with its unit and space
  std::array<float, 4> clear{0.0f, 0.0f, 0.0f, 0.0f};
  BlendState blend{};
  ColorMask mask = kAllChannels;
  Format (*format_by)(const Effects&) = nullptr;             // where effects choose the format
  std::string_view (*texture_by)(const Effects&) = nullptr;  // where effects choose the texture's name
  Condition only_with = nullptr;                             // the shader declares it only then
  Condition needed_if = nullptr;                             // otherwise nobody needs what is in it
  std::string_view not_for{};                                // the label of an instance in which nobody does
};

// The pass's shader text compiled for what effects add; the last one whose condition holds is taken.
struct Permutation {
  const Shader* shader = nullptr;
  UniformBlock block{};           // none: the text has no uniforms
  Condition condition = nullptr;  // null: always
};

// State that the instance with a label has instead of the pass's.
struct InstanceState {
  std::string_view label;
  std::optional<float> depth_clear{};
  std::optional<Compare> depth_compare{};
  std::optional<BlendState> blend{};  // of all colour attachments
};

struct Pass {
  std::string_view name;  // = folder, shader text, page, test
  std::string_view purpose;
  std::string_view reason;                  // why a frame that calls for it needs it
  std::vector<Effect Effects::*> when{};    // all must be active; none: always
  std::vector<Effect Effects::*> unless{};  // where all of these are active too another pass takes its place
  std::vector<DrawnFor> drawn_for{kFrame};
  bool has_layers() const { return drawn_for.back().layer > 0; }
  // Only for lights of whom a caustic is to be expected.
  bool only_lights_with_caustics = false;
  DrawSet draws = DrawSet::FullScreen;
  // Of the targets of a pass of the camera: a texel stands for so many pixels a side.
  int coarser = 1;
  // Of the targets; null: the picture's (of what only glass shows half of that).
  TargetSize (*size)(const Settings&, const Effects&, const LightEffects*) = nullptr;
  std::vector<Read> reads{};
  std::vector<Write> writes{};
  std::optional<DepthWrite> depth{};
  // To whom the attachments belong: a pass of each light may add to the frame's, one of each branch to its
  // light's. None: to whom it is drawn for.
  std::optional<Each> owner{};
  Topology topology = Topology::Triangles;
  std::optional<int> zero_outside_quad{};  // as in PassDefinition
  DepthState depth_state{};
  Cull cull = Cull::None;
  bool count_samples = false;  // of a pass that has layers: of these alone
  std::vector<InstanceState> states{};
  std::vector<Permutation> shaders{};
  std::vector<Choice> choices{};
  // Of a pass that draws its meshes once for each face of a cube of its own: that cube.
  View (*all_around)(const PassContext&) = nullptr;

  // The uniform block of a draw.
  UniformBytes uniforms(const PassContext& context) const;
};

// What a device runs of a pass: the instance's, as these effects choose.
PassDefinition definition_of(const Pass& pass, const Effects& effects = {},
                             const DrawnFor& drawn_for = kFrame);

// Passes in the order in which they run. passes/registry.hpp has the only list.
using Registry = std::vector<Pass>;

// Throws Error (InternalError) with one line "pass 'name': what is wrong; what to do": everything that can be
// wrong in a definition (pipeline/gpu/validate.hpp), of every instance and permutation; two passes of one
// name; a uniform block of another size than the shader's; a choice that a shader asks and the pass does not
// make, or the reverse; a state of no instance.
void validate(const Registry& registry);

// Does the instance show what the camera sees? Such have the size of what it sees.
bool is_of_camera(const Pass& pass, const DrawnFor& drawn_for);
TargetSize picture_size(const Settings& settings, CameraView camera);
// By so many times a side, rounded up.
TargetSize coarser(TargetSize size, int times);

// Sizes that several passes share.
TargetSize grid_size(const Settings& settings, const Effects&, const LightEffects*);
TargetSize map_size(const Settings& settings, const Effects&, const LightEffects*);
TargetSize shadow_size(const Settings& settings, const Effects&, const LightEffects*);
// The map's, for one plane no more than 512; twice the map's where receivers can hide others from the light:
// then its texels, not planes, tell where light lands.
TargetSize receiver_size(const Settings& settings, const Effects& effects, const LightEffects* light);
// The grid's, coarser where one beam stands for several grid vertices.
TargetSize beams_size(const Settings& settings, const Effects&, const LightEffects*);

}  // namespace caustics
