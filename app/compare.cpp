// caustics compare: do two images, or two dumps of all passes, hold the same values?
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/atomic_file.hpp"
#include "app/difference_images.hpp"
#include "app/difference_report.hpp"
#include "app/parser.hpp"
#include "app/terminal.hpp"

namespace caustics::app {

namespace {

namespace fs = std::filesystem;

struct CompareRequest {
  Comparison comparison;
  std::string prefix;  // of the difference images
  bool json = false;
};

double parse_bound(const std::string& option, const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value) || value < 0.0) {
    throw Error(ExitCode::WrongUsage,
                option + " cannot be '" + one_line(text).substr(0, 80) + "': a number, 0 or more");
  }
  return value;
}

void require_there(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw Error(ExitCode::BadInput, path + ": no such file or folder");
}

// Everything that can be known before anything is read. True for two folders.
bool check(const CompareRequest& request) {
  const std::string &a = request.comparison.a, &b = request.comparison.b;
  if (a.empty() || b.empty()) {
    throw Error(ExitCode::WrongUsage, "compare needs two images, or two folders of --dump");
  }
  require_there(a);
  require_there(b);
  const bool folders = fs::is_directory(a);
  if (folders != fs::is_directory(b)) {
    throw Error(ExitCode::WrongUsage, (folders ? a : b) + " is a folder and " + (folders ? b : a) +
                                          " is not; compare two images, or two folders of --dump");
  }
  if (request.prefix.empty()) return folders;
  if (folders) {
    throw Error(ExitCode::WrongUsage, "--diff needs two images; name the files in the folders");
  }
  const DifferencePaths paths(request.prefix);
  for (const fs::path& output : {paths.signed_exr, paths.color_png}) {
    std::error_code error;
    if (fs::equivalent(output, a, error) || fs::equivalent(output, b, error)) {
      throw Error(ExitCode::WrongUsage, output.string() + ": --diff would replace an input");
    }
    require_writable(output);
  }
  return folders;
}

// Prints the report; the answer becomes the exit code.
template <typename Difference>
ExitCode answer(const CompareRequest& request, const Difference& difference) {
  const std::string report = request.json ? report_json(request.comparison, difference)
                                          : report_text(request.comparison, difference);
  std::fputs(report.c_str(), stdout);
  return difference.verdict() == Verdict::Different ? ExitCode::AnswerIsNo : ExitCode::Done;
}

void draw(const std::string& prefix, const PlanesDifference& difference) {
  if (const std::string reason = why_not_drawable(difference); !reason.empty()) {
    complain("no difference images: " + reason);
    return;
  }
  const DifferencePaths paths(prefix);
  const std::string scale = write_difference_images(paths, difference);
  std::fprintf(stderr, "%s: %s\n", one_line(paths.color_png.string()).c_str(), scale.c_str());
}

ExitCode compare_images(const CompareRequest& request) {
  const Comparison& comparison = request.comparison;
  const ImagePlanes a = read_planes(comparison.a), b = read_planes(comparison.b);
  const PlanesDifference difference = compare_planes(a, b, comparison.tolerance);
  if (!request.prefix.empty()) draw(request.prefix, difference);
  return answer(request, difference);
}

void add_options(Parser& parser, CompareRequest& request) {
  Tolerance& tolerance = request.comparison.tolerance;
  parser.positional("A", "an image, or a folder of render --dump", request.comparison.a);
  parser.positional("B", "what it is compared with", request.comparison.b);
  parser.group("Allowed difference; either bound suffices");
  parser.option(
      "--tolerance", "T", "|A-B| up to T, in the images' unit; 0.. (default 0)",
      [&](const std::string& value) { tolerance.absolute = parse_bound("--tolerance", value); });
  parser.option(
      "--relative", "R", "|A-B| up to R times the larger of |A|, |B|; 0.. (default 0)",
      [&](const std::string& value) { tolerance.relative = parse_bound("--relative", value); });
  parser.group("Output");
  parser.flag("--json", request.json, "the report as JSON");
  parser.option("--diff", "PREFIX",
                "writes PREFIX_signed.exr (A-B) and PREFIX_color.png (default none)",
                [&](const std::string& value) { request.prefix = value; });
  parser.footer(
      "Channels are lined up by name, values taken as stored; one that only one image has, another "
      "size,\nand a NaN anywhere, even in both, make images different. -0 equals 0, an infinity "
      "equals itself.\nExit code 0: equal, or within what is allowed; 1: different.");
}

}  // namespace

ExitCode run_compare(const Arguments& arguments) {
  Parser parser("compare", "Compares two images, or two dumps of all passes, value by value.",
                "  caustics compare mine.exr reference.exr\n"
                "  caustics compare mine.exr reference.exr --relative 1e-5 --diff where\n"
                "  caustics compare my_passes/ passes/      two folders of render --dump\n");
  CompareRequest request;
  add_options(parser, request);
  if (!parser.parse(arguments)) return ExitCode::Done;
  if (!check(request)) return compare_images(request);
  const Comparison& comparison = request.comparison;
  return answer(request, compare_folders(comparison.a, comparison.b, comparison.tolerance));
}

}  // namespace caustics::app
