#include "pipeline/views/sub_pixel.hpp"

namespace caustics {

namespace {

constexpr SubPixel kOne[] = {{0, 0}};
constexpr SubPixel kFour[] = {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
constexpr SubPixel kEight[] = {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
constexpr SubPixel kSixteen[] = {{1, 1},  {-1, -3}, {-3, 2},  {4, -1}, {-5, -2}, {2, 5},  {5, 3}, {3, -5},
                                 {-2, 6}, {0, -7},  {-4, -6}, {-6, 4}, {-8, 0},  {7, -4}, {6, 7}, {-7, -8}};

}  // namespace

std::span<const SubPixel> sub_pixels(int samples) {
  switch (samples) {
    case 4:
      return kFour;
    case 8:
      return kEight;
    case 16:
      return kSixteen;
    default:
      return kOne;
  }
}

View shifted(const View& view, const SubPixel& by, int width, int height) {
  const glm::dvec2 pixel = (view.window_upper - view.window_lower) / glm::dvec2(width, height);
  const glm::dvec2 shift = glm::dvec2(by.x, by.y) / 16.0 * pixel;
  View result = view;
  result.window_lower += shift;
  result.window_upper += shift;
  return result;
}

View around_samples(const View& view, int samples, int width, int height) {
  if (samples == 1) return view;
  const glm::dvec2 pixel = (view.window_upper - view.window_lower) / glm::dvec2(width, height);
  View result = view;
  result.window_lower -= pixel;
  result.window_upper += pixel;
  return result;
}

}  // namespace caustics
