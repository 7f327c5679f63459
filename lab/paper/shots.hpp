// What the paper's rows are judged by: renderings of sample scenes, and the numbers in them.
#pragma once
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace caustics::paper {

using Options = std::vector<std::string>;

// A sample scene rendered with options. The same name means the same shot.
struct Shot {
  std::string name;      // of its files, without extension
  std::string scene;     // "glass_sphere.glb"
  Options options = {};  // without outputs
  std::string layers{};  // of an EXR file beside the picture; empty: none
  bool traced = false;   // by `caustics reference`, of the same two surfaces: an EXR file and statistics
  bool dumped = false;   // with every attachment of every pass
  bool on_gl = false;    // by OpenGL; left out where there is none
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

// An attachment of a pass, a texel a grid vertex or a texel of a map.
struct Texels {
  int width = 0, height = 0;
  std::vector<std::array<double, 4>> values;
};

// Shots that were taken. Who takes them, and where they lie, is the program's (app/paper_shots.hpp).
class Shots {
 public:
  virtual ~Shots() = default;

  // The statistics of a shot (docs/command_line.md, "--stats").
  virtual const nlohmann::ordered_json& stats(const std::string& name) const = 0;
  // `beauty` is the plain picture, in nit.
  virtual FloorLayer layer(const std::string& name, const std::string& layer) const = 0;
  // Of a shot that was dumped; `attachment` as the dump's manifest has it: "landing[0]".
  virtual Texels attachment(const std::string& name, const std::string& attachment) const = 0;
  // False of a shot on OpenGL where there is none.
  virtual bool taken(const std::string& name) const = 0;
  // NAME.png: a layer of shots of one view beside that of `truth`, and their differences below.
  virtual void draw_side_by_side(const std::vector<std::string>& tested, const std::string& truth,
                                 const std::string& layer, const std::string& name) const = 0;

  // Flux of a ledger's account over the flux that entered, mean of the channels, of a light.
  double share(const std::string& name, const std::string& account, int light = 0) const;
  double flux(const std::string& name, const std::string& account, int channel, int light = 0) const;
  double residual(const std::string& name) const;  // the largest of the lights
  // What these passes took together, whatever light they ran for; or "processor_milliseconds", on which other
  // programs that run at the time weigh less.
  double milliseconds(const std::string& name, const std::vector<std::string>& passes,
                      const char* clock = "milliseconds") const;
  // What a pass' occlusion query counted, whatever light it ran for.
  double samples_passed(const std::string& name, const std::string& pass) const;
  // Sum of |a - b| over the sum of b, of all channels of a layer.
  double relative_l1(const std::string& a, const std::string& b, const std::string& layer) const;
};

}  // namespace caustics::paper
