// Random numbers by counter: what a ray draws depends on its own number alone, not on what was drawn before
// or on which thread, so that a picture has the same bits for every number of threads.
#pragma once
#include <cstdint>

namespace caustics::tracer {

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014; variant 13 of Stafford): a bijection that turns
// every input bit into half of the output bits.
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

// The numbers of one ray, SplitMix64 started at a place of its own.
class Numbers {
 public:
  Numbers(std::uint64_t stream, std::uint64_t ray)
      : state_(mixed(mixed(stream + kStep) + (ray + 1) * kStep)) {}
  // In [0, 1), 53 bits.
  double next() {
    state_ += kStep;
    return static_cast<double>(mixed(state_) >> 11) * 0x1p-53;
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ull;
  std::uint64_t state_;
};

// Where `index` (below `count`) goes in a shuffle of 0 .. count - 1 that `key` chooses: a bijection of the
// next power of two, walked until it falls into the range (Kensler 2013, with rounds of our own).
std::uint64_t shuffled(std::uint64_t index, std::uint64_t count, std::uint64_t key);

}  // namespace caustics::tracer
