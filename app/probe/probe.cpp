// caustics probe: one grid vertex's way through the landing pass, every intermediate value printed; one texel
// of any pass, every fragment that fell on it; one pixel, where its light comes from.
#include <algorithm>
#include <bit>
#include <cstdio>
#include <optional>

#include "app/flux.hpp"
#include "app/frame_options.hpp"
#include "app/json.hpp"
#include "app/loaded_scene.hpp"
#include "app/output/light_groups.hpp"
#include "app/output/stats.hpp"
#include "app/probe/before_pass.hpp"
#include "app/probe/texel_report.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/nearest.hpp"
#include "pipeline/settings/setting.hpp"

namespace caustics::app {

namespace {

struct ProbeRequest {
  FrameRequest frame;
  std::optional<Pair> vertex, pixel, texel;
  std::string pass;  // of `texel`
  int light = 0, sample = 0;
  bool json = false;
};

// "PASS:X,Y"; a pass's label may have colons.
void parse_history(const std::string& value, ProbeRequest& request) {
  const std::size_t split = value.rfind(':');
  if (split == std::string::npos || split == 0)
    throw Error(ExitCode::WrongUsage, "--history cannot be '" + one_line(value) +
                                          "': a pass and a texel, as in caustic_cells[sun]:200,100");
  request.pass = value.substr(0, split);
  request.texel = parse_pair("--history", value.substr(split + 1), {0, 16383});
}

bool parse(const Arguments& arguments, ProbeRequest& request) {
  Parser parser("probe",
                "Follows the light of one grid vertex: what the landing pass reads, every value it\n"
                "computes, and what it stores. Or tells where a pixel of the picture gets its light,\n"
                "or every fragment that fell on a texel of a pass, in the order drawn.",
                "  caustics probe scene.glb --texel 256,256\n"
                "  caustics probe scene.glb --texel 100,60 --light 1 --estimator paper\n"
                "  caustics probe scene.glb --pixel 640,500\n"
                "  caustics probe scene.glb --history 'caustic_cells[sun]:200,100' --json\n");
  std::string scene;
  parser.positional("SCENE", "a glTF 2.0 file, .gltf or .glb", scene);
  parser.group("What to probe");
  parser.option("--texel", "X,Y",
                {"the grid vertex, counted from the left and the bottom", "each 0..grid - 1"},
                [&](const std::string& value) {
                  request.vertex = parse_pair("--texel", value, {0, setting("grid").most() - 1});
                });
  parser.option("--pixel", "X,Y", {"the pixel, counted from the left and the top, as image viewers do"},
                [&](const std::string& value) {
                  request.pixel = parse_pair("--pixel", value, {0, 16383});
                });
  parser.option("--history", "PASS:X,Y",
                {"a pass, named as 'caustics plan' does, and a texel of its targets, counted from the left "
                 "and the bottom"},
                [&](const std::string& value) { parse_history(value, request); });
  parser.number("--light", "N", {"of --texel: the light, as 'caustics plan' numbers them"},
                Limits<int>{0, 1'000'000}, request.light);
  parser.number("--sample", "N", {"of --texel: which sample of a light with a size"},
                Limits<int>{0, setting("light.samples").most() - 1}, request.sample);
  parser.flag("--json", request.json, "one JSON document instead of the text");
  add_frame_options(parser, request.frame);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  check_request(request.frame, "probe");
  const int asked = request.vertex.has_value() + request.pixel.has_value() + request.texel.has_value();
  if (asked == 0)
    throw Error(ExitCode::WrongUsage,
                "no grid vertex given; add --texel X,Y (or --pixel X,Y, or --history PASS:X,Y)");
  if (asked > 1)
    throw Error(ExitCode::WrongUsage, "--texel, --pixel and --history exclude each other; give one");
  if (!request.vertex && request.frame.backend.backend != Backend::Software)
    throw Error(ExitCode::WrongUsage,
                "--pixel and --history draw texels again by the software device; leave out --backend");
  return true;
}

void say(const ProbeRequest& request, const Json& json) {
  if (request.json) std::fputs(json_text(json).c_str(), stdout);
}

void require(bool agrees) {
  if (!agrees) throw Error(ExitCode::InternalError, "the probe does not agree with the rendered texel");
}

// Against the grid that was chosen, where it was.
void check_vertex(const Pair& vertex, int grid) {
  if (vertex.first < grid && vertex.second < grid) return;
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

// Does light of the grid vertex come to this surface?
bool comes_to(const RenderedFrame& frame, const PlannedPass& pass, int x, int y) {
  if (pass.definition.reads.front().name != "path_start") return true;
  return frame.read(pass.reads.front()).at(x, y, 3) != 0.0f;
}

void probe_vertex(const ProbeRequest& request, std::unique_ptr<LoadedScene> loaded) {
  check_light(loaded->scene(), request);
  RenderedFrame frame(request.frame, std::move(loaded), {{kLanding}});
  check_vertex(*request.vertex, frame.settings().grid);
  const PlannedPass& landing = find_landing(frame, request);
  ProbedVertex vertex{request.vertex->first, request.vertex->second, request.light};
  // As soon as each is drawn: later passes may take the memory of what it read.
  frame.run([&](const PlannedPass& pass, const PassResult&, std::size_t, std::size_t) {
    const bool on_the_way = pass.light == landing.light && pass.surface > 0;
    if (&pass != &landing && !on_the_way) return true;
    if (on_the_way && !comes_to(frame, pass, vertex.x, vertex.y)) return true;
    ProbedTexel texel = ProbedPass(frame, pass).at(vertex.x, vertex.y);
    if (!texel.discarded) vertex.passes.emplace_back(pass.label, std::move(texel));
    return true;
  });
  if (!request.json) print(frame, vertex);
  say(request, json_of(vertex));
  require(vertex.agrees());
}

const PlannedPass& find_pass(const RenderedFrame& frame, const std::string& label) {
  std::vector<std::string> names;
  for (const PlannedPass& pass : frame.plan().passes) {
    if (pass.label == label) return pass;
    names.push_back(pass.label);
  }
  throw Error(ExitCode::WrongUsage, "no pass '" + one_line(label) + "' runs here; the nearest name is '" +
                                        nearest_name(label, names) + "' ('caustics plan' lists them)");
}

bool same_bits(const TexelValue& a, const TexelValue& b) {
  return std::bit_cast<std::array<std::uint32_t, 4>>(a) == std::bit_cast<std::array<std::uint32_t, 4>>(b);
}

// What the rendered targets hold there; none of those that nobody needs.
void read_stored(const RenderedFrame& frame, TexelHistory& history) {
  const PlannedPass& pass = *history.pass;
  for (std::size_t i = 0; i < pass.writes.size(); ++i) {
    const ColorWrite& write = pass.definition.writes[i];
    const TexelValue last = history.fragments.empty() ? history.before[i] : history.fragments.back().after[i];
    TexelValue stored = last;
    if (pass.writes[i] >= 0) {
      const Image image = frame.read(pass.writes[i]);
      stored = value_before(write, &image, history.x, history.y);
    }
    history.stored.push_back(stored);
    history.agrees = history.agrees && same_bits(stored, last);
  }
}

// What the pass's primitives are.
void name_primitives(const RenderedFrame& frame, TexelHistory& history) {
  const DrawSet draws = pass_registry()[static_cast<std::size_t>(history.pass->pass)].draws;
  const auto grid = static_cast<std::uint32_t>(frame.settings().grid);
  history.kind = history.pass->definition.topology == Topology::Triangles ? "triangle" : "primitive";
  if (draws == DrawSet::GridCells) history.kind = "cell", history.columns = grid - 1;
  if (draws == DrawSet::GridVertices) history.kind = "vertex", history.columns = grid;
}

void probe_history(const ProbeRequest& request, std::unique_ptr<LoadedScene> loaded) {
  RenderedFrame frame(request.frame, std::move(loaded), goal_with_ledgers({"picture"}));
  const PlannedPass& pass = find_pass(frame, request.pass);
  TexelHistory history{.pass = &pass, .x = request.texel->first, .y = request.texel->second};
  if (history.x >= pass.width || history.y >= pass.height)
    throw Error(ExitCode::WrongUsage, "--history: " + pass.label + " has " + std::to_string(pass.width) +
                                          "x" + std::to_string(pass.height) + " texels, counted from 0,0");
  name_primitives(frame, history);
  TargetsBefore before;
  before.colors.resize(pass.writes.size());
  frame.run([&](const PlannedPass& done_pass, const PassResult& result, std::size_t done, std::size_t total) {
    if (&done_pass == &pass) {
      const PassRun run = frame.prepare(pass);
      for (const Draw& draw : run.draws) history.meshes.push_back(mesh_of(frame, draw));
      for (std::size_t i = 0; i < pass.writes.size(); ++i) {
        const ColorWrite& write = pass.definition.writes[i];
        const Image* kept = before.colors[i].values.empty() ? nullptr : &before.colors[i];
        history.attachments.push_back(write.name);
        history.channels.push_back(channel_count(write.format));
        history.before.push_back(value_before(write, kept, history.x, history.y));
      }
      history.left_out = result.left_out;
      if (!result.left_out)
        replay_fragments(frame.device(), run, before, {history.x, history.y, 1, 1},
                         [&](const FragmentOnTexel& fragment) { history.fragments.push_back(fragment); });
      read_stored(frame, history);
    }
    if (done < total && &frame.plan().passes[done] == &pass) before = targets_before(frame, pass);
    return true;
  });
  if (!request.json) print(history);
  say(request, json_of(history));
  require(history.agrees);
}

std::array<float, 3> color_at(const RenderedFrame& frame, const std::string& texture, int x, int y) {
  const ImageView image = frame.look_at(texture);
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

constexpr const char* kSeenCasters = "caster_position.camera";

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
  const std::optional<double> caster = depth_at(frame, kSeenCasters, x, y);
  const std::optional<double> surface = depth_at(frame, "view_position", x, y);
  if (caster && (!surface || *caster < *surface))
    return "glass or metal; the light below is that of the surface straight behind it";
  return surface ? "a surface" : "nothing but what is all around";
}

void probe_pixel(const ProbeRequest& request, std::unique_ptr<LoadedScene> loaded) {
  PlanGoal goal = goal_with_ledgers({"picture", "view_position"});
  goal.beside.emplace_back(kSeenCasters);
  RenderedFrame frame(request.frame, std::move(loaded), goal);
  const int width = frame.settings().width, height = frame.settings().height;
  ProbedPixel pixel{request.pixel->first, request.pixel->second};
  if (pixel.x >= width || pixel.y >= height)
    throw Error(ExitCode::WrongUsage, "--pixel must be 0.." + std::to_string(width - 1) + ",0.." +
                                          std::to_string(height - 1) + ": the picture has " +
                                          std::to_string(width) + "x" + std::to_string(height) + " pixels");
  const int y = height - 1 - pixel.y;
  pixel.lights = light_on_pixel(frame, pixel.x, y);
  pixel.shows = seen_at(frame, pixel.x, y);
  pixel.beauty = color_at(frame, "beauty", pixel.x, y);
  pixel.picture = color_at(frame, "picture", pixel.x, y);
  if (!request.json) print(frame, pixel);
  say(request, json_of(frame, pixel));
  require(pixel.agrees());
}

}  // namespace

ExitCode run_probe(const Arguments& arguments) {
  ProbeRequest request;
  if (!parse(arguments, request)) return ExitCode::Done;
  std::unique_ptr<LoadedScene> loaded = load_scene(request.frame);
  if (request.vertex) {
    probe_vertex(request, std::move(loaded));
  } else if (request.texel) {
    probe_history(request, std::move(loaded));
  } else {
    probe_pixel(request, std::move(loaded));
  }
  return ExitCode::Done;
}

}  // namespace caustics::app
