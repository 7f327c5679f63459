// caustics digest: one hash for each attachment of each pass, to compare machines and versions.
#include <algorithm>
#include <cstdio>

#include "app/output/attachments.hpp"
#include "app/sample_scenes.hpp"
#include "app/shell/setting_options.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

// Words of a line are separated by blanks, so names must not hold any.
std::string word(const std::string& text) {
  std::string result = one_line(text);
  std::replace(result.begin(), result.end(), ' ', '_');
  return result;
}

void print_digest(const FrameRequest& request) {
  RenderedFrame frame(request, load_scene(request), {});
  const std::string scene = word(request.scene.filename().string());
  frame.run([&](const PlannedPass& pass, const PassResult&, std::size_t, std::size_t) {
    for_each_attachment(frame, pass, [&](const PlannedTexture& texture, const Image& image) {
      std::printf("%s %s %s %s\n", scene.c_str(), word(pass.label).c_str(), word(texture.name).c_str(),
                  sha256(image).c_str());
    });
    return true;
  });
}

}  // namespace

ExitCode run_digest(const Arguments& arguments) {
  FrameRequest request;
  request.settings = small_settings();
  Parser parser("digest",
                "Prints 'scene pass attachment sha256' for every attachment of every pass. Equal\n"
                "lines mean equal texels, whatever the machine, compiler or number of threads.\n"
                "Sizes are small unless given: " +
                    differing(request.settings) + ".",
                "  caustics digest                       the sample scenes\n"
                "  caustics digest scene.glb -t 1 > a.txt\n");
  std::vector<std::string> scenes;
  parser.positionals("SCENE", "glTF 2.0 files (default: the sample scenes)", scenes);
  add_frame_options(parser, request);
  if (!parser.parse(arguments)) return ExitCode::Done;
  if (scenes.empty()) scenes = sample_scenes();
  for (const std::string& scene : scenes) {
    request.scene = scene;
    check_request(request, "digest");
    print_digest(request);
  }
  return ExitCode::Done;
}

}  // namespace caustics::app
