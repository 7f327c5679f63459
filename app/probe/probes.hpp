// The three things that probe looks at, each of them in a frame of its own. They throw Error (WrongUsage) for
// what the frame does not have.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/frame_options.hpp"
#include "app/loaded_scene.hpp"
#include "app/probe/texel_report.hpp"
#include "app/shell/parser.hpp"

namespace caustics::app {

// Grid vertices of one light, and of one of its samples.
struct VertexRequest {
  std::vector<Pair> vertices{};
  int light = 0, sample = 0;
};
std::vector<ProbedVertex> probe_vertices(RenderedFrame& frame, const VertexRequest& request);
// Before there is a frame: is there such a light?
void check_light(const Scene& scene, const VertexRequest& request);

// Texels of passes, by the passes' labels.
struct TexelRequest {
  std::string pass;
  Pair texel;
};
std::vector<TexelHistory> probe_texels(RenderedFrame& frame, const std::vector<TexelRequest>& request);

// Pixels from the left and the top. The frame's goal must have what goal_of_pixels names.
PlanGoal goal_of_pixels();
std::vector<ProbedPixel> probe_pixels(RenderedFrame& frame, const std::vector<Pair>& pixels);

}  // namespace caustics::app
