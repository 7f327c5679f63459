// caustics bench: what each pass of a frame takes, on one backend or on both by turns.
#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/bench_frames.hpp"
#include "app/bench_report.hpp"
#include "app/json.hpp"
#include "app/output/stats.hpp"
#include "app/shell/command.hpp"
#include "app/shell/own_process.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"

namespace caustics::app {

namespace {

struct BenchOptions {
  BenchRequest request;
  std::vector<int> threads;
  bool json = false;
};

// False when only the help was asked for.
bool parse(const Arguments& arguments, BenchOptions& options) {
  Parser parser("bench",
                "Draws the frame that render draws again and again: the median time of each pass, and\n"
                "how far frames are from it. With --against gl both backends draw by turns. Exit code\n"
                "1 where an attachment's bits change from frame to frame, or differ on a driver that\n"
                "must give the same.",
                "  caustics bench scene.glb --against gl\n"
                "  caustics bench scene.glb -t 1,2 -r 640x360 --json\n");
  std::string scene;
  parser.positional("SCENE", kSceneMeaning, scene);
  parser.option("--against", "gl", {"measure this backend too, frame by frame in turn", "gl", "none"},
                [&](const std::string& name) {
                  if (name != "gl")
                    throw Error(ExitCode::WrongUsage, "--against cannot be '" + one_line(name) + "': gl");
                  options.request.against_gl = true;
                });
  parser.number("--frames", "N", {"frames measured, after two that are not"}, Limits<int>{1, 10000},
                options.request.frames);
  parser.flag("--json", options.json, "the report as JSON");
  FrameRequest& frame = options.request.frame;
  add_frame_options(parser, frame, nullptr, &options.threads);
  if (!parser.parse(arguments)) return false;
  frame.scene = scene;
  check_request(frame, "bench");
  if (options.request.against_gl && frame.backend.backend == Backend::OpenGl)
    throw Error(ExitCode::WrongUsage, "--against gl is for the software device; leave out --backend gl");
  if (options.threads.empty())
    options.threads = {static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))};
  return true;
}

// The report for this number of threads.
Answer measured(const BenchOptions& options, int threads) {
  const BenchRun run = measure_frames(options.request, threads);
  if (!run.fault.empty()) complain(run.fault);
  return {run.fault.empty() ? ExitCode::Done : ExitCode::AnswerIsNo,
          options.json ? bench_json(run).dump() : bench_text(run)};
}

}  // namespace

ExitCode run_bench(const Arguments& arguments) {
  BenchOptions options;
  if (!parse(arguments, options)) return ExitCode::Done;
  ExitCode code = ExitCode::Done;
  Json runs = Json::array();
  for (const int threads : options.threads) {
    const auto work = [&] { return measured(options, threads); };
    const Answer answer = options.threads.size() > 1 ? in_own_process(work) : work();
    if (answer.text.empty()) return answer.code;
    code = std::max(code, answer.code);
    if (options.json) {
      runs.push_back(Json::parse(answer.text));
    } else {
      std::printf("%s%s", &threads == &options.threads.front() ? "" : "\n", answer.text.c_str());
    }
  }
  if (options.json)
    std::printf("%s", json_text({{"format", 1},
                                 {"program", version_line()},
                                 {"scene", one_line(options.request.frame.scene.string())},
                                 {"runs", runs}})
                          .c_str());
  return code;
}

}  // namespace caustics::app
