#include "lab/study/sentence.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/gpu/sha256.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::study {

namespace {

constexpr std::size_t kLongestName = 120;  // of a file, without its extension

// Do the frames' times of both overlap, so that the medians' difference says little?
bool overlap(const Times& a, const Times& b) { return a.least <= b.most && b.least <= a.most; }

std::string quantity(const std::string& name, double from, double to, const std::string& unit) {
  const std::string change = change_text(from, to);
  std::string text = name;
  if (!change.empty()) text += " " + change;
  return text + " (" + short_number(from) + " to " + short_number(to) + unit + ")";
}

std::string error_part(const StudyRow& from, const StudyRow& to) {
  const auto &a = from.figures.relative_l1, &b = to.figures.relative_l1;
  if (!a || !b) return "no error to compare";
  std::string text = quantity("error", *a, *b, "");
  if (to.reference_limited) text += ", as small as the truth's own noise can tell";
  return text;
}

std::string time_part(const Times& from, const Times& to) {
  std::string text = quantity("time", from.median, to.median, " ms");
  if (overlap(from, to)) text += ", within the spread of the frames";
  return text;
}

bool plain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '-';
}

}  // namespace

std::string change_text(double from, double to) {
  if (!(from > 0.0) || !std::isfinite(to)) return {};
  const double ratio = to / from;
  if (ratio >= 2.0) return "x " + short_number(ratio);
  const double change = std::round((ratio - 1.0) * 100.0);
  std::string text(1, change < 0.0 ? '-' : '+');
  return text.append(short_number(std::fabs(change))).append(" %");
}

std::string step_sentence(const Knob& knob, std::size_t knob_index, const StudyRow& from,
                          const StudyRow& to) {
  const std::string head =
      knob.key + " from " + from.point.values[knob_index] + " to " + to.point.values[knob_index] + ": ";
  for (const StudyRow* row : {&from, &to})
    if (!row->problem.empty()) return head + "no answer, " + row->problem;
  return head + error_part(from, to) + ", " + time_part(from.caustic, to.caustic);
}

std::string point_text(const std::vector<Knob>& knobs, const Point& point) {
  std::string text;
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    if (point.values[k] == knobs[k].base) continue;
    text += (text.empty() ? "" : ", ") + knobs[k].key + " " + point.values[k];
  }
  return text.empty() ? "base" : text;
}

std::string point_file(const std::vector<Knob>& knobs, const Point& point) {
  std::string name;
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    if (point.values[k] == knobs[k].base) continue;
    name += (name.empty() ? "" : "_") + knobs[k].key + point.values[k];
  }
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !plain(c) && c != '_'; }, '-');
  if (name.size() <= kLongestName) return name.empty() ? "base" : name;
  Sha256 hash;
  hash.add(name.data(), name.size());
  return name.substr(0, kLongestName - 17) + "_" + hash.hexadecimal().substr(0, 16);
}

std::string short_number(double value) {
  if (!(std::fabs(value) >= 99.95) || !(std::fabs(value) < 1e9)) return significant(value, 3);
  return std::to_string(std::llround(value));
}

std::string ratio_text(const std::optional<double>& value) {
  return value ? significant(*value, *value < 1.0 ? 4 : 5) : "n/a";
}

std::string figure_text(const std::optional<double>& value) { return value ? short_number(*value) : "n/a"; }

}  // namespace caustics::study
