#include "app/parity_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/shell/table.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

using Json = nlohmann::ordered_json;

namespace {

std::string without_light(const std::string& name) { return name.substr(0, name.find('[')); }

bool any_beyond(const std::vector<JudgedAttachment>& judged) {
  return std::any_of(judged.begin(), judged.end(),
                     [](const JudgedAttachment& a) { return a.verdict == ParityVerdict::Beyond; });
}

std::string nan_text(const ValueDifference& all) {
  if (!all.has_nan()) return "0";
  return std::to_string(all.nan_both) + " both, " + std::to_string(all.nan_only_a) + " / " +
         std::to_string(all.nan_only_b);
}

std::string values_text(const std::array<float, 4>& values, std::size_t channels) {
  std::string text;
  for (std::size_t c = 0; c < channels; ++c) {
    if (c > 0) text += ' ';
    text += significant(static_cast<double>(values[c]), 9);
  }
  return text;
}

// "    first at 12,40: 0.5 0.25 0 1, gl 0.5 0.25 0 1.00000012"
std::string first_text(const ImageDifference& d) {
  if (!d.all.first) return {};
  return "      first at " + std::to_string(d.all.first->x) + "," + std::to_string(d.all.first->y) +
         " from the bottom left: software " + values_text(d.first_a, d.channels.size()) + " | gl " +
         values_text(d.first_b, d.channels.size()) + "\n";
}

std::string attachments_text(const std::vector<JudgedAttachment>& judged) {
  Table table({false, false, true, true, true, true, true, true, true, false, false});
  table.row({"pass", "attachment", "texels", "differ", "coverage", "ulp max", "99.9%", "rel. max", "99.9%",
             "NaN", ""});
  std::string firsts;
  for (const JudgedAttachment& a : judged) {
    const ImageDifference& d = a.parity.difference;
    table.row({one_line(a.parity.pass), one_line(a.parity.attachment), grouped(d.texels),
               grouped(d.differing_texels), grouped(d.coverage_mismatches),
               significant(d.all.ulps.largest, 4), significant(d.all.ulps.p999, 4),
               significant(d.all.relative.largest, 3), significant(d.all.relative.p999, 3), nan_text(d.all),
               name_of(a.verdict)});
    if (a.verdict == ParityVerdict::Equal) continue;
    firsts += "  " + one_line(a.parity.pass) + " " + one_line(a.parity.attachment) +
              (a.reason.empty() ? "" : " (" + a.reason + ")") + "\n" + first_text(d);
  }
  return table.text() + firsts;
}

std::string counts_text(const std::vector<PassCounts>& counts) {
  Table table({false, true, true, true, true, false});
  table.row({"pass", "vertices", "primitives", "samples passed", "fragments", ""});
  for (const PassCounts& c : counts) {
    const auto both = [](std::uint64_t a, std::uint64_t b) {
      return a == b ? grouped(a) : grouped(a) + " | " + grouped(b);
    };
    table.row({one_line(c.pass), both(c.reference.vertices, c.tested.vertices),
               both(c.reference.primitives, c.tested.primitives),
               c.counts_samples ? both(c.reference.samples_passed, c.tested.samples_passed) : "-",
               both(c.reference.fragments, c.tested.fragments), c.equal() ? "equal" : "DIFFER"});
  }
  return table.text();
}

Json values_json(const std::array<float, 4>& values, std::size_t channels) {
  Json list = Json::array();
  for (std::size_t c = 0; c < channels; ++c) list.push_back(values[c]);
  return list;
}

Json attachment_json(const JudgedAttachment& a) {
  const ImageDifference& d = a.parity.difference;
  Json json = {{"pass", a.parity.pass},
               {"attachment", a.parity.attachment},
               {"same_shape", d.same_shape},
               {"texels", d.texels},
               {"differing_texels", d.differing_texels},
               {"differing_values", d.all.differing},
               {"coverage_mismatches", d.coverage_mismatches},
               {"ulps", {{"max", d.all.ulps.largest}, {"p99.9", d.all.ulps.p999}}},
               {"relative", {{"max", d.all.relative.largest}, {"p99.9", d.all.relative.p999}}},
               {"nan", {{"both", d.all.nan_both}, {"software", d.all.nan_only_a}, {"gl", d.all.nan_only_b}}},
               {"verdict", name_of(a.verdict)}};
  if (!a.reason.empty()) json["reason"] = a.reason;
  if (d.all.first) {
    json["first"] = {{"x", d.all.first->x},
                     {"y", d.all.first->y},
                     {"software", values_json(d.first_a, d.channels.size())},
                     {"gl", values_json(d.first_b, d.channels.size())}};
  }
  return json;
}

Json result_json(const PassResult& result, bool counts_samples) {
  Json json = {{"vertices", result.vertices},
               {"primitives", result.primitives},
               {"fragments", result.fragments},
               {"milliseconds", result.milliseconds}};
  if (counts_samples) json["samples_passed"] = result.samples_passed;
  return json;
}

}  // namespace

