// caustics digest: one hash for each attachment of each pass, to compare machines and versions.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <optional>

#include "app/frame_options.hpp"
#include "app/loaded_scene.hpp"
#include "app/output/attachments.hpp"
#include "app/sample_scenes.hpp"
#include "app/shell/setting_options.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

// One word, for lines whose words stand between blanks: blanks, control characters and % as URLs have them,
// and the others that a terminal is spared as one_line has them.
std::string word(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    char escaped[4] = {c, 0};
    if (byte <= 0x20 || byte == 0x7f || c == '%') std::snprintf(escaped, sizeof escaped, "%%%02X", byte);
    result += escaped;
  }
  return one_line(result);
}

// Gives each attachment's name, which is 'scene pass attachment', and its hash.
using Use = std::function<void(const std::string& name, const std::string& hash)>;

void digest(const FrameRequest& request, const Use& use) {
  RenderedFrame frame(request, load_scene(request), {.light_by_light = true});
  const std::string scene = word(request.scene.filename().string());
  frame.run([&](const PlannedPass& pass, const PassResult&, std::size_t, std::size_t) {
    for_each_attachment(frame, pass, [&](const Attachment& attachment) {
      use(scene + " " + word(pass.label) + " " + word(attachment.texture.name), sha256(attachment.image));
    });
    return true;
  });
}

// Has it four words, the last one a hash?
bool is_digest_line(const std::string& line) {
  constexpr std::size_t kHashDigits = 64;
  if (line.size() <= kHashDigits) return false;
  const std::size_t hash = line.size() - kHashDigits;
  const bool words = std::count(line.begin(), line.end(), ' ') == 3 && line.front() != ' ' &&
                     line.find("  ") == std::string::npos && line[hash - 1] == ' ';
  return words && line.find_first_not_of("0123456789abcdef", hash) == std::string::npos;
}

// A digest that was kept in a file.
class KeptList {
 public:
  explicit KeptList(const std::string& path) {
    std::ifstream file(path);
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      if (!is_digest_line(line)) {
        throw Error(ExitCode::BadInput, one_line(path) + ": line " + std::to_string(number) +
                                            " is not 'scene pass attachment sha256', as digest prints it");
      }
      const std::size_t end = line.rfind(' ');
      hashes_[one_line(line.substr(0, end))].push_back(line.substr(end + 1));
    }
    if (number == 0 || !file.eof())
      throw Error(ExitCode::BadInput,
                  one_line(path) + ": no list that can be read; keep one by 'caustics digest > FILE'");
  }

  // Prints a line where the list says otherwise. Of a name that stands there several times, one after the
  // other.
  void compare(const std::string& name, const std::string& hash) {
    std::vector<std::string>& kept = hashes_[name];
    const std::string before = kept.empty() ? "" : kept.front();
    if (!kept.empty()) kept.erase(kept.begin());
    if (before == hash) return;
    equal_ = false;
    if (before.empty()) {
      std::printf("new %s %s\n", name.c_str(), hash.c_str());
    } else {
      std::printf("changed %s %s %s\n", name.c_str(), before.c_str(), hash.c_str());
    }
  }

  // Prints what the list has and nothing was compared to; says whether all was equal.
  bool finish() {
    for (const auto& [name, kept] : hashes_) {
      for (const std::string& hash : kept) std::printf("missing %s %s\n", name.c_str(), hash.c_str());
      equal_ = equal_ && kept.empty();
    }
    return equal_;
  }

 private:
  std::map<std::string, std::vector<std::string>> hashes_;
  bool equal_ = true;
};

}  // namespace

ExitCode run_digest(const Arguments& arguments) {
  FrameRequest request;
  request.settings = small_settings();
  Parser parser("digest",
                "Prints 'scene pass attachment sha256' for every attachment of every pass. Equal\n"
                "lines mean equal texels, whatever the machine, compiler or number of threads.\n"
                "Names are words: a blank in one is %20. With --check it prints what differs from a\n"
                "kept list, 'changed', 'new' or 'missing' before the names, and the exit code is 1\n"
                "then; what the list has of other scenes is missing.\n"
                "Sizes are small unless given: " +
                    differing(request.settings) + ".",
                "  caustics digest                       the sample scenes\n"
                "  caustics digest scene.glb -t 1 > a.txt\n"
                "  caustics digest scene.glb -t 8 --check a.txt\n");
  std::vector<std::string> scenes;
  parser.positionals("SCENE", "glTF 2.0 files (default: the sample scenes)", scenes);
  std::optional<KeptList> kept;
  parser.option("--check", "FILE", {"a kept list to compare to"},
                [&](const std::string& file) { kept.emplace(file); });
  add_frame_options(parser, request);
  if (!parser.parse(arguments)) return ExitCode::Done;
  if (scenes.empty()) scenes = sample_scenes();
  for (const std::string& scene : scenes) {
    request.scene = scene;
    check_request(request, "digest");
    digest(request, [&](const std::string& name, const std::string& hash) {
      if (kept) {
        kept->compare(name, hash);
      } else {
        std::printf("%s %s\n", name.c_str(), hash.c_str());
      }
    });
  }
  return kept && !kept->finish() ? ExitCode::AnswerIsNo : ExitCode::Done;
}

}  // namespace caustics::app
