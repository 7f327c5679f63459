#include <algorithm>
#include <bit>

#include "app/probe/before_pass.hpp"
#include "app/probe/probes.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/settings/nearest.hpp"

namespace caustics::app {

namespace {

const PlannedPass& find_pass(const RenderedFrame& frame, const std::string& label) {
  std::vector<std::string> names;
  for (const PlannedPass& pass : frame.plan().passes) {
    if (pass.label == label) return pass;
    names.push_back(pass.label);
  }
  throw Error(ExitCode::WrongUsage, "no pass '" + one_line(label) + "' runs here" +
                                        suggestion(label, names, "'caustics plan' lists them"));
}

bool same_bits(const TexelValue& a, const TexelValue& b) {
  return std::bit_cast<std::array<std::uint32_t, 4>>(a) == std::bit_cast<std::array<std::uint32_t, 4>>(b);
}

// What the rendered targets hold there; none of those that nobody needs.
void read_stored(const RenderedFrame& frame, TexelHistory& history) {
  const PlannedPass& pass = *history.pass;
  for (std::size_t i = 0; i < pass.writes.size(); ++i) {
    const ColorWrite& write = pass.definition->writes[i];
    const TexelValue last = history.fragments.empty() ? history.before[i] : history.fragments.back().after[i];
    TexelValue stored = last;
    if (pass.writes[i] >= 0) {
      const Image image = frame.read(pass.writes[i]);
      stored = value_before(write, &image, history.x, history.y);
    }
    history.stored.push_back(stored);
    history.equal = history.equal && same_bits(stored, last);
  }
}

// What the pass's primitives are.
void name_primitives(const RenderedFrame& frame, TexelHistory& history) {
  const DrawSet draws = pass_registry()[static_cast<std::size_t>(history.pass->pass)].draws;
  const auto grid = static_cast<std::uint32_t>(frame.grid_of(history.pass->light));
  history.kind = history.pass->definition->topology == Topology::Triangles ? "triangle" : "primitive";
  if (draws == DrawSet::GridCells) history.kind = "cell", history.columns = grid - 1;
  if (draws == DrawSet::GridVertices) history.kind = "vertex", history.columns = grid;
}

TexelHistory begin_history(const RenderedFrame& frame, const TexelRequest& request) {
  const PlannedPass& pass = find_pass(frame, request.pass);
  TexelHistory history{.pass = &pass, .x = request.texel.first, .y = request.texel.second};
  if (history.x >= pass.width || history.y >= pass.height)
    throw Error(ExitCode::WrongUsage, "--history: " + pass.label + " has " + std::to_string(pass.width) +
                                          "x" + std::to_string(pass.height) + " texels, counted from 0,0");
  name_primitives(frame, history);
  return history;
}

// Of a pass that has just run.
void take_history(const RenderedFrame& frame, const TargetsBefore& before, const PassResult& result,
                  TexelHistory& history) {
  const PlannedPass& pass = *history.pass;
  const PassRun run = frame.prepare(pass);
  for (const Draw& draw : run.draws) {
    const Mesh* mesh = mesh_of(frame, draw);
    history.meshes.push_back(mesh ? mesh->name : std::string());
  }
  for (std::size_t i = 0; i < pass.writes.size(); ++i) {
    const ColorWrite& write = pass.definition->writes[i];
    const bool kept = i < before.colors.size() && !before.colors[i].values.empty();
    history.attachments.push_back(write.name);
    history.channels.push_back(channel_count(write.format));
    history.before.push_back(value_before(write, kept ? &before.colors[i] : nullptr, history.x, history.y));
  }
  history.left_out = result.left_out;
  if (!result.left_out)
    replay_fragments(frame.device(), run, before, {history.x, history.y, 1, 1},
                     [&](const FragmentOnTexel& fragment) { history.fragments.push_back(fragment); });
  read_stored(frame, history);
}

}  // namespace

std::vector<TexelHistory> probe_texels(RenderedFrame& frame, const std::vector<TexelRequest>& request) {
  std::vector<TexelHistory> histories;
  histories.reserve(request.size());
  for (const TexelRequest& each : request) histories.push_back(begin_history(frame, each));
  const auto is_asked = [&](const PlannedPass& pass) {
    return std::any_of(histories.begin(), histories.end(),
                       [&](const TexelHistory& history) { return history.pass == &pass; });
  };
  TargetsBefore before;
  frame.run([&](const PlannedPass& pass, const PassResult& result, std::size_t done, std::size_t total) {
    for (TexelHistory& history : histories)
      if (history.pass == &pass) take_history(frame, before, result, history);
    if (done < total && is_asked(frame.plan().passes[done]))
      before = targets_before(frame, frame.plan().passes[done]);
    return true;
  });
  return histories;
}

}  // namespace caustics::app
