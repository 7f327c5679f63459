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
  Arguments arguments = shot.options;
  if (!shot.layers.empty()) arguments.insert(arguments.end(), {"--aov", shot.layers});
  std::string outputs = " -o " + shot.name + ".png";
  if (!shot.layers.empty()) outputs += " -o " + shot.name + ".exr";
  commands_[shot.name] = "caustics render scenes/" + shot.scene + joined(arguments) + outputs;
  arguments.insert(arguments.begin(), find_scene(shot.scene).string());
  const fs::path stats = file(shot.name, ".json");
  arguments.insert(arguments.end(),
                   {"-o", file(shot.name, ".png").string(), "--stats", stats.string(), "--quiet"});
  if (!shot.layers.empty()) arguments.insert(arguments.end(), {"-o", file(shot.name, ".exr").string()});
  run_render(arguments);
  std::ifstream in(stats);
  stats_[shot.name] = Json::parse(in);
}

void RenderedShots::trace(const Shot& shot) {
  Arguments arguments = shot.options;
  commands_[shot.name] =
      "caustics reference scenes/" + shot.scene + joined(arguments) + " -o " + shot.name + ".exr";
  arguments.insert(arguments.begin(), find_scene(shot.scene).string());
  arguments.insert(arguments.end(), {"-o", file(shot.name, ".exr").string(), "--quiet"});
  run_reference(arguments);
  stats_[shot.name] = nullptr;
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
    std::string channel = wanted;
    channel.append(".").append(1, "RGB"[c]);
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

}  // namespace caustics::app
