#include "app/compare/difference_report.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/compare/measurement_report.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

using TextRow = std::vector<std::string>;

// Columns two blanks apart: the first and those called "worst" flush left, the others flush right.
// A row of two words is a name with a remark, which runs below the columns.
std::string table(const std::vector<TextRow>& rows) {
  const TextRow& head = rows.front();
  std::vector<std::size_t> widths(head.size());
  for (const TextRow& row : rows) {
    const std::size_t aligned = row.size() == head.size() ? row.size() : 1;
    for (std::size_t i = 0; i < aligned; ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const TextRow& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - std::min(widths[i], row[i].size()), ' ');
      const bool flush_left = i == 0 || head[i] == "worst" || row.size() != head.size();
      line += (i == 0 ? "" : "  ") + (flush_left ? row[i] + blanks : blanks + row[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

// The shortest digits that read back as the same float.
std::string exact(float value) {
  if (std::isnan(value)) return "nan";
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

std::string place(const ValuePair& pair) { return std::to_string(pair.x) + "," + std::to_string(pair.y); }

bool is_finite(const ValuePair& pair) { return std::isfinite(pair.a) && std::isfinite(pair.b); }

double gap(const ValuePair& pair) {
  return std::abs(static_cast<double>(pair.a) - static_cast<double>(pair.b));
}

// The channel whose worst texel is the worst of all; null where all values are the same.
const ChannelDifference* worst_channel(const PlanesDifference& difference) {
  const ChannelDifference* worst = nullptr;
  for (const ChannelDifference& channel : difference.channels) {
    if (!channel.values.worst) continue;
    const ValuePair& pair = *channel.values.worst;
    if (worst == nullptr) {
      worst = &channel;
    } else if (is_finite(*worst->values.worst) &&
               (!is_finite(pair) || gap(pair) > gap(*worst->values.worst))) {
      worst = &channel;
    }
  }
  return worst;
}

std::string worst_text(const ChannelDifference& channel) {
  const ValuePair& pair = *channel.values.worst;
  return one_line(channel.name) + " at " + place(pair) + ": A " + exact(pair.a) + ", B " + exact(pair.b);
}

TextRow channel_row(const ChannelDifference& channel) {
  TextRow row = {one_line(channel.name)};
  if (!channel.mismatch.empty()) {
    row.push_back(channel.mismatch);
    return row;
  }
  const ValueDifference& d = channel.values;
  row.insert(row.end(),
             {grouped(d.differing), significant(d.absolute.largest, 4), significant(d.absolute.p999, 4),
              significant(d.absolute.mean, 4), significant(d.relative.largest, 4),
              grouped(static_cast<std::uint64_t>(d.ulps.largest))});
  row.push_back(d.worst ? place(*d.worst) : "-");
  row.push_back(d.worst ? exact(d.worst->a) : "-");
  row.push_back(d.worst ? exact(d.worst->b) : "-");
  return row;
}

// "R: NaN in A only 1, in B only 0, in both 2; infinite 0", or nothing.
std::string non_finite_line(const ChannelDifference& channel) {
  const ValueDifference& d = channel.values;
  if (!d.has_nan() && d.infinite == 0) return "";
  return one_line(channel.name) + ": NaN in A only " + grouped(d.nan_only_a) + ", in B only " +
         grouped(d.nan_only_b) + ", in both " + grouped(d.nan_both) + "; infinite in one only " +
         grouped(d.infinite) + "\n";
}

// "1 channel", "7 channels".
std::string counted(std::size_t count, const std::string& noun) {
  return grouped(count) + " " + noun + (count == 1 ? "" : "s");
}

bool allows_nothing(const Tolerance& tolerance) {
  return tolerance.absolute == 0.0 && tolerance.relative == 0.0;
}

std::string tolerance_text(const Tolerance& tolerance) {
  if (allows_nothing(tolerance)) return "";
  return "allowed: |A-B| up to " + significant(tolerance.absolute, 6) + ", or up to " +
         significant(tolerance.relative, 6) + " of the larger value\n";
}

std::string verdict_line(const PlanesDifference& difference) {
  const Verdict verdict = difference.verdict();
  const std::string values = counted(difference.values(), "value");
  std::string line = std::string(name_of(verdict)) + ": ";
  if (verdict == Verdict::Equal) {
    return line + counted(difference.channels.size(), "channel") + ", " + values + "\n";
  }
  if (verdict == Verdict::WithinTolerance) {
    return line + grouped(difference.differing_values()) + " of " + values +
           " differ, none by more than is allowed\n";
  }
  const auto unmatched = std::count_if(difference.channels.begin(), difference.channels.end(),
                                       [](const ChannelDifference& each) { return !each.mismatch.empty(); });
  if (unmatched > 0)
    line += counted(static_cast<std::size_t>(unmatched), "channel") + " without a counterpart; ";
  line += grouped(difference.failing_values()) + " of " + values + " fail";
  const ChannelDifference* worst = worst_channel(difference);
  return line + (worst == nullptr ? "" : "; worst: " + worst_text(*worst)) + "\n";
}

TextRow attachment_row(const AttachmentDifference& attachment) {
  const std::string name = one_line(attachment.name);
  if (!attachment.mismatch.empty()) return {name, attachment.mismatch};
  double absolute = 0.0, relative = 0.0, ulps = 0.0;
  for (const ChannelDifference& channel : attachment.planes.channels) {
    if (!channel.mismatch.empty()) {
      return {name, "channel " + one_line(channel.name) + ": " + channel.mismatch};
    }
    absolute = std::max(absolute, channel.values.absolute.largest);
    relative = std::max(relative, channel.values.relative.largest);
    ulps = std::max(ulps, channel.values.ulps.largest);
  }
  const ChannelDifference* worst = worst_channel(attachment.planes);
  return {name,
          grouped(attachment.planes.differing_values()),
          grouped(attachment.planes.failing_values()),
          significant(absolute, 4),
          significant(relative, 4),
          grouped(static_cast<std::uint64_t>(ulps)),
          worst == nullptr ? "-" : worst_text(*worst)};
}

// A line for each cause that explains a difference; `of` is what differs, or "".
std::string looks_text(const std::string& of, const std::vector<std::string>& causes) {
  std::string text;
  for (const std::string& cause : causes)
    text += (of.empty() ? "" : one_line(of) + " ") + "looks like: " + cause + "\n";
  return text;
}

}  // namespace

std::string ImageAnswer::fatal() const {
  for (const ChannelDifference& channel : difference.channels) {
    if (!channel.mismatch.empty()) {
      return "channel " + one_line(channel.name) + ": " + channel.mismatch;
    }
    if (channel.values.has_nan()) return "channel " + one_line(channel.name) + " has a NaN";
  }
  return "";
}

bool ImageAnswer::passed() const {
  if (bounds.empty()) return difference.verdict() != Verdict::Different;
  return fatal().empty() &&
         std::all_of(bounds.begin(), bounds.end(), [](const BoundAnswer& each) { return each.holds; });
}

std::string report_text(const Comparison& comparison, const ImageAnswer& answer) {
  const PlanesDifference& difference = answer.difference;
  std::vector<TextRow> rows = {{"channel", "differing", "max |A-B|", "99.9%", "mean", "max relative",
                                "max ULPs", "worst x,y", "A", "B"}};
  std::string non_finite;
  for (const ChannelDifference& channel : difference.channels) {
    rows.push_back(channel_row(channel));
    non_finite += non_finite_line(channel);
  }
  return table(rows) + non_finite + "x,y counts from the top left\n" +
         measurement_text(difference, answer.measurement) + tolerance_text(comparison.tolerance) +
         looks_text("", answer.looks_like) + verdict_line(difference) +
         (answer.bounds.empty() ? "" : bounds_line(answer.bounds, answer.fatal()));
}

std::string report_text(const Comparison& comparison, const FolderDifference& difference) {
  std::vector<TextRow> rows = {
      {"attachment", "differing", "failing", "max |A-B|", "max relative", "max ULPs", "worst"}};
  std::size_t different = 0;
  std::string looks;
  for (const AttachmentDifference& attachment : difference.attachments) {
    rows.push_back(attachment_row(attachment));
    looks += looks_text(attachment.name, attachment.looks_like);
    different += attachment.verdict() == Verdict::Different;
  }
  std::string text = table(rows) + "x,y counts from the top left\n" + tolerance_text(comparison.tolerance) +
                     looks + name_of(difference.verdict()) + ": ";
  const std::string attachments = counted(difference.attachments.size(), "attachment");
  if (different == 0) return text + attachments + "\n";
  return text + std::to_string(different) + " of " + attachments +
         "; the first in the order of the passes is " + one_line(difference.first_different) + "\n";
}

}  // namespace caustics::app
