// What `caustics compare` prints: tables for people, JSON for programs. No locale has a say.
#pragma once
#include <string>

#include "app/folder_difference.hpp"
#include "app/image_difference.hpp"

namespace caustics::app {

// What was compared, as the user named it.
struct Comparison {
  std::string a, b;
  Tolerance tolerance;
};

// Lines with a line break each; the last is the verdict.
std::string report_text(const Comparison& comparison, const PlanesDifference& difference);
std::string report_text(const Comparison& comparison, const FolderDifference& difference);

std::string report_json(const Comparison& comparison, const PlanesDifference& difference);
std::string report_json(const Comparison& comparison, const FolderDifference& difference);

}  // namespace caustics::app
