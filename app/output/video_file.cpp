#include "app/output/video_file.hpp"

#include <algorithm>

#include "app/shell/interrupt.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

namespace {

// How ffmpeg encodes films of one extension.
struct VideoFormat {
  const char* extension;
  const char* container;
  bool even;  // colours are stored for squares of 2 x 2 pixels
  std::vector<std::string> options;
};

// sRGB's red, green and blue are those of BT.709; players are told what is stored.
const std::vector<std::string> kColours = {"-vf",
                                           "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
                                           "-colorspace",
                                           "bt709",
                                           "-color_primaries",
                                           "bt709",
                                           "-color_trc",
                                           "iec61966-2-1",
                                           "-color_range",
                                           "tv"};

std::vector<std::string> with_colours(std::vector<std::string> options) {
  options.insert(options.end(), kColours.begin(), kColours.end());
  return options;
}

const std::vector<VideoFormat>& formats() {
  static const std::vector<std::string> x264 = {"-c:v", "libx264", "-preset", "medium", "-crf", "18"};
  static const std::vector<VideoFormat> list = {
      {".mp4", "mp4", true,
       [] {
         std::vector<std::string> options = with_colours(x264);
         options.insert(options.end(), {"-movflags", "+faststart"});
         return options;
       }()},
      {".mkv", "matroska", true, with_colours(x264)},
      {".webm", "webm", true,
       with_colours({"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1"})},
      {".gif",
       "gif",
       false,
       {"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-loop", "0"}}};
  return list;
}

const VideoFormat* video_format_of(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  const auto found = std::find_if(formats().begin(), formats().end(),
                                  [&](const VideoFormat& format) { return extension == format.extension; });
  return found == formats().end() ? nullptr : &*found;
}

// No dates, no versions: as far as ffmpeg allows, the same frames give the same bytes.
std::vector<std::string> arguments_for(const VideoFormat& format, const std::string& output, int width,
                                       int height, double rate) {
  std::vector<std::string> arguments = {find_program("ffmpeg").string(),
                                        "-hide_banner",
                                        "-loglevel",
                                        "error",
                                        "-nostdin",
                                        "-y",
                                        "-f",
                                        "rawvideo",
                                        "-pixel_format",
                                        "rgb24",
                                        "-video_size",
                                        std::to_string(width) + "x" + std::to_string(height),
                                        "-framerate",
                                        significant(rate, 9),
                                        "-i",
                                        "pipe:0",
                                        "-an",
                                        "-map_metadata",
                                        "-1",
                                        "-fflags",
                                        "+bitexact",
                                        "-flags:v",
                                        "+bitexact"};
  arguments.insert(arguments.end(), format.options.begin(), format.options.end());
  // "file:" keeps ffmpeg from reading a protocol into the name.
  arguments.insert(arguments.end(), {"-f", format.container, "file:" + output});
  return arguments;
}

int even(int size, bool wanted) { return wanted ? size + size % 2 : size; }

}  // namespace

bool is_video(const std::filesystem::path& file) { return video_format_of(file) != nullptr; }

void require_ffmpeg(const std::filesystem::path& file) {
  if (!find_program("ffmpeg").empty()) return;
  throw Error(ExitCode::WrongUsage, file.string() +
                                        ": films need the program ffmpeg, which is not installed here; write "
                                        "pictures instead, as in -o frame.%04d.png");
}

VideoFile::VideoFile(const std::filesystem::path& file, int width, int height, double rate)
    : file_(file),
      width_(even(width, video_format_of(file)->even)),
      height_(even(height, video_format_of(file)->even)),
      pending_(file) {
  require_ffmpeg(file);
  ffmpeg_.emplace(arguments_for(*video_format_of(file), pending_.name(), width_, height_, rate));
}

void VideoFile::fail() {
  throw Error(ExitCode::CannotWrite, file_.string() + ": ffmpeg failed: " + one_line(ffmpeg_->complaint()));
}

void VideoFile::add(const Image& picture) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3);
  for (int y = 0; y < height_; ++y) {
    const int row = picture.height() - 1 - std::min(y, picture.height() - 1);
    for (int x = 0; x < width_; ++x)
      for (int c = 0; c < 3; ++c)
        bytes.push_back(unorm8_from_float(picture.at(std::min(x, picture.width() - 1), row, c)));
  }
  if (ffmpeg_->write_all(bytes.data(), bytes.size())) return;
  ffmpeg_->finish();
  fail();
}

void VideoFile::finish() {
  if (!ffmpeg_->finish()) fail();
  stop_if_interrupted();
  pending_.move_into_place();
}

}  // namespace caustics::app
