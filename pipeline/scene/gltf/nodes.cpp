#include "pipeline/scene/gltf/nodes.hpp"

#include "pipeline/scene/gltf/accessor.hpp"

namespace caustics::gltf {

namespace {

using exact::Affine;

class Walk {
 public:
  Walk(Context& context, const Document& document, const Model& model)
      : context_(context), root_(document.root(context)), model_(model) {
    placements_.place_of.assign(model.nodes.size(), -1);
    lights_ = root_.member("extensions").member("KHR_lights_punctual").member("lights").size();
  }

  Placements run() {
    for (const int node : roots()) visit(node, -1, Affine{}, 0, true);
    const std::uint64_t most = context_.options().max_lit_meshes;
    if (placements_.lights.size() * placements_.meshes.size() > most) {
      root_.member("nodes").fail("the scene's lights times its meshes are more than " + std::to_string(most),
                                 "join meshes, or leave lights out");
    }
    return std::move(placements_);
  }

 private:
  std::vector<int> roots();
  void visit(int node, int above, const Affine& parent, int depth, bool visible);
  NodeTransform transform(const Cursor& node, const NodeSource& values);
  Affine matrix_transform(const Cursor& node, const std::vector<double>& m);
  void place(const Cursor& node, int index, const Affine& to_world, bool visible);
  void place_mesh(const Cursor& node, const Placement& placement);
  void place_instances(const Cursor& instancing, const Placement& placement);
  void count_visit(const Cursor& node, std::uint64_t number);

