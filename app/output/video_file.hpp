// Films: frames piped to ffmpeg, which must be installed.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/shell/atomic_file.hpp"
#include "app/shell/child_process.hpp"
#include "pipeline/gpu/image.hpp"

namespace caustics::app {

// Does the name say that it is a film: .mp4, .mkv, .webm or .gif?
bool is_video(const std::filesystem::path& file);
// Throws Error (WrongUsage) where there is no ffmpeg.
void require_ffmpeg(const std::filesystem::path& file);

// A film in the making: complete under its name after finish(), or not there at all.
class VideoFile {
 public:
  // The size of the frames in pixels; frames a second. Throws Error.
  VideoFile(const std::filesystem::path& file, int width, int height, double rate);

  // One frame: the first three channels, encoded for display (sRGB). Films other than .gif have even
  // sizes: an odd last column or row is shown twice. Throws Error (CannotWrite) with ffmpeg's own words.
  void add(const Image& picture);
  // Throws Error (CannotWrite), or Interrupted where a signal came.
  void finish();

 private:
  [[noreturn]] void fail();

  std::filesystem::path file_;
  int width_, height_;  // of the film
  PendingFile pending_;
  std::optional<ChildProcess> ffmpeg_;
};

}  // namespace caustics::app
