// What `render` writes: pictures, layers, and the textures that they need.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/flux.hpp"
#include "app/shell/parser.hpp"

namespace caustics::app {

// By its name: display values as a screen shows them, linear light, or a film.
enum class OutputKind { Unknown, Display, Linear, Film };
OutputKind output_kind(const std::filesystem::path& file);
// ".png, .jpg, ...", films too.
std::string known_outputs();

struct OutputRequest {
  std::vector<std::filesystem::path> files;  // of every kind but Unknown
  std::vector<std::string> layers;           // of --aov, checked
};

// The layers of "caustic,direct"; throws Error (WrongUsage) naming the nearest of an unknown one.
std::vector<std::string> parse_layers(const std::string& list);
// Lists names and meanings in the help.
void list_layers(Parser& parser);

// Refuses unknown extensions, and layers without a file for them (WrongUsage).
void check_outputs(const OutputRequest& request);
// Are all of them to be looked at, and none to be calculated with?
bool are_for_display(const OutputRequest& request);
// The textures that the files are made from.
std::vector<std::string> textures_for(const OutputRequest& request);

// Those that are one file a frame; films are left to their writers (app/output/video_file.hpp).
// `ledgers`: for the layer `error`; needed where wants_ledgers.
void write_outputs(const OutputRequest& request, const RenderedFrame& frame,
                   const std::vector<LightLedger>& ledgers);
bool wants_ledgers(const OutputRequest& request);

// What is written beside the files of a request.
struct WrittenBeside {
  bool stats = false, dumped = false;
  bool pictures = false;  // of the dump
};
// What writing takes beside the textures that the files are made from, in bytes (FrameCost::outputs).
std::uint64_t writing_bytes(const PlannedFrame& frame, const OutputRequest& request,
                            const WrittenBeside& beside = {});

}  // namespace caustics::app
