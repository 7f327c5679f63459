// caustics_pass_times SCENE ROUNDS [DIGEST'S OPTIONS]: the milliseconds of all passes of a frame, one line a
// round. By this price.sh weighs builds that keep the promise of equal bits against builds that don't.
#include <cstdio>

#include "app/frame.hpp"
#include "app/shell/run_program.hpp"

namespace caustics::app {

namespace {

ExitCode print_times(const Arguments& arguments) {
  Parser parser("pass_times", "Prints the milliseconds of all passes of a frame, one line a round.",
                "  caustics_pass_times scene.glb 5 -t 1\n");
  FrameRequest request;
  std::vector<std::string> words;
  parser.positionals("SCENE ROUNDS", "a glTF 2.0 file, and how many frames", words);
  add_frame_options(parser, request);
  if (!parser.parse(arguments)) return ExitCode::Done;
  if (words.size() != 2) throw Error(ExitCode::WrongUsage, "a scene and a number of rounds, please");
  request.scene = words[0];
  check_request(request, "pass_times");
  RenderedFrame frame(request, load_scene(request), {});
  for (int round = parse_number("ROUNDS", words[1], Limits<int>{1, 1000}); round > 0; --round) {
    double sum = 0.0;
    for (const PassReport& report : frame.run()) sum += report.result.milliseconds;
    std::printf("%.3f\n", sum);
  }
  return ExitCode::Done;
}

}  // namespace

}  // namespace caustics::app

int main(int count, char** values) {
  return caustics::app::run_program(count, values, caustics::app::print_times);
}
