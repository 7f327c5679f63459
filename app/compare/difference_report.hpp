// What `caustics compare` prints: tables for people, JSON for programs. No locale has a say.
#pragma once
#include <string>
#include <vector>

#include "app/compare/folder_difference.hpp"
#include "app/compare/image_difference.hpp"
#include "app/compare/measurement.hpp"
#include "app/compare/metric_bounds.hpp"

namespace caustics::app {

// What was compared, as the user named it.
struct Comparison {
  std::string a, b;
  Tolerance tolerance;
};

// Two images: value by value, in figures, and under --fail-above.
struct ImageAnswer {
  PlanesDifference difference;
  std::vector<std::string> looks_like;  // likenesses() of what is different
  Measurement measurement;
  std::vector<BoundAnswer> bounds;

  // What fails under bounds too: a channel without a counterpart, a NaN. "" if nothing does.
  std::string fatal() const;
  // Without bounds, whether the values are equal or within the tolerance; with them, whether they
  // hold and nothing is fatal.
  bool passed() const;
};

// Lines with a line break each; the last is what decides: the verdict, or the bounds.
std::string report_text(const Comparison& comparison, const ImageAnswer& answer);
std::string report_text(const Comparison& comparison, const FolderDifference& difference);

std::string report_json(const Comparison& comparison, const ImageAnswer& answer);
std::string report_json(const Comparison& comparison, const FolderDifference& difference);

}  // namespace caustics::app
