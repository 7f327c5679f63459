#include "pipeline/measure/frame_time.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// A pass as it is found again in another plan: exactly, or as one of its instances, which have no light here.
using Instance = std::tuple<int, const DrawnFor*, int, int>;
Instance exactly(const PlannedPass& pass) { return {pass.pass, pass.drawn_for, pass.light, pass.branch}; }
Instance any_like(const PlannedPass& pass) { return {pass.pass, pass.drawn_for, -2, -2}; }
Instance any_of(const PlannedPass& pass) { return {pass.pass, nullptr, -2, -2}; }

double texels_of(const PlannedPass& pass) {
  return static_cast<double>(pass.width) * static_cast<double>(pass.height);
}

// Sums over the passes that are alike.
struct Cost {
  double texels = 0.0, vertices = 0.0;
  double of_vertices = 0.0, of_fragments = 0.0;  // milliseconds
  int count = 0;
};

// The grid's vertices where the pass draws as many, or cells of them; else 1: what it draws does not grow.
double grid_vertices(const PlannedPass& pass, const LightSettings& settings) {
  const double grid = settings[pass.light].grid;
  // Rectangles, and points that no mesh has, are of the grid.
  const bool of_grid = pass.light >= 0 && pass.definition->topology != Topology::Triangles;
  return of_grid ? grid * grid : 1.0;
}

double cheapest(const std::vector<PassResult>& results) {
  constexpr std::size_t kShare = 10;  // the tenth part are the cheapest
  std::vector<double> times;
  times.reserve(results.size());
  for (const PassResult& result : results) times.push_back(result.processor_milliseconds);
  if (times.empty()) return 0.0;
  const auto nth = times.begin() + static_cast<std::ptrdiff_t>(times.size() / kShare);
  std::nth_element(times.begin(), nth, times.end());
  return *nth;
}

}  // namespace

double expected_milliseconds(const SizedFrame& frame, const SizedFrame& smaller,
                             const std::vector<PassResult>& results) {
  const double each = cheapest(results);
  const LightSettings settings(frame.settings, frame.effects),
      smaller_settings(smaller.settings, smaller.effects);
  std::map<Instance, Cost> costs;
  for (std::size_t i = 0; i < results.size() && i < smaller.plan.passes.size(); ++i) {
    const PlannedPass& pass = smaller.plan.passes[i];
    const PassResult& result = results[i];
    const auto vertices = static_cast<double>(result.vertices),
               all = vertices + static_cast<double>(result.fragments);
    const double share = all > 0.0 ? vertices / all : 0.0;
    const double beyond = std::max(0.0, result.processor_milliseconds - each);
    for (const Instance& instance : {exactly(pass), any_like(pass), any_of(pass)}) {
      Cost& cost = costs[instance];
      cost.texels += texels_of(pass);
      cost.vertices += grid_vertices(pass, smaller_settings);
      cost.of_vertices += share * beyond;
      cost.of_fragments += (1.0 - share) * beyond;
      ++cost.count;
    }
  }
  double sum = 0.0;
  for (const PlannedPass& pass : frame.plan.passes) {
    sum += each;
    for (const Instance& instance : {exactly(pass), any_like(pass), any_of(pass)}) {
      const auto found = costs.find(instance);
      if (found == costs.end()) continue;
      const Cost& cost = found->second;
      sum += cost.of_vertices * grid_vertices(pass, settings) / cost.vertices +
             cost.of_fragments * texels_of(pass) / cost.texels;
      break;
    }
  }
  return sum;
}

}  // namespace caustics
