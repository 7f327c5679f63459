// What probe says of a grid vertex, of a texel's history and of a pixel's light: as text and as JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/frame.hpp"
#include "app/probe/pixel_light.hpp"
#include "app/probe/probe_texel.hpp"
#include "raster/texel_history.hpp"

namespace caustics::app {

// A grid vertex's light, pass by pass.
struct ProbedVertex {
  int x = 0, y = 0, source = 0;                               // of the grid; index into Scene::sources
  std::vector<std::pair<std::string, ProbedTexel>> passes{};  // label, values
};
bool agrees(const ProbedVertex& vertex);
void print(const RenderedFrame& frame, const ProbedVertex& vertex);
nlohmann::ordered_json json_of(const ProbedVertex& vertex);

// A texel of a pass's targets, fragment by fragment.
struct TexelHistory {
  const PlannedPass* pass = nullptr;
  int x = 0, y = 0;
  std::vector<std::string> attachments{};  // names of the colours
  std::vector<int> channels{};             // of each
  std::vector<TexelValue> before{}, stored{};
  std::vector<std::string> meshes{};  // by draw
  std::string kind{};                 // of primitive: "triangle", "cell", "vertex"
  std::uint32_t columns = 0;          // of the grid's cells or vertices; 0: primitives are not of the grid
  std::vector<FragmentOnTexel> fragments{};
  bool left_out = false;  // nothing was drawn: no light reached it
  bool equal = true;      // the last value is the rendered one, to the bit
};
inline bool agrees(const TexelHistory& history) { return history.equal; }
void print(const TexelHistory& history);
nlohmann::ordered_json json_of(const TexelHistory& history);

struct ProbedPixel {
  int x = 0, y = 0;   // from the left and the top
  std::string shows;  // what the camera sees there
  std::array<float, 3> beauty{}, picture{};
  std::vector<LightOnPixel> lights{};
};
bool agrees(const ProbedPixel& pixel);
void print(const RenderedFrame& frame, const ProbedPixel& pixel);
nlohmann::ordered_json json_of(const RenderedFrame& frame, const ProbedPixel& pixel);

}  // namespace caustics::app
