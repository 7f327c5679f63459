#include "app/output/stated_error.hpp"

#include <cmath>

#include "app/shell/on_demand.hpp"

namespace caustics::app {

namespace {

// Pixels of what catches caustics: the first surface is the first of those that are no casters.
bool shows_receiver(const Image& first, const Image& receiver, int x, int y) {
  bool same = receiver.at(x, y, 3) != 0.0f;
  for (int c = 0; c < 3; ++c) same = same && first.at(x, y, c) == receiver.at(x, y, c);
  return same;
}

void add_surplus(Image& error, const std::vector<bool>& shown, const Surplus& surplus,
                 const glm::dvec3& intensity) {
  std::vector<int> pixels(surplus.values.size() / 3, 0);
  const auto width = static_cast<std::size_t>(error.width());
  const auto block_of = [&](std::size_t i) {
    const auto side = static_cast<std::size_t>(surplus.side);
    return i / width / side * surplus.across + i % width / side;
  };
  for (std::size_t i = 0; i < shown.size(); ++i) pixels[block_of(i)] += shown[i] ? 1 : 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!shown[i]) continue;
    const std::size_t block = block_of(i);
    for (int c = 0; c < 3; ++c)
      error.at(static_cast<int>(i % width), static_cast<int>(i / width), c) += static_cast<float>(
          std::fabs(surplus.values[3 * block + static_cast<std::size_t>(c)]) / pixels[block] * intensity[c]);
  }
}

}  // namespace

Image stated_error(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers) {
  const Image first = frame.read("aov_position"), receiver = frame.read("view_position");
  const Image caustic = frame.read("aov_caustic");
  Image error(Format::RGBA32F, caustic.width(), caustic.height());
  const ErrorEstimate all = error_of(frame, ledgers);
  const double of_sizes = all.relative(all.map + all.grid + all.missing);
  std::vector<bool> shown;
  for (int y = 0; y < error.height(); ++y)
    for (int x = 0; x < error.width(); ++x) {
      shown.push_back(shows_receiver(first, receiver, x, y));
      for (int c = 0; c < 3; ++c)
        error.at(x, y, c) = static_cast<float>(of_sizes * static_cast<double>(caustic.at(x, y, c)));
    }
  for (const LightLedger& entry : ledgers)
    if (!entry.surplus.values.empty())
      add_surplus(error, shown, entry.surplus, caustic_intensity_of(frame, entry.light));
  return error;
}

}  // namespace caustics::app
