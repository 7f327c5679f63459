#include "lab/paper/floor_shots.hpp"

#include <algorithm>

namespace caustics::paper {

Shot floor_shot(const std::string& name, const std::string& scene, Options options) {
  options.insert(options.begin(), {"-r", "512x512", "--camera", "floor", "-D", "further.share=1"});
  return {name, scene, options, "direct,caustic"};
}

Shot traced_floor(const std::string& name, const std::string& scene) {
  return {.name = name,
          .scene = scene,
          .options = {"-r", "512x512", "--camera", "floor", "--batches", "64"},
          .traced = true};
}

Shot dumped_shot(const std::string& name, const std::string& scene, int side, const Options& options) {
  Shot shot{.name = name, .scene = scene, .dumped = true};
  shot.options = {"-r", "64x64",        "--grid", std::to_string(side), "--map", std::to_string(side),
                  "-D", "cascades=off", "-D",     "further.share=1"};
  shot.options.insert(shot.options.end(), options.begin(), options.end());
  return shot;
}

std::vector<double> floor_irradiance(const Shots& shots, const std::string& name) {
  const FloorLayer direct = shots.layer(name, "direct"), caustic = shots.layer(name, "caustic");
  std::vector<double> values;
  for (std::size_t i = 0; i < direct.pixels.size(); ++i)
    values.push_back(direct.pixels[i][0] + caustic.pixels[i][0]);
  return values;
}

SphereFloorError sphere_error(const Shots& shots, const std::string& name) {
  return compare_with_sphere(floor_irradiance(shots, name), kSphere, 2.0);
}

bool all_closed(const Shots& shots, const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(),
                     [&](const std::string& n) { return shots.residual(n) < 1e-5; });
}

}  // namespace caustics::paper
