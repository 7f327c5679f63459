#include "app/selection.hpp"

#include <algorithm>

#include "app/output/image_layers.hpp"
#include "app/output/image_planes.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

// Where a channel of the file is above 0.
void add_mask(Selection& selection, const std::filesystem::path& path) {
  const ImagePlanes file = read_planes(path);
  std::vector<std::uint8_t> lit(selection.mask.size(), 0);
  for (const Plane& plane : file.planes) {
    if (plane.view.width != selection.width || plane.view.height != selection.height) {
      throw Error(ExitCode::BadInput, path.string() + ": is " +
                                          size_text(plane.view.width, plane.view.height) +
                                          ", the images are " + size_text(selection.width, selection.height) +
                                          "; a mask must have their size");
    }
    if (channel_in_layer(plane.name) == "A" && file.planes.size() > 1) continue;
    for (int y = 0; y < selection.height; ++y) {
      for (int x = 0; x < selection.width; ++x) {
        if (plane.view.at(x, y) > 0.0f) {
          lit[static_cast<std::size_t>(y) * static_cast<std::size_t>(selection.width) +
              static_cast<std::size_t>(x)] = 1;
        }
      }
    }
  }
  selection.mask = std::move(lit);
}

void add_region(Selection& selection, const Region& region) {
  if (region.width > selection.width - region.x || region.height > selection.height - region.y) {
    throw Error(ExitCode::WrongUsage, "--region reaches out of the images, which are " +
                                          size_text(selection.width, selection.height));
  }
  for (int y = 0; y < selection.height; ++y) {
    for (int x = 0; x < selection.width; ++x) {
      const bool inside =
          x >= region.x && x < region.x + region.width && y >= region.y && y < region.y + region.height;
      if (inside) continue;
      selection.mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(selection.width) +
                     static_cast<std::size_t>(x)] = 0;
    }
  }
}

}  // namespace

Region parse_region(const std::string& text) {
  std::vector<int> numbers;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const int least = numbers.size() < 2 ? 0 : 1;
    numbers.push_back(parse_number("--region", text.substr(start, end - start), Limits<int>{least, 1 << 30}));
    start = end + 1;
  }
  if (numbers.size() != 4) {
    throw Error(ExitCode::WrongUsage,
                "--region cannot be " + in_quotes(text) + ": four integers, X,Y,WIDTH,HEIGHT");
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::vector<std::uint8_t> Selection::from_bottom() const {
  std::vector<std::uint8_t> turned;
  turned.reserve(mask.size());
  if (all()) return turned;
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) turned.push_back(has(x, y) ? 1 : 0);
  }
  return turned;
}

Selection select(const ImagePlanes& image, const std::filesystem::path& mask, const Region& region) {
  Selection selection;
  if (mask.empty() && region.width == 0) return selection;
  const ChannelView& first = image.planes.front().view;
  for (const Plane& plane : image.planes) {
    if (plane.view.width != first.width || plane.view.height != first.height) {
      throw Error(ExitCode::BadInput, "channels " + one_line(image.planes.front().name) + " and " +
                                          one_line(plane.name) + " are of two sizes; name one with --layer");
    }
  }
  selection.width = first.width;
  selection.height = first.height;
  selection.mask.assign(static_cast<std::size_t>(first.width) * static_cast<std::size_t>(first.height), 1);
  if (!mask.empty()) add_mask(selection, mask);
  if (region.width > 0) add_region(selection, region);
  for (const std::uint8_t each : selection.mask) selection.texels += each;
  if (selection.texels == 0) {
    throw Error(ExitCode::BadInput, (mask.empty() ? std::string("--region") : mask.string()) +
                                        ": selects no texel of the images");
  }
  return selection;
}

}  // namespace caustics::app
