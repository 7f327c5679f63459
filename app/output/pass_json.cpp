#include "app/output/pass_json.hpp"

#include <cmath>
#include <map>

#include "app/json.hpp"
#include "app/output/uniform_values.hpp"

namespace caustics::app {

namespace {

template <std::size_t N, class Enum>
const char* word_of(const char* const (&words)[N], Enum value) {
  return words[static_cast<std::size_t>(value)];
}

constexpr const char* kTopologies[] = {"triangles", "points", "rectangles"};
constexpr const char* kCompares[] = {"always",        "less",  "less_equal", "greater",
                                     "greater_equal", "equal", "never"};
constexpr const char* kCulls[] = {"none", "back", "front"};
constexpr const char* kEquations[] = {"add", "min", "max"};
constexpr const char* kFactors[] = {
    "zero", "one", "source_color", "source_alpha", "one_minus_source_alpha", "destination_color"};

Json blend_json(const BlendState& blend) {
  if (!blend.enabled) return nullptr;
  return {{"equation", word_of(kEquations, blend.equation)},
          {"source", word_of(kFactors, blend.source)},
          {"destination", word_of(kFactors, blend.destination)}};
}

std::string mask_text(const ColorMask& mask) {
  std::string text;
  for (std::size_t c = 0; c < mask.size(); ++c)
    if (mask[c]) text += "RGBA"[c];
  return text;
}

Json pass_state_json(const PassDefinition& definition) {
  return {{"topology", word_of(kTopologies, definition.topology)},
          {"depth_compare", word_of(kCompares, definition.depth_state.compare)},
          {"depth_write", definition.depth_state.write},
          {"cull", word_of(kCulls, definition.cull)}};
}

std::string texture_name(const RenderedFrame& frame, int texture) {
  return frame.plan().textures[static_cast<std::size_t>(texture)].name;
}

Json reads_json(const RenderedFrame& frame, const PlannedPass& pass, const DumpedFiles& files) {
  Json list = Json::array();
  for (std::size_t i = 0; i < pass.reads.size(); ++i) {
    const TextureRead& read = pass.definition->reads[i];
    Json json = {{"name", read.name}, {"meaning", read.meaning}};
    if (read.of_material) {
      json["of_material"] = true;
    } else {
      const int texture = pass.reads[i];
      json["texture"] = texture >= 0 ? Json(texture_name(frame, texture)) : Json();
      json["file"] = texture >= 0 ? files.of_texture(texture) : Json();
    }
    list.push_back(json);
  }
  return list;
}

// What an attachment holds when the pass begins: a value everywhere, or what is in a file.
Json begin_json(const PlannedPass& pass, std::size_t attachment, int texture, const Json& cleared,
                const DumpedFiles& files) {
  const bool kept = attachment < pass.keep.size() && pass.keep[attachment];
  return kept ? Json{{"keeps", files.of_texture(texture)}} : Json{{"clear", cleared}};
}

Json writes_json(const RenderedFrame& frame, const PlannedPass& pass, const DumpedFiles& files) {
  Json list = Json::array();
  const PassDefinition& definition = *pass.definition;
  for (std::size_t i = 0; i < pass.writes.size(); ++i) {
    if (pass.writes[i] < 0) continue;
    const ColorWrite& write = definition.writes[i];
    Json json = {{"name", write.name},
                 {"attachment", texture_name(frame, pass.writes[i])},
                 {"blend", blend_json(write.blend)},
                 {"mask", mask_text(write.mask)}};
    json.update(begin_json(pass, i, pass.writes[i], write.clear, files));
    list.push_back(json);
  }
  if (pass.depth >= 0) {
    Json json = {{"name", definition.depth->name}, {"attachment", texture_name(frame, pass.depth)}};
    json.update(begin_json(pass, pass.writes.size(), pass.depth, definition.depth->clear, files));
    list.push_back(json);
  }
  return list;
}

Json declared_json(const PassDefinition& definition) {
  Json list = Json::array();
  for (const UniformVariable& each : uniform_layout_of(*definition.shader).variables)
    list.push_back(
        {{"name", each.name}, {"type", each.type}, {"offset", each.offset}, {"meaning", each.meaning}});
  return list;
}

// JSON has no word for what is not finite.
Json value_json(double value, bool whole) {
  if (whole) return static_cast<std::int64_t>(value);
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  return value;
}

Json values_json(const NamedUniform& uniform) {
  const bool whole = uniform.type == "int";
  if (uniform.values.size() == 1) return value_json(uniform.values.front(), whole);
  Json list = Json::array();
  for (const double value : uniform.values) list.push_back(value_json(value, whole));
  return list;
}

// Index into Scene::meshes.
using MeshNumbers = std::map<MeshId, std::size_t>;

MeshNumbers mesh_numbers(const RenderedFrame& frame) {
  MeshNumbers numbers;
  for (std::size_t i = 0; i < frame.scene().meshes.size(); ++i)
    numbers[frame.on_device().mesh(static_cast<int>(i))] = i;
  return numbers;
}

Json draw_json(const Scene& scene, const MeshNumbers& numbers, const PassDefinition& definition,
               const Draw& draw, const DumpedFiles& files) {
  Json json = Json::object();
  if (draw.mesh == MeshId::None) {
    json["vertices"] = draw.vertex_count;
  } else {
    const Mesh& mesh = scene.meshes[numbers.at(draw.mesh)];
    json["mesh"] = mesh.name;
    json["material"] = scene.materials[static_cast<std::size_t>(mesh.material)].name;
  }
  for (std::size_t i = 0; i < definition.reads.size(); ++i)
    if (definition.reads[i].of_material)
      json["textures"][definition.reads[i].name] = files.of_material(draw.textures[i]);
  json["uniforms"] = Json::object();
  for (const NamedUniform& uniform : uniform_values(definition, draw))
    json["uniforms"][uniform.name] = values_json(uniform);
  return json;
}

}  // namespace

Json pass_json(const RenderedFrame& frame, const PlannedPass& pass, const DumpedFiles& files) {
  Json json = {{"pass", pass.label},
               {"purpose", pass.definition->purpose},
               {"shader", pass.definition->shader->name},
               {"width", pass.width},
               {"height", pass.height},
               {"state", pass_state_json(*pass.definition)},
               {"reads", reads_json(frame, pass, files)},
               {"writes", writes_json(frame, pass, files)},
               {"uniforms", declared_json(*pass.definition)},
               {"draws", Json::array()}};
  const MeshNumbers numbers = mesh_numbers(frame);
  for (const Draw& draw : frame.prepare(pass).draws)
    json["draws"].push_back(draw_json(frame.scene(), numbers, *pass.definition, draw, files));
  return json;
}

}  // namespace caustics::app
