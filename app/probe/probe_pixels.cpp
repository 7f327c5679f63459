#include <optional>

#include "app/flux.hpp"
#include "app/probe/probes.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

std::array<float, 3> color_at(const RenderedFrame& frame, const std::string& texture, int x, int y) {
  const ImageView image = frame.look_at(texture);
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

// How far in front of the camera the surface of a texture lies; none where it has none there.
std::optional<double> depth_at(const RenderedFrame& frame, const std::string& texture, int x, int y) {
  if (!frame.has(texture)) return {};
  const ImageView image = frame.look_at(texture);
  if (image.at(x, y, 3) == 0.0f) return {};
  const View& camera = frame.inputs().camera;
  return glm::dot(glm::dvec3(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)) - camera.origin,
                  camera.forward);
}

// What the camera sees at a pixel, as far as its light is told.
std::string seen_at(const RenderedFrame& frame, int x, int y) {
  const std::optional<double> caster =
      depth_at(frame, std::string(casters_beyond_panes(frame.effects())), x, y);
  const std::optional<double> surface = depth_at(frame, "view_position", x, y);
  if (caster && (!surface || *caster < *surface))
    return "glass or metal; the light below is that of the surface straight behind it";
  return surface ? "a surface" : "nothing but what is all around";
}

}  // namespace

PlanGoal goal_of_pixels() {
  PlanGoal goal = goal_with_ledgers({"picture", "view_position", std::string(kCastersBeyondPanes)});
  goal.beside.emplace_back("caster_position.camera");
  return goal;
}

std::vector<ProbedPixel> probe_pixels(RenderedFrame& frame, const std::vector<Pair>& pixels) {
  const int width = frame.settings().width, height = frame.settings().height;
  std::vector<Pair> from_below;
  for (const Pair& pixel : pixels) {
    if (pixel.first >= width || pixel.second >= height)
      throw Error(ExitCode::WrongUsage, "--pixel must be 0.." + std::to_string(width - 1) + ",0.." +
                                            std::to_string(height - 1) + ": the picture has " +
                                            std::to_string(width) + "x" + std::to_string(height) + " pixels");
    from_below.push_back({pixel.first, height - 1 - pixel.second});
  }
  std::vector<std::vector<LightOnPixel>> lights = light_on_pixels(frame, from_below);
  std::vector<ProbedPixel> probed;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto [x, y] = from_below[i];
    probed.push_back({.x = x,
                      .y = pixels[i].second,
                      .shows = seen_at(frame, x, y),
                      .beauty = color_at(frame, "beauty", x, y),
                      .picture = color_at(frame, "picture", x, y),
                      .lights = std::move(lights[i])});
  }
  return probed;
}

}  // namespace caustics::app
