#include "lab/reference/tracer/numbers.hpp"

namespace caustics::tracer {

std::uint64_t shuffled(std::uint64_t index, std::uint64_t count, std::uint64_t key) {
  int bits = 1;
  while ((std::uint64_t{1} << bits) < count) ++bits;
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  const int shift = bits / 2 + 1;
  // Each step can be undone within the mask: adding, multiplying by an odd number, folding higher bits in.
  do {
    for (std::uint64_t round = 0; round < 4; ++round) {
      const std::uint64_t own = mixed(key + round);
      index = (index + own) & mask;
      index = (index * (2 * mixed(own) + 1)) & mask;
      index ^= index >> shift;
    }
  } while (index >= count);
  return index;
}

}  // namespace caustics::tracer