const char* name_of(ParityVerdict verdict) {
  switch (verdict) {
    case ParityVerdict::Equal:
      return "equal";
    case ParityVerdict::Allowed:
      return "allowed";
    case ParityVerdict::Beyond:
      return "DIFFERS";
  }
  return "?";
}

bool ParityReport::passes() const {
  return !any_beyond(isolated) && !any_beyond(whole_frame) &&
         std::all_of(counts.begin(), counts.end(), [](const PassCounts& c) { return c.equal(); });
}

std::size_t ParityReport::differing_values() const {
  std::size_t sum = 0;
  for (const auto* list : {&isolated, &whole_frame}) {
    for (const JudgedAttachment& a : *list) sum += a.parity.difference.all.differing;
  }
  return sum;
}

std::vector<JudgedAttachment> judge(const std::vector<AttachmentParity>& found, AllowanceBook& book,
                                    const std::function<std::string(const std::string& label)>& pass_name) {
  std::vector<JudgedAttachment> judged;
  for (const AttachmentParity& parity : found) {
    JudgedAttachment a{parity, ParityVerdict::Equal, {}};
    if (!parity.difference.same_shape || parity.difference.differing_texels > 0) {
      const Allowance* allowance =
          book.covers(pass_name(parity.pass), without_light(parity.attachment), parity.difference);
      a.verdict = allowance ? ParityVerdict::Allowed : ParityVerdict::Beyond;
      if (allowance) a.reason = allowance->reason;
    }
    judged.push_back(std::move(a));
  }
  return judged;
}

std::string parity_text(const ParityReport& report) {
  std::string text = one_line(report.scene) + "\n  software  " + report.reference + "\n  gl        " +
                     report.tested + "\n\n";
  text += "each pass on the software device's inputs\n" + attachments_text(report.isolated);
  text += "\ncounts (software | gl)\n" + counts_text(report.counts);
  text += "\nthe whole frame, each backend by itself\n" + attachments_text(report.whole_frame);
  return text;
}

Json parity_json(const ParityReport& report) {
  Json json = {{"scene", report.scene},
               {"software", report.reference},
               {"gl", report.tested},
               {"driver", {{"name", report.driver}, {"measured", report.measured}}},
               {"differing_values", report.differing_values()},
               {"within_allowances", report.passes()},
               {"isolated", Json::array()},
               {"whole_frame", Json::array()},
               {"counts", Json::array()}};
  for (const JudgedAttachment& a : report.isolated) json["isolated"].push_back(attachment_json(a));
  for (const JudgedAttachment& a : report.whole_frame) {
    json["whole_frame"].push_back(attachment_json(a));
  }
  for (const PassCounts& c : report.counts) {
    json["counts"].push_back({{"pass", c.pass},
                              {"equal", c.equal()},
                              {"software", result_json(c.reference, c.counts_samples)},
                              {"gl", result_json(c.tested, c.counts_samples)}});
  }
  return json;
}

}  // namespace caustics::app
