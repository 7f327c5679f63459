// How far two images differ: the numbers that a comparison prints, in units that suit each
// question.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/gpu/image.hpp"

namespace caustics {

// Representable floats from a to b: 0 for equal values, 1 for neighbours; -0 and 0 are one value.
// Both must not be NaN. An infinity is the neighbour of the largest finite value.
std::uint32_t ulps_between(float a, float b);

// The same value: -0 equals 0, every NaN equals every NaN, an infinity equals itself.
bool same_value(float a, float b);

// What a difference may be: either bound suffices. Zeros allow none.
struct Tolerance {
  double absolute = 0.0;
  double relative = 0.0;  // of the larger magnitude of both values
};

// One measure over all pairs of finite values, the equal ones included.
struct Spread {
  double largest = 0.0;
  double p999 = 0.0;  // nearest rank: the smallest value that at least 99.9 % do not exceed
  double mean = 0.0;
};

// A place, rows counted as they are stored, and the values there.
struct ValuePair {
  int x = 0, y = 0, channel = 0;
  float a = 0.0f, b = 0.0f;
};

// The difference of two equally long lists of values.
struct ValueDifference {
  std::size_t values = 0;            // pairs
  std::size_t differing = 0;         // pairs that are not the same_value
  std::size_t beyond_tolerance = 0;  // of these; a pair of which one is not finite always
  std::size_t nan_only_a = 0, nan_only_b = 0, nan_both = 0;
  std::size_t infinite = 0;  // differing pairs without a NaN of which at least one is infinite
  Spread absolute;
  Spread relative;                 // of the larger magnitude: 0..2, and 1 where one value is 0
  Spread ulps;                     // whole numbers, but for the mean
  std::optional<ValuePair> first;  // the first differing pair
  // The first pair with a NaN or another infinity; without one, the first of the largest absolute
  // difference; none where all values are the same.
  std::optional<ValuePair> worst;

  bool has_nan() const { return nan_only_a + nan_only_b + nan_both > 0; }
};

// Gathers a ValueDifference pair by pair. Keeps 20 bytes for each differing pair.
class DifferenceCounter {
 public:
  explicit DifferenceCounter(const Tolerance& tolerance) : tolerance_(tolerance) {}
  void add(const ValuePair& pair);
  ValueDifference result() const;

 private:
  void add_non_finite(const ValuePair& pair);
  void add_finite(const ValuePair& pair);

  Tolerance tolerance_;
  ValueDifference sum_;
  bool worst_is_non_finite_ = false;
  // Of differing finite pairs only: the other finite pairs are zeros in front of the sorted lists.
  std::vector<double> absolute_, relative_;
  std::vector<std::uint32_t> ulps_;
};

// A rectangle of values that lie `stride` floats apart, row by row: one channel of some image.
struct ChannelView {
  const float* first = nullptr;
  std::size_t stride = 1;
  int width = 0, height = 0;

  float at(int x, int y) const {
    return first[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)) *
                 stride];
  }
};

// Both have one size.
ValueDifference difference(const ChannelView& a, const ChannelView& b, const Tolerance& tolerance = {});

// Sums over the finite pairs of some texels.
struct DifferenceSums {
  double a = 0.0, b = 0.0;
  double magnitude = 0.0;   // of |a|
  double difference = 0.0;  // of |a - b|

  void add(float of_a, float of_b);
  // The relative L1 norm, sum |a - b| / sum |a|; 0 where nothing differs.
  double relative() const;
  // How far the sums themselves are apart, relative to that of |a|.
  double relative_total() const;
};

// Two attachments of one name.
struct ImageDifference {
  bool same_shape = false;  // format and size; where it is false, nothing else is filled in
  std::size_t texels = 0;
  std::size_t differing_texels = 0;  // at least one channel differs
  // Texels of which exactly one equals the background: something is drawn in one image alone.
  std::size_t coverage_mismatches = 0;
  std::size_t covered = 0;  // texels of the first that are not the background
  DifferenceSums sums;      // over all texels
  // Texels of which a channel differs by more than a hundredth of the texel's largest value, and by more than
  // a millionth of the images' largest (of 1 where the first is all 0): something else is there, not the same
  // with another rounding.
  std::size_t jumps = 0;
  DifferenceSums steady;                  // over all that both cover and that do not jump
  std::size_t beyond_a_step = 0;          // values more than 1/255 apart
  ValueDifference all;                    // over all channels together
  std::vector<ValueDifference> channels;  // each by itself
  // All channels of the first differing texel (all.first says where it is); else zeros.
  std::array<float, 4> first_a{}, first_b{};
};

// `background` is what the attachment was cleared to; surplus channels of it are ignored.
ImageDifference difference(const Image& a, const Image& b, const Tolerance& tolerance = {},
                           const std::array<float, 4>& background = {});

}  // namespace caustics
