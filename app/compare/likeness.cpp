#include "app/compare/likeness.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "app/output/image_layers.hpp"
#include "app/shell/interrupt.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

// What is left of the difference, at most, where a cause explains it.
constexpr double kUnexplained = 0.01;
// Values that must differ before a rounding or a factor is more than chance.
constexpr std::size_t kLeastDiffering = 8;
// Rounding to half floats moves values by up to 2^-11 of them; of 8 values some by more than this.
constexpr double kLeastOfHalf = 1.0 / 16384.0;

using Channels = std::vector<const ChannelDifference*>;

struct LikenessInput {
  Channels channels;  // those that differ, all of one size
  const Selection& selection;
  double difference = 0.0;    // sum |A - B| over them
  std::size_t differing = 0;  // values
  double largest_relative = 0.0;

  const ChannelView& a(std::size_t i) const { return channels[i]->a->view; }
  const ChannelView& b(std::size_t i) const { return channels[i]->b->view; }
  int width() const { return a(0).width; }
  int height() const { return a(0).height; }

  // Sums `value` over the selected texels.
  template <class Value>
  double sum(const Value& value) const {
    double total = 0.0;
    for (int y = 0; y < height(); ++y)
      for (int x = 0; x < width(); ++x)
        if (selection.has(x, y)) total += value(x, y);
    stop_if_interrupted();
    return total;
  }
  bool explains(double left) const { return left <= kUnexplained * difference; }
};

double apart(float a, float b) { return std::abs(static_cast<double>(a) - static_cast<double>(b)); }

// Channels that differ, where all of their values can be compared.
bool gather(const PlanesDifference& difference, LikenessInput& input) {
  for (const ChannelDifference& channel : difference.channels) {
    const ValueDifference& values = channel.values;
    if (!channel.mismatch.empty() || values.has_nan() || values.infinite > 0) return false;
    if (values.differing == 0) continue;
    input.channels.push_back(&channel);
    input.differing += values.differing;
    input.largest_relative = std::max(input.largest_relative, values.relative.largest);
    input.difference += values.absolute.mean * static_cast<double>(values.values);
  }
  return !input.channels.empty() &&
         std::all_of(input.channels.begin(), input.channels.end(), [&](const ChannelDifference* each) {
           return each->a->view.width == input.width() && each->a->view.height == input.height();
         });
}

// "R", "R and G", "R, G and B", by their names without the layer where they have one layer.
std::string names_of(const Channels& channels) {
  std::string text;
  for (std::size_t i = 0; i < channels.size(); ++i)
    text += (i == 0 ? "" : i + 1 == channels.size() ? " and " : ", ") + one_line(channels[i]->name);
  return text;
}

std::string upside_down(const LikenessInput& input) {
  if (!input.selection.all()) return "";
  double left = 0.0;
  for (std::size_t i = 0; i < input.channels.size(); ++i)
    left += input.sum(
        [&](int x, int y) { return apart(input.a(i).at(x, input.height() - 1 - y), input.b(i).at(x, y)); });
  return input.explains(left) ? "upside down (A's rows from below are B's from above)" : "";
}

// "swapped channels (R and B)", or what each channel of B is in A.
std::string order_text(const Channels& channels, const std::vector<std::size_t>& order) {
  Channels moved;
  std::string text;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] == i) continue;
    moved.push_back(channels[i]);
    text += (text.empty() ? "" : ", ") + one_line(channels[order[i]]->name) + " of A is " +
            one_line(channels[i]->name) + " of B";
  }
  return moved.size() == 2 ? "swapped channels (" + names_of(moved) + ")"
                           : "channels in another order (" + text + ")";
}

std::string swapped_channels(const LikenessInput& input) {
  const std::size_t count = input.channels.size();
  if (count < 2 || count > 4) return "";
  std::vector<std::vector<double>> left(count, std::vector<double>(count));  // of B's channel by A's
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      left[i][j] = input.sum([&](int x, int y) { return apart(input.a(j).at(x, y), input.b(i).at(x, y)); });
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  while (std::next_permutation(order.begin(), order.end())) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += left[i][order[i]];
    if (input.explains(sum)) return order_text(input.channels, order);
  }
  return "";
}

std::string half_precision(const LikenessInput& input) {
  if (input.differing < kLeastDiffering || input.largest_relative < kLeastOfHalf) return "";
  const auto half = [](float value) { return stored_value(Format::RGBA16F, value); };
  double left_of_a = 0.0, left_of_b = 0.0;
  for (std::size_t i = 0; i < input.channels.size(); ++i) {
    left_of_a +=
        input.sum([&](int x, int y) { return apart(input.a(i).at(x, y), half(input.b(i).at(x, y))); });
    left_of_b +=
        input.sum([&](int x, int y) { return apart(half(input.a(i).at(x, y)), input.b(i).at(x, y)); });
  }
  if (input.explains(left_of_a)) return "half precision (A is B rounded to 16-bit floats)";
  return input.explains(left_of_b) ? "half precision (B is A rounded to 16-bit floats)" : "";
}

// A = factor B by least squares.
std::string constant_factor(const LikenessInput& input) {
  if (input.differing < kLeastDiffering) return "";
  double product = 0.0, square = 0.0, left = 0.0;
  for (std::size_t i = 0; i < input.channels.size(); ++i) {
    const auto a = [&](int x, int y) { return static_cast<double>(input.a(i).at(x, y)); };
    const auto b = [&](int x, int y) { return static_cast<double>(input.b(i).at(x, y)); };
    product += input.sum([&](int x, int y) { return a(x, y) * b(x, y); });
    square += input.sum([&](int x, int y) { return b(x, y) * b(x, y); });
  }
  const double factor = product / square;
  if (!std::isfinite(factor) || factor == 0.0) return "";
  for (std::size_t i = 0; i < input.channels.size(); ++i)
    left += input.sum([&](int x, int y) {
      return std::abs(static_cast<double>(input.a(i).at(x, y)) -
                      factor * static_cast<double>(input.b(i).at(x, y)));
    });
  if (!input.explains(left)) return "";
  const std::string times = significant(factor, 6);
  return "off by a factor of " + times + " (A is " + times + " times B, in " + names_of(input.channels) + ")";
}

}  // namespace

std::vector<std::string> likenesses(const PlanesDifference& difference, const Selection& selection) {
  LikenessInput input{.channels = {}, .selection = selection};
  if (!gather(difference, input)) return {};
  std::vector<std::string> found;
  for (const auto cause : {upside_down, swapped_channels, half_precision, constant_factor})
    if (std::string text = cause(input); !text.empty()) found.push_back(std::move(text));
  return found;
}

}  // namespace caustics::app
