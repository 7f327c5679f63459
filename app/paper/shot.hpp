// One rendering of the paper's rows: what was run, its files, and the numbers in them.
#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/output/image_planes.hpp"
#include "app/shell/command.hpp"

namespace caustics::app {

// A sample scene rendered with options. The same name means the same shot.
struct Shot {
  std::string name;      // of its files, without extension
  std::string scene;     // "glass_sphere.glb"
  Arguments options;     // without outputs
  std::string layers{};  // of an EXR file beside the picture; empty: none
  bool traced = false;   // by `caustics reference`: an EXR file alone, without statistics
};

// The floor seen by an orthographic camera: RGB of a layer, row 0 at the top.
struct FloorLayer {
  int width = 0, height = 0;
  std::vector<std::array<double, 3>> pixels;
  const std::array<double, 3>& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

// Renders shots into a folder, each once.
class Shots {
 public:
  explicit Shots(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Renders unless that is done. Throws Error as `render` does.
  void take(const Shot& shot);
  // The statistics of a shot that was taken (docs/command_line.md, "--stats").
  const nlohmann::ordered_json& stats(const std::string& name) const { return stats_.at(name); }
  // Flux of a ledger's account over the flux that entered, mean of the channels, of a light.
  double share(const std::string& name, const std::string& account, int light = 0) const;
  double flux(const std::string& name, const std::string& account, int channel, int light = 0) const;
  double residual(const std::string& name) const;  // the largest of the lights
  // What these passes took together, whatever light they ran for.
  double milliseconds(const std::string& name, const std::vector<std::string>& passes) const;
  FloorLayer layer(const std::string& name, const std::string& layer) const;
  // Sum of |a - b| over the sum of b, of all channels of a layer.
  double relative_l1(const std::string& a, const std::string& b, const std::string& layer) const;
  // NAME.png: a layer of shots of one view beside that of `truth`, and their differences below
  // (side_by_side.hpp).
  void draw_side_by_side(const std::vector<std::string>& tested, const std::string& truth,
                         const std::string& layer, const std::string& name) const;
  std::filesystem::path file(const std::string& name, const std::string& extension) const;
  // "caustics render scenes/glass_sphere.glb --grid 64 -o sphere.png", as a person would type it.
  std::string command(const std::string& name) const { return commands_.at(name); }

 private:
  void trace(const Shot& shot);

  std::filesystem::path folder_;
  std::map<std::string, nlohmann::ordered_json> stats_;
  std::map<std::string, std::string> commands_;
};

}  // namespace caustics::app
