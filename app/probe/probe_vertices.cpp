#include "app/flux.hpp"
#include "app/output/light_groups.hpp"
#include "app/probe/probes.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

// Against the grid that was chosen, where it was.
void check_vertex(const Pair& vertex, int grid) {
  if (vertex.first < grid && vertex.second < grid) return;
  throw Error(ExitCode::WrongUsage, "--texel must be 0.." + std::to_string(grid - 1) +
                                        " in both: the grid has " + std::to_string(grid) +
                                        " vertices a side");
}

const PlannedPass& find_landing(const RenderedFrame& frame, const VertexRequest& request) {
  const std::vector<int> samples = samples_of(frame.scene(), request.light);
  const int light = samples[static_cast<std::size_t>(request.sample)];
  for (const PlannedPass& pass : frame.plan().passes) {
    if (pass.light == light && !pass.definition->writes.empty() &&
        pass.definition->writes.front().name == kLanding)
      return pass;
  }
  if (frame.effects().lights[static_cast<std::size_t>(samples.front())].size_is_drawn)
    throw Error(ExitCode::WrongUsage, "light " + light_label(frame.scene(), request.light) +
                                          " has one caustic for all of its samples; leave out --sample");
  throw Error(ExitCode::WrongUsage, "light " + light_label(frame.scene(), request.light) +
                                        " throws no caustic here; 'caustics plan' says why");
}

}  // namespace

void check_light(const Scene& scene, const VertexRequest& request) {
  const std::size_t lights = scene.sources.size();
  if (static_cast<std::size_t>(request.light) >= lights) {
    throw Error(ExitCode::WrongUsage, "--light must be 0.." + std::to_string(lights - 1) +
                                          ": the scene has " + std::to_string(lights) + " lights");
  }
  const std::size_t samples = samples_of(scene, request.light).size();
  if (static_cast<std::size_t>(request.sample) >= samples) {
    throw Error(ExitCode::WrongUsage, "--sample must be 0.." + std::to_string(samples - 1) + ": light " +
                                          light_label(scene, request.light) + " has " +
                                          std::to_string(samples) + (samples == 1 ? " sample" : " samples"));
  }
}

std::vector<ProbedVertex> probe_vertices(RenderedFrame& frame, const VertexRequest& request) {
  std::vector<ProbedVertex> probed;
  for (const Pair& vertex : request.vertices) {
    check_vertex(vertex, frame.grid_of(samples_of(frame.scene(), request.light).front()));
    probed.push_back({vertex.first, vertex.second, request.light});
  }
  const PlannedPass& landing = find_landing(frame, request);
  // As soon as each is drawn: later passes may take the memory of what it read.
  frame.run([&](const PlannedPass& pass, const PassResult&, std::size_t, std::size_t) {
    if (pass.pass != landing.pass || pass.drawn_for != landing.drawn_for || pass.light != landing.light)
      return true;
    const ProbedPass probe(frame, pass);
    for (ProbedVertex& vertex : probed) {
      ProbedTexel texel = probe.at(vertex.x, vertex.y);
      if (!texel.discarded) vertex.passes.emplace_back(pass.label, std::move(texel));
    }
    return true;
  });
  return probed;
}

}  // namespace caustics::app
