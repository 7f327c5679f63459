#include "app/paper_shots.hpp"

#include <algorithm>
#include <fstream>

#include "app/json.hpp"
#include "app/output/image_file.hpp"
#include "app/output/image_planes.hpp"
#include "app/sample_scenes.hpp"
#include "app/shell/command.hpp"
#include "app/side_by_side.hpp"

namespace caustics::app {

namespace fs = std::filesystem;
using paper::FloorLayer;
using paper::Shot;

namespace {

fs::path find_scene(const std::string& name) {
  for (const std::string& scene : sample_scenes())
    if (fs::path(scene).filename() == name) return scene;
  throw Error(ExitCode::BadInput,
              "the sample scene '" + name + "' is missing; 'scenes/make_scenes.py " + name + "' makes it");
}

std::string joined(const Arguments& words) {
  std::string text;
  for (const std::string& word : words) text.append(" ").append(word);
  return text;
}

Image image_of(const FloorLayer& layer) {
  Image image(Format::RGBA32F, layer.width, layer.height);
  for (int y = 0; y < layer.height; ++y)
    for (int x = 0; x < layer.width; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, layer.height - 1 - y, c) =
            static_cast<float>(layer.at(x, y)[static_cast<std::size_t>(c)]);
  return image;
}

Json json_of(const fs::path& file) {
  std::ifstream in(file);
  return Json::parse(in);
}

[[noreturn]] void lacks_layer(const std::string& shot, const std::string& layer) {
  throw Error(ExitCode::InternalError, "the shot '" + shot + "' has no layer '" + layer + "'");
}

}  // namespace

fs::path RenderedShots::file(const std::string& name, const std::string& extension) const {
  return folder_ / (name + extension);
}

void RenderedShots::take(const Shot& shot) {
  if (stats_.count(shot.name)) return;
  if (shot.traced) return trace(shot);
  try {
    render(shot);
  } catch (const Error& error) {
    if (!shot.on_gl || error.code() != ExitCode::BackendUnavailable) throw;
    stats_[shot.name] = nullptr;
  }
}

void RenderedShots::render(const Shot& shot) {
  Arguments arguments = shot.options;
  if (!shot.layers.empty()) arguments.insert(arguments.end(), {"--aov", shot.layers});
  const bool frames = std::find(arguments.begin(), arguments.end(), "--frames") != arguments.end();
  const std::string stem = shot.name + (frames ? ".%04d" : "");
  Arguments outputs{stem + ".png"};
  if (!shot.layers.empty()) outputs.push_back(stem + ".exr");
  commands_[shot.name] = "caustics render scenes/" + shot.scene + joined(arguments);
  arguments.insert(arguments.begin(), find_scene(shot.scene).string());
  for (const std::string& output : outputs) {
    commands_[shot.name] += " -o " + output;
    arguments.insert(arguments.end(), {"-o", (folder_ / output).string()});
  }
  if (shot.dumped) {
    commands_[shot.name] += " --dump " + shot.name;
    arguments.insert(arguments.end(), {"--dump", (folder_ / shot.name).string()});
  }
  const fs::path stats = file(shot.name, ".json");
  arguments.insert(arguments.end(), {"--stats", stats.string(), "--quiet"});
  run_render(arguments);
  stats_[shot.name] = json_of(stats);
}

void RenderedShots::trace(const Shot& shot) {
  Arguments arguments = shot.options;
  arguments.insert(arguments.end(), {"--physics", "single"});
  commands_[shot.name] =
      "caustics reference scenes/" + shot.scene + joined(arguments) + " -o " + shot.name + ".exr";
  arguments.insert(arguments.begin(), find_scene(shot.scene).string());
  const fs::path stats = file(shot.name, ".json");
  arguments.insert(arguments.end(),
                   {"-o", file(shot.name, ".exr").string(), "--stats", stats.string(), "--quiet"});
  run_reference(arguments);
  stats_[shot.name] = json_of(stats);
}

void RenderedShots::draw_side_by_side(const std::vector<std::string>& tested, const std::string& truth,
                                      const std::string& wanted, const std::string& name) const {
  std::vector<Image> images;
  images.reserve(tested.size());
  for (const std::string& each : tested) images.push_back(image_of(layer(each, wanted)));
  write_png(file(name, ".png"), side_by_side(images, image_of(layer(truth, wanted))));
}

FloorLayer RenderedShots::layer(const std::string& name, const std::string& wanted) const {
  const ImagePlanes planes = read_planes(file(name, ".exr"));
  FloorLayer result;
  for (int c = 0; c < 3; ++c) {
    std::string channel = wanted == "beauty" ? "" : wanted + ".";
    channel += "RGB"[c];
    const auto found = std::find_if(planes.planes.begin(), planes.planes.end(),
                                    [&](const Plane& plane) { return plane.name == channel; });
    if (found == planes.planes.end()) lacks_layer(name, wanted);
    const ChannelView& view = found->view;
    result.width = view.width;
    result.height = view.height;
    result.pixels.resize(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x)
        result.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) +
                      static_cast<std::size_t>(x)][static_cast<std::size_t>(c)] = double(view.at(x, y));
  }
  return result;
}

paper::Texels RenderedShots::attachment(const std::string& name, const std::string& wanted) const {
  const fs::path folder = folder_ / name;
  std::string found;
  // The last pass that wrote it.
  const Json manifest = json_of(folder / "manifest.json");
  for (const auto& each : manifest.at("attachments"))
    if (each.at("attachment") == wanted) found = each.at("file");
  if (found.empty()) lacks_layer(name, wanted);
  const ImagePlanes planes = read_planes(folder / found);
  paper::Texels result;
  for (const Plane& plane : planes.planes) {
    const std::size_t channel = std::string("RGBA").find(plane.name);
    if (channel == std::string::npos) continue;
    result.width = plane.view.width;
    result.height = plane.view.height;
    result.values.resize(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
    for (int y = 0; y < result.height; ++y)
      for (int x = 0; x < result.width; ++x)
        result.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(result.width) +
                      static_cast<std::size_t>(x)][channel] = double(plane.view.at(x, y));
  }
  return result;
}

}  // namespace caustics::app
