#include "pipeline/scene/gltf/used.hpp"

#include <optional>
#include <string_view>

#include "pipeline/scene/gltf/animation.hpp"

namespace caustics::gltf {

namespace {

using List = std::vector<bool> Used::*;

// The arrays of a document, by the names that they have there.
constexpr std::pair<const char*, List> kArrays[] = {
    {"scenes", &Used::scenes},  {"nodes", &Used::nodes},         {"meshes", &Used::meshes},
    {"skins", &Used::skins},    {"materials", &Used::materials}, {"textures", &Used::textures},
    {"images", &Used::images},  {"accessors", &Used::accessors}, {"bufferViews", &Used::views},
    {"buffers", &Used::buffers}};

// Members whose numbers are indices into one of them, wherever they stand. Of a joint only its place in the
// tree counts, and of a sampler or a light it is checked where it is read.
constexpr std::pair<std::string_view, List> kReferences[] = {
    {"nodes", &Used::nodes},      {"children", &Used::nodes},     {"mesh", &Used::meshes},
    {"skin", &Used::skins},       {"material", &Used::materials}, {"index", &Used::textures},
    {"source", &Used::images},    {"indices", &Used::accessors},  {"input", &Used::accessors},
    {"output", &Used::accessors}, {"bufferView", &Used::views},   {"inverseBindMatrices", &Used::accessors},
    {"buffer", &Used::buffers}};

// Objects all of whose numbers are accessors: the attributes of a primitive, of instances, of a morph target.
bool holds_accessors(std::string_view key) { return key == "attributes" || key == "targets"; }
// Says nothing of what is drawn.
bool is_passed_over(std::string_view key) { return key == "extras" || key == "KHR_materials_variants"; }

List list_of(std::string_view key) {
  for (const auto& [name, list] : kReferences)
    if (name == key) return list;
  return nullptr;
}

class Marker {
 public:
  explicit Marker(const Json& root) : root_(root) {
    for (const auto& [name, list] : kArrays) (used_.*list).assign(array(name).size(), false);
  }

  void mark(List list, double number) {
    std::vector<bool>& marks = used_.*list;
    if (!(number >= 0.0 && number < static_cast<double>(marks.size()))) return;
    const auto index = static_cast<std::size_t>(number);
    if (marks[index]) return;
    marks[index] = true;
    for (const auto& [name, each] : kArrays)
      if (each == list) waiting_.push_back(&array(name)[index]);
  }

  void mark_all_nodes() {
    for (std::size_t i = 0; i < used_.nodes.size(); ++i) mark(&Used::nodes, static_cast<double>(i));
  }

  void look_into(const Json& value) { waiting_.push_back(&value); }

  Used run() {
    while (!waiting_.empty()) {
      const Json* next = waiting_.back();
      waiting_.pop_back();
      walk(*next, nullptr, false);
    }
    return std::move(used_);
  }

 private:
  const Json::Array& array(const char* name) const {
    static const Json::Array none;
    const Json* found = root_.find(name);
    return found && found->is_array() ? found->as<Json::Array>() : none;
  }

  // `list`: what a number, or the numbers of an array, are indices into, or null; `accessors`: those of an
  // object are accessors.
  void walk(const Json& value, List list, bool accessors) {
    if (value.is<double>() && list) mark(list, value.as<double>());
    if (value.is_array())
      for (const Json& element : value.as<Json::Array>()) walk(element, list, accessors);
    if (!value.is_object()) return;
    for (const JsonMember& member : value.as<Json::Object>()) {
      if (is_passed_over(member.key)) continue;
      const List own = list_of(member.key);
      walk(member.value, own ? own : accessors ? &Used::accessors : nullptr, holds_accessors(member.key));
    }
  }

  const Json& root_;
  Used used_;
  std::vector<const Json*> waiting_;
};

}  // namespace

Used used_by_scene(const Context& context, const Document& document) {
  Marker marker(document.json);
  const Json* scene = document.json.find("scene");
  const Json* scenes = document.json.find("scenes");
  if (!scenes || !scenes->is_array() || scenes->as<Json::Array>().empty()) {
    marker.mark_all_nodes();
  } else if (!scene || scene->is<double>()) {
    marker.mark(&Used::scenes, scene ? scene->as<double>() : 0.0);
  }
  const Cursor animations = document.root(context).member("animations");
  if (const auto chosen = chosen_animation(context, document))
    marker.look_into(animations.element(*chosen).json());
  return marker.run();
}

}  // namespace caustics::gltf
