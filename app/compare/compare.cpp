// caustics compare: do two images, or two dumps of all passes, hold the same values?
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include "app/compare/block_means.hpp"
#include "app/compare/difference_images.hpp"
#include "app/compare/difference_report.hpp"
#include "app/compare/flip_picture.hpp"
#include "app/compare/likeness.hpp"
#include "app/output/image_file.hpp"
#include "app/output/image_layers.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

namespace fs = std::filesystem;

struct CompareRequest {
  Comparison comparison;
  std::string prefix;  // of the difference images
  std::string layer, mask;
  Region region;
  int block = 1;  // side, texels
  std::vector<MetricBound> bounds;
  bool flip = false;
  bool json = false;
  RunFiles files;

  bool needs_flip() const {
    return flip || std::any_of(bounds.begin(), bounds.end(),
                               [](const MetricBound& each) { return each.is_of_flip(); });
  }
  bool is_about_images() const {
    return !layer.empty() || !mask.empty() || region.width > 0 || block > 1 || !bounds.empty() || flip;
  }
};

double parse_bound(const std::string& option, const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value) || value < 0.0) {
    throw Error(ExitCode::WrongUsage, option + " cannot be " + in_quotes(text) + ": a number, 0 or more");
  }
  return value;
}

void require_there(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw Error(ExitCode::BadInput, path + ": no such file or folder");
}

void require_difference_image(CompareRequest& request, const fs::path& output) {
  require_output(request.files, output, "--diff", Content::Binary);
}

// Everything that can be known before anything is read. True for two folders.
bool check(CompareRequest& request) {
  const std::string &a = request.comparison.a, &b = request.comparison.b;
  if (a.empty() || b.empty()) {
    throw Error(ExitCode::WrongUsage, "compare needs two images, or two folders of --dump");
  }
  require_there(a);
  require_there(b);
  if (request.block > 1 && !request.mask.empty())
    throw Error(ExitCode::WrongUsage, "--blocks and --mask exclude each other");
  const bool folders = fs::is_directory(a);
  if (folders != fs::is_directory(b)) {
    throw Error(ExitCode::WrongUsage, (folders ? a : b) + " is a folder and " + (folders ? b : a) +
                                          " is not; compare two images, or two folders of --dump");
  }
  if (folders && request.is_about_images()) {
    throw Error(ExitCode::WrongUsage,
                "--layer, --mask, --region, --blocks, --flip and --fail-above need two images; name the "
                "files in the folders");
  }
  refuse_standard_output(request.prefix, "--diff", "the differences are several images");
  if (folders) return true;
  request.files.reads(a, "an image");
  request.files.reads(b, "an image");
  if (!request.mask.empty()) request.files.reads(request.mask, "the mask");
  if (request.prefix.empty()) return false;
  const DifferencePaths paths(request.prefix);
  for (const fs::path& output : {paths.signed_exr, paths.color_png})
    require_difference_image(request, output);
  return false;
}

// Prints the report; the answer becomes the exit code.
template <typename Result>
ExitCode answer(const CompareRequest& request, const Result& result, bool passed) {
  const std::string report =
      request.json ? report_json(request.comparison, result) : report_text(request.comparison, result);
  std::fputs(report.c_str(), stdout);
  return passed ? ExitCode::Done : ExitCode::AnswerIsNo;
}

// PREFIX_flip.png, or PREFIX_LAYER_flip.png where the layer has a name.
fs::path flip_path(const std::string& prefix, std::string layer) {
  std::replace(layer.begin(), layer.end(), '/', '_');
  return prefix + (layer.empty() ? "" : "_" + layer) + "_flip.png";
}

void require_flip_outputs(CompareRequest& request, const PlanesDifference& difference) {
  if (!request.flip || request.prefix.empty()) return;
  std::set<fs::path> pictures;
  for (const ChannelDifference& channel : difference.channels)
    pictures.insert(flip_path(request.prefix, layer_of(channel.name)));
  for (const fs::path& picture : pictures) require_difference_image(request, picture);
}

