// caustics probe: one grid vertex's way through the landing pass, every intermediate value printed.
#include <cstdio>

#include "app/flux.hpp"
#include "app/frame_options.hpp"
#include "app/loaded_scene.hpp"
#include "app/output/light_groups.hpp"
#include "app/probe_texel.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/setting.hpp"

namespace caustics::app {

namespace {

struct ProbeRequest {
  FrameRequest frame;
  int x = -1, y = -1, light = 0, sample = 0;
};

bool parse(const Arguments& arguments, ProbeRequest& request) {
  Parser parser("probe",
                "Follows the light of one grid vertex: what the landing pass reads, every value it\n"
                "computes, and what it stores.",
                "  caustics probe scene.glb --texel 256,256\n"
                "  caustics probe scene.glb --texel 100,60 --light 1 --estimator paper\n");
  std::string scene;
  parser.positional("SCENE", "a glTF 2.0 file, .gltf or .glb", scene);
  parser.group("What to probe");
  parser.option("--texel", "X,Y",
                {"the grid vertex, counted from the left and the bottom", "each 0..grid - 1"},
                [&](const std::string& value) {
                  const Pair texel = parse_pair("--texel", value, {0, setting("grid").most() - 1});
                  request.x = texel.first;
                  request.y = texel.second;
                });
  parser.number("--light", "N", {"the light, as 'caustics plan' numbers them"}, Limits<int>{0, 1'000'000},
                request.light);
  parser.number("--sample", "N", {"which sample of a light with a size"},
                Limits<int>{0, setting("light.samples").most() - 1}, request.sample);
  add_frame_options(parser, request.frame);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  check_request(request.frame, "probe");
  if (request.x < 0) {
    throw Error(ExitCode::WrongUsage, "no grid vertex given; add --texel X,Y");
  }
  return true;
}

// Against the grid that was chosen, where it was.
void check_texel(const ProbeRequest& request, int grid) {
  if (request.x < grid && request.y < grid) return;
  throw Error(ExitCode::WrongUsage, "--texel must be 0.." + std::to_string(grid - 1) +
                                        " in both: the grid has " + std::to_string(grid) +
                                        " vertices a side");
}

const PlannedPass& find_landing(const RenderedFrame& frame, const ProbeRequest& request) {
  const std::vector<int> samples = samples_of(frame.scene(), request.light);
  const int light = samples[static_cast<std::size_t>(request.sample)];
  for (const PlannedPass& pass : frame.plan().passes) {
    if (pass.definition.writes.front().name == kLanding && pass.light == light) return pass;
  }
  throw Error(ExitCode::WrongUsage, "light " + light_label(frame.scene(), request.light) +
                                        " throws no caustic here; 'caustics plan' says why");
}

void check_light(const Scene& scene, const ProbeRequest& request) {
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

void print_values(const std::string& label, const float* values, int count) {
  std::string line = "  " + label;
  line.resize(std::max<std::size_t>(line.size() + 1, 26), ' ');
  for (int i = 0; i < count; ++i) {
    std::string value = significant(static_cast<double>(values[i]), 9);
    value.insert(0, value.size() < 16 ? 16 - value.size() : 1, ' ');
    line += value;
  }
  std::printf("%s\n", line.c_str());
}

// A pass that the grid vertex's light goes through.
struct ProbedPass {
  std::string label;
  ProbedTexel texel;
};

void print_pass(const ProbedTexel& probed) {
  std::printf("\nthis texel of what the pass reads\n");
  for (const NamedValues& v : probed.inputs) print_values(v.name, v.values.data(), v.count);
  std::printf("\nwhat it computes, in order\n");
  for (const NamedValues& v : probed.trace) print_values(v.name, v.values.data(), v.count);
  std::printf("\nwhat it stores\n");
  for (const NamedValues& v : probed.stored) print_values(v.name, v.values.data(), v.count);
  if (probed.stored.front().name != kLanding) return;
  const auto status = static_cast<LandingStatus>(static_cast<int>(probed.stored.front().values[3]));
  std::printf("\nstatus: %s\n", std::string(name_of(status)).c_str());
}

void print_probe(const RenderedFrame& frame, const ProbeRequest& request,
                 const std::vector<ProbedPass>& passes) {
  const int grid = frame.settings().grid;
  std::printf("grid vertex %d,%d of light %s, grid %dx%d; metres, scene space\n", request.x, request.y,
              light_label(frame.scene(), request.light).c_str(), grid, grid);
  bool agree = true;
  for (const ProbedPass& pass : passes) {
    if (frame.effects().further_surfaces.active) std::printf("\n%s\n", pass.label.c_str());
    print_pass(pass.texel);
    agree = agree && pass.texel.agrees;
  }
  if (passes.empty()) std::printf("\nno caster is there\n");
  std::printf("the probe and the rendered %s %s\n", passes.size() == 1 ? "texel" : "texels",
              agree ? "agree to the bit" : "DIFFER");
  if (!agree) throw Error(ExitCode::InternalError, "the probe does not agree with the rendered texel");
}

// Does light of the grid vertex come to this surface?
bool comes_to(const RenderedFrame& frame, const PlannedPass& pass, int x, int y) {
  if (pass.definition.reads.front().name != "path_start") return true;
  return frame.read(pass.reads.front()).at(x, y, 3) != 0.0f;
}

}  // namespace

ExitCode run_probe(const Arguments& arguments) {
  ProbeRequest request;
  if (!parse(arguments, request)) return ExitCode::Done;
  std::unique_ptr<LoadedScene> loaded = load_scene(request.frame);
  check_light(loaded->scene(), request);
  RenderedFrame frame(request.frame, std::move(loaded), {{kLanding}});
  check_texel(request, frame.settings().grid);
  const PlannedPass& landing = find_landing(frame, request);
  std::vector<ProbedPass> probed;
  // As soon as each is drawn: later passes may take the memory of what it read.
  frame.run([&](const PlannedPass& pass, const PassResult&, std::size_t, std::size_t) {
    const bool on_the_way = pass.light == landing.light && pass.surface > 0;
    if (&pass != &landing && !on_the_way) return true;
    if (on_the_way && !comes_to(frame, pass, request.x, request.y)) return true;
    ProbedTexel texel = probe_texel(frame, pass, request.x, request.y);
    if (!texel.discarded) probed.push_back({pass.label, std::move(texel)});
    return true;
  });
  print_probe(frame, request, probed);
  return ExitCode::Done;
}

}  // namespace caustics::app
