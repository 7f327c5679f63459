// Layers of an image: channels whose names share what stands before the last dot.
#pragma once
#include <string>
#include <vector>

#include "app/output/image_planes.hpp"

namespace caustics::app {

// "caustic" of "caustic.R"; "" of "R".
std::string layer_of(const std::string& channel);
// "R" of both.
std::string channel_in_layer(const std::string& channel);
// R, G or B.
bool is_color(const std::string& channel);

// In the order of the channels, each once.
std::vector<std::string> layers_of(const ImagePlanes& image);

// Leaves the channels of one layer. The layer without a name is called "beauty", as in --aov, where
// none is really called so. Throws Error (BadInput), which names the file and its layers.
void keep_layer(ImagePlanes& image, const std::string& layer, const std::string& file);

}  // namespace caustics::app
