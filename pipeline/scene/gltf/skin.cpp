#include "pipeline/scene/gltf/skin.hpp"

#include "pipeline/scene/gltf/accessor.hpp"
#include "pipeline/scene/gltf/cursor.hpp"

namespace caustics::gltf {

namespace {

constexpr std::size_t kMostSets = 16;  // of four joints a vertex

exact::Affine read_matrix(const Cursor& cursor, const Accessor& accessor, std::size_t i) {
  const auto column = [&](int c) {
    return glm::dvec3(accessor.value(i, 4 * c), accessor.value(i, 4 * c + 1), accessor.value(i, 4 * c + 2));
  };
  const exact::Affine matrix{column(0), column(1), column(2), column(3)};
  if (!matrix.finite()) cursor.fail("matrix " + std::to_string(i) + " is not finite", kExportAgain);
  return matrix;
}

void read_inverse_binds(const Context& context, const Cursor& cursor, const Model& model, Skin& skin) {
  skin.inverse_binds.resize(skin.joints.size());
  const auto index = cursor.optional_index("accessors", model.accessors.size());
  if (!index) return;
  const Accessor accessor(context, model, *index);
  if (accessor.components() != 16 || !accessor.is_float()) {
    cursor.fail("must be matrices of 4x4 floats", kExportAgain);
  }
  if (accessor.size() < skin.joints.size()) {
    cursor.fail("has " + std::to_string(accessor.size()) + " matrices for " +
                    std::to_string(skin.joints.size()) + " joints",
                kExportAgain);
  }
  for (std::size_t i = 0; i < skin.joints.size(); ++i)
    skin.inverse_binds[i] = read_matrix(cursor, accessor, i);
}

// One JOINTS_n with its WEIGHTS_n.
struct InfluenceSet {
  Accessor joints, weights;
};

Accessor influence(const Context& context, const Cursor& cursor, const Model& model, int index,
                   std::size_t vertices) {
  Accessor accessor(context, model, index);
  if (accessor.components() != 4) cursor.fail("must be of type VEC4", kExportAgain);
  if (accessor.size() != vertices) {
    cursor.fail("has " + std::to_string(accessor.size()) + " elements, POSITION " + std::to_string(vertices),
                kExportAgain);
  }
  return accessor;
}

// `attributes`: of the file, for messages; `primitive` has them unpacked.
std::vector<InfluenceSet> influence_sets(const Context& context, const Cursor& attributes,
                                         const Primitive& primitive, const Model& model,
                                         std::size_t vertices) {
  std::vector<InfluenceSet> sets;
  for (std::size_t n = 0; n <= kMostSets; ++n) {
    const std::string set = std::to_string(n);
    const Cursor joints = attributes.member("JOINTS_" + set), weights = attributes.member("WEIGHTS_" + set);
    if (!joints.present() && !weights.present()) break;
    if (joints.present() != weights.present())
      (joints.present() ? joints : weights)
          .fail(joints.present() ? "has no WEIGHTS beside it" : "has no JOINTS beside it", kExportAgain);
    if (n == kMostSets) joints.fail("is one set of joints too many", "use at most 64 joints a vertex");
    sets.push_back({influence(context, joints, model, primitive.attributes.at("JOINTS_" + set), vertices),
                    influence(context, weights, model, primitive.attributes.at("WEIGHTS_" + set), vertices)});
    const int type = sets.back().joints.component_type();
    if (type != kUnsignedByte && type != kUnsignedShort)
      joints.fail("must be unsigned bytes or shorts", kExportAgain);
  }
  return sets;
}

class InfluenceReader {
 public:
  InfluenceReader(const Cursor& attributes, const std::vector<InfluenceSet>& sets, std::size_t joints,
                  Body& body)
      : attributes_(attributes), sets_(sets), joints_(joints), body_(body) {}

  void add(std::size_t vertex) {
    const std::size_t first = body_.weights.size();
    double sum = 0;
    for (const InfluenceSet& set : sets_)
      for (int c = 0; c < 4; ++c) sum += add_one(set, vertex, c);
    // A vertex that no joint pulls at hangs on its first one.
    if (!(sum > 0)) {
      body_.weights[first] = 1.0f;
      return;
    }
    for (std::size_t i = first; i < body_.weights.size(); ++i)
      body_.weights[i] = static_cast<float>(static_cast<double>(body_.weights[i]) / sum);
  }

 private:
  double add_one(const InfluenceSet& set, std::size_t vertex, int c) {
    const double weight = set.weights.value(vertex, c);
    if (!(weight >= 0 && weight < 1e30))
      attributes_.fail("vertex " + std::to_string(vertex) + " has a weight below 0 or not finite",
                       kExportAgain);
    const auto joint = static_cast<std::size_t>(set.joints.value(vertex, c));
    if (joint >= joints_ && weight > 0)
      attributes_.fail("vertex " + std::to_string(vertex) + " hangs on joint " + std::to_string(joint) +
                           ", but the skin has " + std::to_string(joints_),
                       kExportAgain);
    body_.joints.push_back(joint < joints_ ? static_cast<std::uint32_t>(joint) : 0u);
    body_.weights.push_back(static_cast<float>(weight));
    return static_cast<double>(body_.weights.back());
  }

  const Cursor& attributes_;
  const std::vector<InfluenceSet>& sets_;
  std::size_t joints_;
  Body& body_;
};

}  // namespace

std::vector<exact::Affine> Skin::matrices(std::span<const exact::Affine> to_world) const {
  std::vector<exact::Affine> result;
  for (std::size_t i = 0; i < joints.size(); ++i) result.push_back(to_world[joints[i]] * inverse_binds[i]);
  return result;
}

Skin read_skin(const Context& context, const Document& document, const Model& model, std::size_t number,
               const Placements& placements) {
  const Cursor root = document.root(context);
  const Cursor cursor = root.member("skins").element(number);
  const Cursor joints = cursor.member("joints");
  if (joints.size() == 0) joints.fail("has no joints", kExportAgain);
  cursor.member("skeleton").optional_index("nodes", model.nodes.size());
  Skin skin;
  std::vector<bool> used(placements.tree.size(), false);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int node = joints.element(i).index("nodes", model.nodes.size());
    const int place = placements.place_of[static_cast<std::size_t>(node)];
    if (place < 0)
      joints.element(i).fail("nodes[" + std::to_string(node) + "] is not in the scene", kExportAgain);
    const auto p = static_cast<std::size_t>(place);
    if (used[p]) joints.element(i).fail("nodes[" + std::to_string(node) + "] is a joint twice", kExportAgain);
    used[p] = true;
    skin.joints.push_back(p);
  }
  read_inverse_binds(context, cursor.member("inverseBindMatrices"), model, skin);
  return skin;
}

void read_influences(Context& context, const Cursor& cursor, const Primitive& primitive, const Model& model,
                     std::size_t vertices, std::span<const std::uint32_t> used, std::size_t joints,
                     Body& body) {
  const Cursor attributes = cursor.member("attributes");
  const std::vector<InfluenceSet> sets = influence_sets(context, attributes, primitive, model, vertices);
  if (sets.empty()) {
    context.note(body.shape.name + " has a skin but no JOINTS_0: it stands as its node does.");
    return;
  }
  body.influences = 4 * sets.size();
  InfluenceReader reader(attributes, sets, joints, body);
  for (const std::uint32_t vertex : used) reader.add(vertex);
}

}  // namespace caustics::gltf
