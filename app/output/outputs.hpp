// What `render` writes: pictures, layers, and the textures that they need.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/flux.hpp"
#include "app/shell/parser.hpp"

namespace caustics::app {

struct OutputRequest {
  std::vector<std::filesystem::path> files;  // .png or .exr, or a film's
  std::vector<std::string> layers;           // of --aov, checked
};

// The layers of "caustic,direct"; throws Error (WrongUsage) naming the nearest of an unknown one.
std::vector<std::string> parse_layers(const std::string& list);
// Lists names and meanings in the help.
void list_layers(Parser& parser);

// Refuses unknown extensions and two outputs of one name (WrongUsage), and what cannot be written.
void check_outputs(const OutputRequest& request);
// The textures that the files are made from.
std::vector<std::string> textures_for(const OutputRequest& request);

// Those that are one file a frame; films are left to their writers (app/output/video_file.hpp).
// `ledgers`: for the layer `error`; needed where wants_ledgers.
void write_outputs(const OutputRequest& request, const RenderedFrame& frame,
                   const std::vector<LightLedger>& ledgers);
bool wants_ledgers(const OutputRequest& request);

}  // namespace caustics::app
