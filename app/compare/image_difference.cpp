#include "app/compare/image_difference.hpp"

#include <algorithm>

#include "app/shell/interrupt.hpp"

namespace caustics::app {

namespace {

const Plane* find(const ImagePlanes& image, const std::string& name) {
  for (const Plane& plane : image.planes) {
    if (plane.name == name) return &plane;
  }
  return nullptr;
}

// "64x48", with the place of its data window where that is not the picture's corner.
std::string shape_text(const Plane& plane) {
  std::string text = std::to_string(plane.view.width) + "x" + std::to_string(plane.view.height);
  if (plane.left != 0 || plane.top != 0) {
    text += " at " + std::to_string(plane.left) + "," + std::to_string(plane.top);
  }
  return text;
}

std::string mismatch_of(const Plane* a, const Plane* b) {
  if (b == nullptr) return "only in A";
  if (a == nullptr) return "only in B";
  const std::string shape_a = shape_text(*a), shape_b = shape_text(*b);
  return shape_a == shape_b ? "" : "A is " + shape_a + ", B is " + shape_b;
}

ValueDifference difference_within(const Selection& selection, const ChannelView& a, const ChannelView& b,
                                  const Tolerance& tolerance) {
  if (selection.all()) return difference(a, b, tolerance);
  DifferenceCounter counter(tolerance);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (selection.has(x, y)) counter.add({x, y, 0, a.at(x, y), b.at(x, y)});
    }
  }
  return counter.result();
}

ChannelDifference compare_channel(const Plane* a, const Plane* b, const Tolerance& tolerance,
                                  const Selection& selection) {
  ChannelDifference channel;
  channel.name = (a != nullptr ? a : b)->name;
  channel.a = a;
  channel.b = b;
  channel.mismatch = mismatch_of(a, b);
  if (channel.mismatch.empty()) {
    channel.values = difference_within(selection, a->view, b->view, tolerance);
  }
  stop_if_interrupted();
  return channel;
}

}  // namespace

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Equal:
      return "equal";
    case Verdict::WithinTolerance:
      return "within tolerance";
    case Verdict::Different:
      return "different";
  }
  return "";
}

std::size_t failing(const ValueDifference& difference) {
  return difference.beyond_tolerance + difference.nan_both;
}

Verdict ChannelDifference::verdict() const {
  if (!mismatch.empty() || failing(values) > 0) return Verdict::Different;
  return values.differing > 0 ? Verdict::WithinTolerance : Verdict::Equal;
}

Verdict PlanesDifference::verdict() const {
  Verdict worst = Verdict::Equal;
  for (const ChannelDifference& channel : channels) worst = std::max(worst, channel.verdict());
  return worst;
}

std::size_t PlanesDifference::values() const {
  std::size_t sum = 0;
  for (const ChannelDifference& channel : channels) sum += channel.values.values;
  return sum;
}

std::size_t PlanesDifference::failing_values() const {
  std::size_t sum = 0;
  for (const ChannelDifference& channel : channels) sum += failing(channel.values);
  return sum;
}

std::size_t PlanesDifference::differing_values() const {
  std::size_t sum = 0;
  for (const ChannelDifference& channel : channels) sum += channel.values.differing;
  return sum;
}

PlanesDifference compare_planes(const ImagePlanes& a, const ImagePlanes& b, const Tolerance& tolerance,
                                const Selection& selection) {
  PlanesDifference result;
  for (const Plane& plane : a.planes) {
    result.channels.push_back(compare_channel(&plane, find(b, plane.name), tolerance, selection));
  }
  for (const Plane& plane : b.planes) {
    if (find(a, plane.name) == nullptr) {
      result.channels.push_back(compare_channel(nullptr, &plane, tolerance, selection));
    }
  }
  return result;
}

}  // namespace caustics::app
