// What `caustics compare` finds out about two image files, before any of it is printed.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/output/image_planes.hpp"
#include "app/selection.hpp"

namespace caustics::app {

enum class Verdict { Equal, WithinTolerance, Different };

// "equal", "within tolerance", "different".
const char* name_of(Verdict verdict);

// One channel, lined up by its name.
struct ChannelDifference {
  std::string name;
  std::string mismatch;  // why values cannot be compared: in one image only, or another size
  const Plane* a = nullptr;
  const Plane* b = nullptr;
  ValueDifference values;  // where `mismatch` is empty

  // A NaN makes it different, also where both images have it: it says nothing about either.
  Verdict verdict() const;
};

// The planes' owners live as long as this.
struct PlanesDifference {
  std::vector<ChannelDifference> channels;  // in A's order, then those that only B has

  Verdict verdict() const;  // the worst of the channels
  // Pairs of values, and those that no tolerance or NaN rule lets pass.
  std::size_t values() const;
  std::size_t failing_values() const;
  std::size_t differing_values() const;
};

// Of the selected texels alone.
PlanesDifference compare_planes(const ImagePlanes& a, const ImagePlanes& b, const Tolerance& tolerance,
                                const Selection& selection = {});

// Values of a channel that make it fail: beyond the tolerance, or NaN in both.
std::size_t failing(const ValueDifference& difference);

}  // namespace caustics::app
