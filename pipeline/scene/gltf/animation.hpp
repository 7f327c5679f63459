// An animation of the file: which property of which node follows which keyframes.
// Source: glTF 2.0 section 3.11.
#pragma once
#include <optional>

#include "pipeline/scene/gltf/model.hpp"
#include "pipeline/scene/keyframes.hpp"

namespace caustics::gltf {

enum class Property : std::uint8_t { Translation, Rotation, Scale, Weights };

struct Channel {
  std::size_t node = 0;
  Property property = Property::Translation;
  Keyframes keys;
};

struct Animation {
  std::vector<Channel> channels;
  double duration = 0.0;  // seconds: the last moment of any channel
};

// The number of the animation that LoadOptions::animation names, the first by default; none where the file
// has none or "none" is asked for. Throws Error (WrongUsage) for an unknown name.
std::optional<std::size_t> chosen_animation(const Context& context, const Document& document);

// The chosen animation. Channels without a node, and those of properties that are no node's, are
// left out with a note. Fails on what no animation may be (BadInput); an unknown name is WrongUsage.
std::optional<Animation> read_animation(Context& context, const Document& document, const Model& model);

}  // namespace caustics::gltf
