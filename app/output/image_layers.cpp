#include "app/output/image_layers.hpp"

#include <algorithm>

#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

constexpr const char* kNameless = "beauty";

bool has(const std::vector<std::string>& layers, const std::string& layer) {
  return std::find(layers.begin(), layers.end(), layer) != layers.end();
}

// "it has beauty, caustic", cut where a file has very many.
std::string listed(const std::vector<std::string>& layers) {
  std::string text = "it has ";
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (i == 16) return text + ", ...";
    const std::string name = layers[i].empty() ? kNameless : one_line(layers[i], 40);
    text += (i == 0 ? "" : ", ") + name;
  }
  return text;
}

}  // namespace

std::string layer_of(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  return dot == std::string::npos ? "" : channel.substr(0, dot);
}

std::string channel_in_layer(const std::string& channel) { return channel.substr(channel.rfind('.') + 1); }

bool is_color(const std::string& channel) {
  const std::string name = channel_in_layer(channel);
  return name == "R" || name == "G" || name == "B";
}

std::vector<std::string> layers_of(const ImagePlanes& image) {
  std::vector<std::string> layers;
  for (const Plane& plane : image.planes) {
    const std::string layer = layer_of(plane.name);
    if (!has(layers, layer)) layers.push_back(layer);
  }
  return layers;
}

void keep_layer(ImagePlanes& image, const std::string& layer, const std::string& file) {
  const std::vector<std::string> layers = layers_of(image);
  const std::string wanted = layer == kNameless && !has(layers, layer) ? "" : layer;
  if (!has(layers, wanted)) {
    throw Error(ExitCode::BadInput, file + ": has no layer " + in_quotes(layer) + "; " + listed(layers));
  }
  std::erase_if(image.planes, [&](const Plane& plane) { return layer_of(plane.name) != wanted; });
}

}  // namespace caustics::app
