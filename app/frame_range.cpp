#include "app/frame_range.hpp"

#include <algorithm>
#include <cmath>

#include "app/shell/parser.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

namespace {

constexpr int kLastFrame = 999'999;

// "%d" or "%04d" in a name: where it stands, and how many digits it asks for.
struct NumberField {
  std::size_t begin = std::string::npos, length = 0;
  std::size_t digits = 0;
};

NumberField find_number(const std::string& name) {
  for (std::size_t i = name.find('%'); i != std::string::npos; i = name.find('%', i + 1)) {
    if (name.compare(i, 2, "%d") == 0) return {i, 2, 1};
    const bool padded = name[i + 1] == '0' && name[i + 2] >= '1' && name[i + 2] <= '9' && name[i + 3] == 'd';
    if (padded) return {i, 4, static_cast<std::size_t>(name[i + 2] - '0')};
  }
  return {};
}

}  // namespace

FrameRange parse_frames(const std::string& text) {
  const std::size_t dots = text.find("..");
  FrameRange range;
  range.first = parse_number("--frames", text.substr(0, dots), Limits<int>{0, kLastFrame});
  range.last = dots == std::string::npos
                   ? range.first
                   : parse_number("--frames", text.substr(dots + 2), Limits<int>{0, kLastFrame});
  if (range.last < range.first) {
    throw Error(ExitCode::WrongUsage,
                "--frames cannot be " + in_quotes(text) + ": the first frame comes first, as in 0..9");
  }
  return range;
}

FrameRange frames_up_to(double count) {
  const double last = std::ceil(std::clamp(count, 1.0, kLastFrame + 1.0)) - 1.0;
  return {0, static_cast<int>(last)};
}

bool has_number(const std::filesystem::path& file) {
  return find_number(file.filename().string()).length > 0;
}

std::filesystem::path numbered(const std::filesystem::path& file, int frame) {
  std::string name = file.filename().string();
  const NumberField field = find_number(name);
  if (field.length == 0) return file;
  std::string number = std::to_string(frame);
  number.insert(0, field.digits - std::min(field.digits, number.size()), '0');
  return file.parent_path() / name.replace(field.begin, field.length, number);
}

}  // namespace caustics::app
