// --frames A..B: which frames are rendered, and the names of the files they are written to.
#pragma once
#include <filesystem>
#include <string>

namespace caustics::app {

struct FrameRange {
  int first = 0, last = 0;
  int count() const { return last - first + 1; }
};

// "3" or "3..20", both ends included, each 0..999999. Throws Error (WrongUsage).
FrameRange parse_frames(const std::string& text);

// The moment that a frame shows, seconds: 24 frames a second.
double seconds_of(int frame);

// Has the file's name a place for the frame's number, as in "frame.%04d.png"?
bool has_number(const std::filesystem::path& file);
// The name with the number in its place; the file itself where it has none.
std::filesystem::path numbered(const std::filesystem::path& file, int frame);

}  // namespace caustics::app
