#include "pipeline/scene/gltf/animation.hpp"

#include <algorithm>
#include <set>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/gltf/accessor.hpp"
#include "pipeline/scene/gltf/morph.hpp"

namespace caustics::gltf {

namespace {

const char* kFix = "export the file again, or show it at rest with --animation none";

[[noreturn]] void unknown_animation(const Context& context, const Cursor& all) {
  std::string line = printable(context.path().string(), 400) + ": there is no animation '" +
                     printable(context.options().animation, 60) + "'";
  if (all.size() == 0) throw Error(ExitCode::WrongUsage, line + "; the file has none");
  line += "; there are " + std::to_string(all.size()) + ":";
  for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 8); ++i)
    line += " " + std::to_string(i) + " '" + printable(all.element(i).member("name").string(""), 40) + "'";
  throw Error(ExitCode::WrongUsage, line);
}

// By name, or else by number.
std::optional<std::size_t> choose(const Context& context, const Cursor& all) {
  const std::string& wanted = context.options().animation;
  if (wanted.empty()) return all.size() > 0 ? std::optional<std::size_t>(0) : std::nullopt;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all.element(i).member("name").string("") == wanted) return i;
  if (wanted == "none") return std::nullopt;
  if (wanted.find_first_not_of("0123456789") == std::string::npos && wanted.size() < 8) {
    const auto number = static_cast<std::size_t>(std::stoi(wanted));
    if (number < all.size()) return number;
  }
  unknown_animation(context, all);
}

class AnimationReader {
 public:
  AnimationReader(Context& context, const Document& document, const Model& model)
      : context_(context), document_(document), model_(model) {}

  Animation read(const Cursor& cursor) {
    Animation animation;
    const Cursor channels = cursor.member("channels"), samplers = cursor.member("samplers");
    if (channels.size() == 0) context_.note("The animation has no channels.");
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (auto channel = read_channel(channels.element(i), samplers)) {
        animation.duration = std::max(animation.duration, static_cast<double>(channel->keys.times.back()));
        animation.channels.push_back(std::move(*channel));
      }
    }
    return animation;
  }

 private:
  std::optional<Channel> read_channel(const Cursor& cursor, const Cursor& samplers);
  bool is_property(const Cursor& path, Channel& channel);
  void check_target(const Cursor& target, const Channel& channel);
  Keyframes read_keys(const Cursor& sampler, const Channel& channel);
  KeyframeInterpolation interpolation(const Cursor& cursor);
  std::size_t width(const Channel& channel);
  void read_times(const Cursor& cursor, Keyframes& keys);
  void read_values(const Cursor& cursor, const Channel& channel, Keyframes& keys);
  void spend(const Cursor& cursor, std::uint64_t values);

  Context& context_;
  const Document& document_;
  const Model& model_;
  std::set<std::pair<std::size_t, Property>> taken_;
  std::uint64_t values_ = 0;
};

std::optional<Channel> AnimationReader::read_channel(const Cursor& cursor, const Cursor& samplers) {
  const Cursor target = cursor.member("target");
  const int sampler = cursor.member("sampler").index("samplers", samplers.size());
  const auto node = target.member("node").optional_index("nodes", model_.nodes.size());
  Channel channel;
  if (!is_property(target.member("path"), channel)) return std::nullopt;
  if (!node) {
    context_.note("Channels of the animation that have no node are ignored.");
    return std::nullopt;
  }
  channel.node = static_cast<std::size_t>(*node);
  check_target(target, channel);
  channel.keys = read_keys(samplers.element(static_cast<std::size_t>(sampler)), channel);
  return channel;
}

// False for what extensions animate.
bool AnimationReader::is_property(const Cursor& path, Channel& channel) {
  const std::string name = path.string();
  if (name == "translation")
    channel.property = Property::Translation;
  else if (name == "rotation")
    channel.property = Property::Rotation;
  else if (name == "scale")
    channel.property = Property::Scale;
  else if (name == "weights")
    channel.property = Property::Weights;
  else {
    context_.note("Animated properties of the kind '" + name + "' stay as they are.");
    return false;
  }
  return true;
}

void AnimationReader::check_target(const Cursor& target, const Channel& channel) {
  if (!taken_.insert({channel.node, channel.property}).second)
    target.fail("is the target of two channels", kFix);
  const bool matrix = model_.nodes[channel.node].matrix.size() == 16;
  if (matrix && channel.property != Property::Weights)
    target.fail("nodes[" + std::to_string(channel.node) + "] has a matrix, which cannot be animated",
                "export it with translation, rotation and scale");
}

