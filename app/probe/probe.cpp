// caustics probe: one grid vertex's way through the landing pass, every intermediate value printed; one
// pixel, where its light comes from; one texel of any pass, every fragment that fell on it.
#include <cstdio>

#include "app/flux.hpp"
#include "app/json.hpp"
#include "app/output/stats.hpp"
#include "app/probe/probes.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/setting.hpp"

namespace caustics::app {

namespace {

struct ProbeRequest {
  FrameRequest frame;
  VertexRequest vertices;
  std::vector<TexelRequest> texels;
  std::vector<Pair> pixels;
  bool json = false;
};

// "PASS:X,Y"; a pass's label may have colons.
void parse_history(const std::string& value, ProbeRequest& request) {
  const std::size_t split = value.rfind(':');
  if (split == std::string::npos || split == 0)
    throw Error(ExitCode::WrongUsage, "--history cannot be '" + one_line(value) +
                                          "': a pass and a texel, as in caustic_cells[sun]:200,100");
  request.texels.push_back(
      {value.substr(0, split), parse_pair("--history", value.substr(split + 1), {0, 16383})});
}

bool parse(const Arguments& arguments, ProbeRequest& request) {
  Parser parser("probe",
                "Follows the light of one grid vertex: what the landing pass reads, every value it\n"
                "computes, and what it stores. Or tells where a pixel of the picture gets its light,\n"
                "or every fragment that fell on a texel of a pass, in the order drawn. Each may stand\n"
                "several times.",
                "  caustics probe scene.glb --texel 256,256\n"
                "  caustics probe scene.glb --texel 100,60 --light 1 --estimator paper\n"
                "  caustics probe scene.glb --pixel 640,500\n"
                "  caustics probe scene.glb --history 'caustic_cells[sun]:200,100' --json\n");
  std::string scene;
  parser.positional("SCENE", kSceneMeaning, scene);
  parser.group("What to probe");
  parser.repeated(
      "--texel", "X,Y", {"the grid vertex, counted from the left and the bottom", "each 0..grid - 1"},
      [&](const std::string& value) {
        request.vertices.vertices.push_back(parse_pair("--texel", value, {0, setting("grid").most() - 1}));
      });
  parser.repeated("--pixel", "X,Y", {"the pixel, counted from the left and the top, as image viewers do"},
                  [&](const std::string& value) {
                    request.pixels.push_back(parse_pair("--pixel", value, {0, 16383}));
                  });
  parser.repeated("--history", "PASS:X,Y",
                  {"a pass, named as 'caustics plan' does, and a texel of its targets, counted from the left "
                   "and the bottom"},
                  [&](const std::string& value) { parse_history(value, request); });
  parser.number("--light", "N", {"of --texel: the light, as 'caustics plan' numbers them"},
                Limits<int>{0, 1'000'000}, request.vertices.light);
  parser.number("--sample", "N", {"of --texel: which sample of a light with a size"},
                Limits<int>{0, setting("light.samples").most() - 1}, request.vertices.sample);
  parser.flag("--json", request.json, "one JSON document instead of the text");
  add_frame_options(parser, request.frame);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  check_request(request.frame, "probe");
  require_one_sample(request.frame.settings, "probe");
  if (request.vertices.vertices.empty() && request.pixels.empty() && request.texels.empty())
    throw Error(ExitCode::WrongUsage,
                "no grid vertex given; add --texel X,Y (or --pixel X,Y, or --history PASS:X,Y)");
  if (request.vertices.vertices.empty() && request.frame.backend.backend != Backend::Software)
    throw Error(ExitCode::WrongUsage,
                "--pixel and --history draw texels again by the software device; leave out --backend");
  return true;
}

// Prints each, or puts it into the document; false where one differs from what was rendered.
template <class Probed, class Print, class ToJson>
bool report(const std::vector<Probed>& list, Json* document, const char* name, const Print& print_one,
            const ToJson& to_json) {
  bool agree = true;
  for (const Probed& probed : list) {
    if (document)
      (*document)[name].push_back(to_json(probed));
    else
      print_one(probed);
    agree = agree && agrees(probed);
  }
  return agree;
}

// A frame for each kind of question: each keeps only the textures that it needs.
bool probe(const ProbeRequest& request, Json* document) {
  bool agree = true;
  if (!request.vertices.vertices.empty()) {
    std::unique_ptr<LoadedScene> loaded = load_scene(request.frame);
    check_light(loaded->scene(), request.vertices);
    RenderedFrame frame(request.frame, std::move(loaded), {{kLanding}});
    agree &= report(
        probe_vertices(frame, request.vertices), document, "vertices",
        [&](const ProbedVertex& vertex) { print(frame, vertex); },
        [](const ProbedVertex& vertex) { return json_of(vertex); });
  }
  if (!request.texels.empty()) {
    RenderedFrame frame(request.frame, load_scene(request.frame), goal_with_ledgers({"picture"}));
    agree &= report(
        probe_texels(frame, request.texels), document, "texels",
        [](const TexelHistory& history) { print(history); },
        [](const TexelHistory& history) { return json_of(history); });
  }
  if (!request.pixels.empty()) {
    RenderedFrame frame(request.frame, load_scene(request.frame), goal_of_pixels());
    agree &= report(
        probe_pixels(frame, request.pixels), document, "pixels",
        [&](const ProbedPixel& pixel) { print(frame, pixel); },
        [&](const ProbedPixel& pixel) { return json_of(frame, pixel); });
  }
  return agree;
}

}  // namespace

ExitCode run_probe(const Arguments& arguments) {
  ProbeRequest request;
  if (!parse(arguments, request)) return ExitCode::Done;
  Json document = {{"format", 1}, {"program", version_line()}};
  const bool agree = probe(request, request.json ? &document : nullptr);
  if (request.json) std::fputs(json_text(document).c_str(), stdout);
  if (!agree) throw Error(ExitCode::InternalError, "the probe does not agree with the rendered texel");
  return ExitCode::Done;
}

}  // namespace caustics::app