void draw_flip(const CompareRequest& request, const Measurement& measurement) {
  if (!request.flip) return;
  for (const LayerMeasure& layer : measurement.layers) {
    if (!layer.flip) continue;
    write_png(flip_path(request.prefix, layer.layer), flip_picture(layer.flip->map, measurement.selection));
  }
}

// `of`: what differs, before a reason why there are no images.
void draw(const DifferencePaths& paths, const std::string& of, const PlanesDifference& difference,
          const Selection& selection) {
  if (const std::string reason = why_not_drawable(difference); !reason.empty()) {
    complain(of + "no difference images: " + reason);
    return;
  }
  const std::string scale = write_difference_images(paths, difference, selection);
  std::fprintf(stderr, "%s: %s\n", one_line(paths.color_png.string()).c_str(), scale.c_str());
}

// Does --diff name a folder, rather than how files' names begin?
bool is_folder(const std::string& diff) { return diff.back() == '/' || fs::is_directory(diff); }

// Where the pictures of two dumps' attachment go: DIR/FILE_..., or PREFIX_FILE_...
DifferencePaths dump_pictures(const std::string& diff, const fs::path& file) {
  const std::string stem = file.stem().string();
  return DifferencePaths(is_folder(diff) ? (fs::path(diff) / stem).string() : diff + "_" + stem);
}

// Before anything is compared: the pictures can be written, and replace no file of the dumps.
void check_dump_pictures(CompareRequest& request) {
  if (request.prefix.empty()) return;
  const std::vector<DumpedAttachment> in_a = read_manifest(request.comparison.a);
  std::vector<DumpedAttachment> inputs = read_manifest(request.comparison.b);
  inputs.insert(inputs.end(), in_a.begin(), in_a.end());
  for (const DumpedAttachment& input : inputs) request.files.reads(input.file, "an attachment of a dump");
  for (const DumpedAttachment& attachment : in_a) {
    const DifferencePaths paths = dump_pictures(request.prefix, attachment.file);
    for (const fs::path& output : {paths.signed_exr, paths.color_png}) request.files.writes(output, "--diff");
  }
  // A folder that is to be made could be a file, too.
  const bool missing = is_folder(request.prefix) && !fs::exists(request.prefix);
  require_writable(missing ? fs::path(request.prefix).parent_path()
                           : dump_pictures(request.prefix, "pass.exr").color_png);
}

void draw_dumps(const CompareRequest& request, const fs::path& file, const AttachmentDifference& attachment) {
  if (request.prefix.empty()) return;
  std::error_code error;
  if (is_folder(request.prefix)) fs::create_directories(request.prefix, error);
  draw(dump_pictures(request.prefix, file), one_line(attachment.name) + ": ", attachment.planes, {});
}

ExitCode compare_dumps(CompareRequest& request) {
  const Comparison& comparison = request.comparison;
  check_dump_pictures(request);
  const FolderDifference difference =
      compare_folders(comparison.a, comparison.b, comparison.tolerance,
                      [&](const fs::path& file, const AttachmentDifference& attachment) {
                        draw_dumps(request, file, attachment);
                      });
  return answer(request, difference, difference.verdict() != Verdict::Different);
}

ExitCode compare_images(CompareRequest& request) {
  const Comparison& comparison = request.comparison;
  ImagePlanes a = read_planes(comparison.a), b = read_planes(comparison.b);
  if (!request.layer.empty()) {
    keep_layer(a, request.layer, comparison.a);
    keep_layer(b, request.layer, comparison.b);
  }
  if (request.block > 1)
    for (ImagePlanes* image : {&a, &b}) take_block_means(*image, request.block);
  Selection selection = select(a, request.mask, request.region);
  ImageAnswer result;
  result.difference = compare_planes(a, b, comparison.tolerance, selection);
  if (result.difference.verdict() == Verdict::Different)
    result.looks_like = likenesses(result.difference, selection);
  require_flip_outputs(request, result.difference);
  result.measurement = measure(result.difference, std::move(selection), request.needs_flip());
  result.bounds = judge(request.bounds, result.measurement);
  if (!request.prefix.empty()) {
    draw(DifferencePaths(request.prefix), "", result.difference, result.measurement.selection);
    draw_flip(request, result.measurement);
  }
  return answer(request, result, result.passed());
}