  Context& context_;
  Cursor root_;
  const Model& model_;
  std::uint64_t count_ = 0;
  std::size_t lights_ = 0;
  Placements placements_;
};

std::vector<int> Walk::roots() {
  const std::size_t scenes = model_.scenes.size();
  if (scenes > 0) {
    const auto chosen = root_.member("scene").optional_index("scenes", scenes);
    if (scenes > 1) {
      context_.note("The file has " + std::to_string(scenes) + " scenes; scenes[" +
                    std::to_string(chosen.value_or(0)) + "] is shown.");
    }
    return model_.scenes[static_cast<std::size_t>(chosen.value_or(0))];
  }
  std::vector<bool> is_child(model_.nodes.size(), false);
  for (const NodeSource& node : model_.nodes) {
    for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i) {
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  }
  if (!model_.nodes.empty()) context_.note("The file has no scene: all its nodes are shown.");
  return roots;
}

void Walk::count_visit(const Cursor& node, std::uint64_t number) {
  if (number > context_.options().max_nodes - count_) {
    node.fail(
        "the scene has more than " + std::to_string(context_.options().max_nodes) + " nodes and instances",
        "split the scene");
  }
  count_ += number;
}

void Walk::visit(int index, int above, const Affine& parent, int depth, bool visible) {
  const auto i = static_cast<std::size_t>(index);
  const Cursor node = root_.member("nodes").element(i);
  if (placements_.place_of[i] >= 0) {
    node.fail("is reached twice: it has two parents or is its own ancestor",
              "nodes must form a tree (glTF 2.0, 3.5.2): export the file again");
  }
  const int here = static_cast<int>(placements_.tree.size());
  placements_.place_of[i] = here;
  count_visit(node, 1);
  if (depth > context_.options().max_node_depth) {
    node.fail(
        "lies deeper than " + std::to_string(context_.options().max_node_depth) + " levels in the node tree",
        "flatten the hierarchy");
  }
  placements_.tree.push_back({index, above, transform(node, model_.nodes[i])});
  const Affine to_world = parent * placements_.tree.back().rest.local();
  if (!to_world.finite()) node.fail("its transform is not finite", "correct its scale");
  const Cursor extension = node.member("extensions").member("KHR_node_visibility");
  if (!extension.member("visible").boolean(true)) {
    context_.note("Nodes that KHR_node_visibility hides are left out.");
    visible = false;
  }
  place(node, index, to_world, visible);
  for (const int child : model_.nodes[i].children) {
    visit(child, here, to_world, depth + 1, visible);
  }
}

Affine Walk::matrix_transform(const Cursor& node, const std::vector<double>& m) {
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
    context_.note(node.path() + ".matrix: its last row is not 0 0 0 1 and was taken to be.");
  }
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

NodeTransform Walk::transform(const Cursor& node, const NodeSource& values) {
  NodeTransform result;
  if (values.matrix.size() == 16) {
    result.matrix = matrix_transform(node, values.matrix);
    return result;
  }
  const auto& t = values.translation;
  const auto& r = values.rotation;
  const auto& s = values.scale;
  if (t.size() == 3) result.translation = {t[0], t[1], t[2]};
  if (s.size() == 3) result.scale = {s[0], s[1], s[2]};
  if (r.size() == 4) {
    result.rotation = {r[0], r[1], r[2], r[3]};
    const double squared = r[0] * r[0] + r[1] * r[1] + (r[2] * r[2] + r[3] * r[3]);
    if (!(squared > 1e-12 && squared < 1e12)) {
      context_.note(node.path() + ".rotation is not a unit quaternion; no rotation is used.");
      result.rotation = {0, 0, 0, 1};
    }
  }
  return result;
}

void Walk::place(const Cursor& node, int index, const Affine& to_world, bool visible) {
  const std::string name = node.member("name").string("");
  const Placement here{index, 0, to_world, name, placements_.tree.size() - 1, {}, -1};
  const auto mesh = node.member("mesh").optional_index("meshes", model_.meshes.size());
  const auto camera = node.member("camera").optional_index("cameras", root_.member("cameras").size());
  const Cursor light = node.member("extensions").member("KHR_lights_punctual");
  if (mesh && visible) {
    Placement body = here;
    body.index = *mesh;
    body.skin = node.member("skin").optional_index("skins", root_.member("skins").size()).value_or(-1);
    place_mesh(node, body);
  }
  if (camera) {
    placements_.cameras.push_back(here);
    placements_.cameras.back().index = *camera;
  }
  if (light.present() && visible) {
    if (placements_.lights.size() >= context_.options().max_lights) {
      light.fail("the scene has more than " + std::to_string(context_.options().max_lights) + " lights",
                 "leave some out");
    }
    placements_.lights.push_back(here);
    placements_.lights.back().index =
        light.member("light").index("extensions.KHR_lights_punctual.lights", lights_);
  }
}

void Walk::place_mesh(const Cursor& node, const Placement& placement) {
  const auto mesh = static_cast<std::size_t>(placement.index);
  const std::uint64_t primitives = model_.meshes[mesh].primitives.size();
  const Cursor instancing = node.member("extensions").member("EXT_mesh_gpu_instancing");
  if (instancing.present()) {
    place_instances(instancing.member("attributes"), placement);
    return;
  }
  count_visit(node, primitives);
  placements_.meshes.push_back(placement);
}

void Walk::place_instances(const Cursor& attributes, const Placement& placement) {
  std::vector<Accessor> given;
  int which[3] = {-1, -1, -1};  // translation, rotation, scale: positions in `given`
  const char* names[3] = {"TRANSLATION", "ROTATION", "SCALE"};
  for (int k = 0; k < 3; ++k) {
    const Cursor attribute = attributes.member(names[k]);
    const auto index = attribute.optional_index("accessors", model_.accessors.size());
    if (!index) continue;
    which[k] = static_cast<int>(given.size());
    given.emplace_back(context_, model_, *index);
    if (given.back().components() != (k == 1 ? 4 : 3) || given.back().size() != given[0].size()) {
      attribute.fail("has the wrong type, or another count than the other attributes",
                     "export the file again");
    }
  }
  if (given.empty()) attributes.fail("has no instances", "export the file again");
  const std::uint64_t primitives = model_.meshes[static_cast<std::size_t>(placement.index)].primitives.size();
  for (std::size_t i = 0; i < given[0].size(); ++i) {
    count_visit(attributes, 1 + primitives);
    double v[3][4] = {{0, 0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1, 0}};
    for (int k = 0; k < 3; ++k) {
      for (int c = 0; which[k] >= 0 && c < (k == 1 ? 4 : 3); ++c) {
        v[k][c] = given[static_cast<std::size_t>(which[k])].value(i, c);
      }
    }
    Placement instance = placement;
    instance.inner = exact::from_trs({v[0][0], v[0][1], v[0][2]}, {v[1][0], v[1][1], v[1][2], v[1][3]},
                                     {v[2][0], v[2][1], v[2][2]});
    instance.to_world = placement.to_world * instance.inner;
    instance.name += " instance " + std::to_string(i);
    if (!instance.to_world.finite()) {
      attributes.fail("instance " + std::to_string(i) + ": its transform is not finite");
    }
    placements_.meshes.push_back(instance);
  }
}

}  // namespace

Affine NodeTransform::local() const {
  return matrix ? *matrix : exact::from_trs(translation, rotation, scale);
}

Placements place_nodes(Context& context, const Document& document, const Model& model) {
  return Walk(context, document, model).run();
}

}  // namespace caustics::gltf