KeyframeInterpolation AnimationReader::interpolation(const Cursor& cursor) {
  const std::string name = cursor.string("LINEAR");
  if (name == "STEP") return KeyframeInterpolation::Step;
  if (name == "LINEAR") return KeyframeInterpolation::Linear;
  if (name == "CUBICSPLINE") return KeyframeInterpolation::CubicSpline;
  cursor.fail("is \"" + printable(name, 40) + "\"", "use STEP, LINEAR or CUBICSPLINE");
}

std::size_t AnimationReader::width(const Channel& channel) {
  if (channel.property == Property::Rotation) return 4;
  if (channel.property != Property::Weights) return 3;
  const auto mesh = document_.root(context_)
                        .member("nodes")
                        .element(channel.node)
                        .member("mesh")
                        .optional_index("meshes", model_.meshes.size());
  return mesh ? target_count(context_, document_, static_cast<std::size_t>(*mesh)) : 0;
}

void AnimationReader::spend(const Cursor& cursor, std::uint64_t values) {
  const std::uint64_t most = context_.options().max_animation_values;
  if (values > most - values_)
    cursor.fail("the animation has more than " + std::to_string(most) + " values", "shorten it");
  values_ += values;
}

void AnimationReader::read_times(const Cursor& cursor, Keyframes& keys) {
  const Accessor accessor(context_, model_, cursor.index("accessors", model_.accessors.size()));
  if (accessor.components() != 1 || !accessor.is_float()) cursor.fail("must be floats of type SCALAR", kFix);
  spend(cursor, accessor.size());
  for (std::size_t i = 0; i < accessor.size(); ++i) {
    const auto time = static_cast<float>(accessor.value(i, 0));
    if (!(time >= 0.0f && time <= 1e9f))
      cursor.fail("time " + std::to_string(i) + " is below 0, above 1e9 s, or not a number", kFix);
    if (i > 0 && !(time > keys.times.back()))
      cursor.fail("time " + std::to_string(i) + " is not later than the one before", kFix);
    keys.times.push_back(time);
  }
}

void AnimationReader::read_values(const Cursor& cursor, const Channel& channel, Keyframes& keys) {
  const Accessor accessor(context_, model_, cursor.index("accessors", model_.accessors.size()));
  const bool weights = channel.property == Property::Weights;
  const int components = weights ? 1 : static_cast<int>(keys.width);
  const bool plain = channel.property == Property::Translation || channel.property == Property::Scale;
  const bool integer = !accessor.is_float();
  if (accessor.components() != components || (integer && (plain || !accessor.normalized())))
    cursor.fail("has the wrong type for what it animates", kFix);
  const std::size_t a_key =
      (weights ? keys.width : 1) * (keys.interpolation == KeyframeInterpolation::CubicSpline ? 3 : 1);
  if (accessor.size() / a_key != keys.times.size() || accessor.size() % a_key != 0)
    cursor.fail("has " + std::to_string(accessor.size()) + " values for " +
                    std::to_string(keys.times.size()) + " moments of " + std::to_string(a_key),
                kFix);
  spend(cursor, accessor.size() * static_cast<std::uint64_t>(components));
  for (std::size_t i = 0; i < accessor.size(); ++i)
    for (int c = 0; c < components; ++c) {
      const double value = accessor.value(i, c);
      if (!(value > -1e30 && value < 1e30))
        cursor.fail("value " + std::to_string(i) + " is not finite, or beyond 1e30", kFix);
      keys.values.push_back(static_cast<float>(value));
    }
}

Keyframes AnimationReader::read_keys(const Cursor& sampler, const Channel& channel) {
  Keyframes keys;
  keys.interpolation = interpolation(sampler.member("interpolation"));
  keys.rotation = channel.property == Property::Rotation;
  keys.width = width(channel);
  if (keys.width == 0)
    sampler.fail(
        "animates weights of nodes[" + std::to_string(channel.node) + "], which has no morph targets", kFix);
  read_times(sampler.member("input"), keys);
  read_values(sampler.member("output"), channel, keys);
  return keys;
}

}  // namespace

std::optional<std::size_t> chosen_animation(const Context& context, const Document& document) {
  return choose(context, document.root(context).member("animations"));
}

std::optional<Animation> read_animation(Context& context, const Document& document, const Model& model) {
  const Cursor all = document.root(context).member("animations");
  const auto chosen = chosen_animation(context, document);
  if (!chosen) return std::nullopt;
  if (all.size() > 1 && context.options().animation.empty())
    context.note("The file has " + std::to_string(all.size()) + " animations; the first one is shown.");
  return AnimationReader(context, document, model).read(all.element(*chosen));
}

}  // namespace caustics::gltf
