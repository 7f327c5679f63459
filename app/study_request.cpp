#include "app/study_request.hpp"

#include <algorithm>

#include "app/output/stats.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "app/study_effects.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/renderer/picture_sides.hpp"
#include "pipeline/settings/nearest.hpp"
#include "pipeline/settings/setting.hpp"

namespace caustics::app {

using study::Knob;

namespace {

using Varied = std::pair<std::string, std::string>;

const std::vector<Varied> kDefault = {{"grid", "64,128,256,512"},
                                      {"map", "128,256,512"},
                                      {"estimator", "paper,secant,newton,impostor"},
                                      {"splat", "point,gaussian,cell"}};
constexpr Limits<double> kTruthErrors{1e-6, 1000.0};  // percent

constexpr char kStudyPurpose[] =
    "Renders a scene with many settings, and says for each how far its caustic is from a truth\n"
    "and how long it took: study.csv, study.json and report.html. See docs/accuracy.md.";
constexpr char kStudyExamples[] =
    "  caustics study scene.glb -o study\n"
    "  caustics study scene.glb -o study --vary grid=64,256 --vary splat=point,cell --cross\n"
    "  caustics study scene.glb -o study --truth traced --truth-error 0.5% -r 256x256\n"
    "  caustics study scene.glb -o study --effects --truth traced -r 256x256\n"
    "  caustics study scene.glb -o study --truth truth.exr --mask floor.png -r 512x512\n"
    "  caustics study scene.glb -o study --backend both --resume\n";

void add_varied(StudyRequest& request, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw Error(ExitCode::WrongUsage,
                "--vary cannot be " + in_quotes(text) + ": KEY=a,b,c, as in grid=64,128,256");
  }
  const std::string key = text.substr(0, equals);
  for (const Varied& each : request.varied)
    if (each.first == key)
      throw Error(ExitCode::WrongUsage, "--vary " + one_line(key, 60) +
                                            " is given twice; give all of its "
                                            "values at once, with commas between");
  request.varied.emplace_back(key, text.substr(equals + 1));
}

void add_study_options(Parser& parser, StudyRequest& request) {
  parser.group("Study");
  parser.repeated("--vary", "KEY=a,b,c",
                  {"values of a key of -D; may stand several times, once for each key",
                   "not of what is seen, nor of how it is shown", "below"},
                  [&](const std::string& text) { add_varied(request, text); });
  parser.flag("--effects", request.effects,
              "instead of --vary: leave out one effect after the other that the scene calls for");
  parser.flag("--cross", request.cross,
              "all values with all others, instead of one key at a time and grid with map");
  parser.number("--repeat", "N", {"frames timed for each setting"}, Limits<int>{1, 1000}, request.repeat);
  parser.option("--truth", "WHAT",
                {"what the caustic is held against: a file's layer caustic; traced light, of the meshes or "
                 "of the exact "
                 "shapes that the file states; or the sweep's finest setting with grid and map doubled",
                 "FILE.exr|traced|exact|finest", "finest"},
                [&](const std::string& value) {
                  request.traced.wanted = value == "traced" || value == "exact";
                  request.traced.exact = value == "exact";
                  request.truth = request.traced.wanted || value == "finest" ? "" : value;
                });
  parser.option("--truth-error", "P%",
                {"of traced and exact: the relative error at which tracing ends", text_of(kTruthErrors),
                 significant(100.0 * request.traced.error, 3) + "%"},
                [&](const std::string& value) {
                  request.traced.error = parse_percent("--truth-error", value, kTruthErrors);
                  request.says_how_long = true;
                });
  constexpr Limits<double> kSeconds{0.0, 1e7};
  parser.option("--truth-seconds", "S",
                {"after which what is traced has to do; said where the error is missed", text_of(kSeconds),
                 significant(request.traced.seconds, 6)},
                [&](const std::string& value) {
                  request.traced.seconds = parse_number("--truth-seconds", value, Limits<double>{0.0, 1e7});
                  request.says_how_long = true;
                });
  parser.option("--mask", "FILE", {"pixels where a channel of this image other than A is above 0", "", "all"},
                [&](const std::string& value) { request.mask = value; });
  parser.group("Output");
  parser.option("-o,--output", "DIR", {"folder of the report; made where it is missing", "", "study"},
                [&](const std::string& value) { request.folder = value; });
  parser.flag("--resume", request.resume, "keep the rows of DIR/study.json that still hold");
  parser.flag("-q,--quiet", request.quiet, "no progress on stderr");
  for (const Varied& each : kDefault)
    parser.list("Varied where no --vary is given", each.first, {each.second});
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= list.size();) {
    const std::size_t end = std::min(list.find(',', start), list.size());
    parts.push_back(list.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

// One truth is one view of one picture.
bool is_fixed(const Setting& row) {
  return row.part == Setting::Part::View || row.part == Setting::Part::Picture;
}

void refuse_fixed(const std::string& key) {
  if (!is_fixed(setting(key))) return;
  throw Error(ExitCode::WrongUsage, "--vary cannot change " + key +
                                        ": all pictures of a study show the same as the "
                                        "truth; give it once, with -D " +
                                        key + "=...");
}

Knob knob_of(const Settings& base, const Varied& varied) {
  const std::string& key = varied.first;
  const Setting& row = setting(key);
  Knob knob{.key = key, .values = {}, .base = row.get(base), .ordered = row.is_number()};
  for (const std::string& value : split(varied.second)) {
    Settings settings = base;
    set_option(settings, key, value);
    const std::string text = row.get(settings);
    if (std::find(knob.values.begin(), knob.values.end(), text) == knob.values.end())
      knob.values.push_back(text);
  }
  refuse_fixed(key);
  // "auto" is no number to sort by.
  for (const std::string& value : knob.values) knob.ordered &= value != row.unset;
  knob.ordered &= knob.base != row.unset;
  return knob;
}

std::string typed(const Arguments& arguments) {
  std::string text = "caustics study";
  for (const std::string& word : arguments) text += " " + one_line(word);
  return text;
}

}  // namespace

bool parse_study(const Arguments& arguments, StudyRequest& request) {
  Parser parser("study", kStudyPurpose, kStudyExamples);
  std::string scene;
  parser.positional("SCENE", kSceneMeaning, scene);
  add_study_options(parser, request);
  add_frame_options(parser, request.frame, &request.backends);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  check_request(request.frame, "study");
  if (is_standard_input(request.frame.scene))
    throw Error(ExitCode::WrongUsage, "study goes on with what it has found of a scene, which needs a file");
  refuse_standard_output(request.folder, "-o", "a study is a folder of files");
  RunFiles& files = request.frame.files;
  if (!request.mask.empty()) files.reads(request.mask, "the mask");
  if (!request.truth.empty()) files.reads(request.truth, "the truth");
  for (const char* file : kStudyFiles) files.writes(request.folder / file, "-o");
  if (request.traced.wanted)
    for (const char* file : {"truth.exr", "truth.exr.state", "truth.exr.json"})
      files.writes(request.folder / file, "-o");
  files.writes_in(request.folder / "img", "-o",
                  [](const std::string& name) { return name.ends_with(".png"); });
  // What is compared has given sides.
  request.frame.settings = with_least_sides(request.frame.settings);
  if (request.says_how_long && !request.traced.wanted)
    throw Error(ExitCode::WrongUsage,
                "--truth-error and --truth-seconds are for --truth traced and --truth exact");
  if (request.effects && (request.cross || !request.varied.empty()))
    throw Error(ExitCode::WrongUsage, "--effects excludes --vary and --cross: it leaves out one at a time");
  request.command = typed(arguments);
  if (request.backends.empty()) request.backends.push_back(request.frame.backend.backend);
  return true;
}

std::vector<Knob> knobs_of(const StudyRequest& request) {
  if (request.effects) {
    Knob knob{.key = study::kWithout, .values = {study::kNothing}, .base = study::kNothing};
    for (std::string& name : omissions_for(request.frame)) knob.values.push_back(std::move(name));
    return {knob};
  }
  std::vector<Knob> knobs;
  for (const Varied& varied : request.varied.empty() ? kDefault : request.varied)
    knobs.push_back(knob_of(request.frame.settings, varied));
  return knobs;
}

std::string name_of(Backend backend) { return backend == Backend::OpenGl ? "gl" : "software"; }

}  // namespace caustics::app