std::string metric_list() {
  std::string text;
  for (const std::string& name : boundable_metrics()) text += " " + name;
  return "  " + wrapped(text, 2, 2);
}

void add_options(Parser& parser, CompareRequest& request) {
  Tolerance& tolerance = request.comparison.tolerance;
  parser.positional("A", "an image, or a folder of render --dump", request.comparison.a);
  parser.positional("B", "what it is compared with", request.comparison.b);
  parser.group("Allowed difference, either bound suffices");
  parser.option("--tolerance", "T", {"allowed: |A-B| up to T, in the images' unit", "0..", "0"},
                [&](const std::string& value) { tolerance.absolute = parse_bound("--tolerance", value); });
  parser.option("--relative", "R", {"allowed: |A-B| up to R times the larger of |A| and |B|", "0..", "0"},
                [&](const std::string& value) { tolerance.relative = parse_bound("--relative", value); });
  parser.group("What is looked at, in two images");
  parser.option("--layer", "NAME",
                {"the channels NAME.R, NAME.G, ... alone; those without a layer are beauty", "", "all"},
                [&](const std::string& value) { request.layer = value; });
  parser.option(
      "--mask", "FILE",
      {"texels where a channel of this image other than A is above 0; it has the images' size", "", "all"},
      [&](const std::string& value) { request.mask = value; });
  parser.option("--region", "X,Y,W,H", {"a rectangle of texels, counted from the top left", "", "all"},
                [&](const std::string& value) { request.region = parse_region(value); });
  parser.number("--blocks", "N",
                {"the means of N x N texels instead of texels, as a frame's estimated error has 4; --region "
                 "counts in them"},
                Limits<int>{1, 4096}, request.block);
  parser.group("Figures, in two images");
  parser.flag("--flip", request.flip,
              "FLIP of each layer of colours as a screen shows them; with --diff also its map");
  parser.repeated(
      "--fail-above", "METRIC=VALUE",
      {"exit code 1 where a layer's figure is above this, instead of by the values; may stand several times",
       "", "none"},
      [&](const std::string& value) { request.bounds.push_back(parse_metric_bound(value)); });
  parser.group("Output");
  parser.flag("--json", request.json, "the report as JSON");
  parser.option("--diff", "PREFIX",
                {"writes PREFIX_signed.exr, A-B of each channel, and PREFIX_color.png; of two dumps "
                 "DIR/FILE_... or PREFIX_FILE_... for each attachment that differs",
                 "", "none"},
                [&](const std::string& value) { request.prefix = value; });
  parser.footer(
      "Channels are lined up by name, values taken as stored; one that only one image has, another "
      "size,\nand a NaN anywhere, even in both, make images different. -0 equals 0, an infinity "
      "equals itself.\nExit code 0: equal, or within what is allowed; 1: different. With "
      "--fail-above: 0 if every "
      "bound holds\nin every layer, and there is no NaN and no channel that only one image has. "
      "Metrics that it knows:\n" +
      metric_list());
}

}  // namespace

ExitCode run_compare(const Arguments& arguments) {
  Parser parser("compare",
                "Compares two images in values and figures, or two dumps of all passes value by value.",
                "  caustics compare mine.exr reference.exr\n"
                "  caustics compare mine.exr reference.exr --relative 1e-5 --diff where\n"
                "  caustics compare mine.exr truth.exr --layer caustic --fail-above relative_l1=0.02\n"
                "  caustics compare my_passes/ passes/      two folders of render --dump\n");
  CompareRequest request;
  add_options(parser, request);
  if (!parser.parse(arguments)) return ExitCode::Done;
  return check(request) ? compare_dumps(request) : compare_images(request);
}

}  // namespace caustics::app
