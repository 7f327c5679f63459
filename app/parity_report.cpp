#include "app/parity_report.hpp"

#include "app/json.hpp"
#include "app/shell/table.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

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
  Table table(
      {false, false, false, true, true, true, true, true, true, true, true, false, true, true, false});
  table.row({"pass", "attachment", "kind", "texels", "differ", "coverage", "ulp max", "99.9%", "rel. max",
             "99.9%", "rel. L1", "NaN", "found", "at most", ""});
  std::string firsts;
  for (const JudgedAttachment& a : judged) {
    const ImageDifference& d = a.parity.difference;
    const BoundCheck* closest = a.verdict.closest();
    table.row(
        {one_line(a.parity.pass), one_line(a.parity.attachment), std::string(name_of(a.kind)),
         grouped(d.texels), grouped(d.differing_texels), grouped(d.coverage_mismatches),
         significant(d.all.ulps.largest, 4), significant(d.all.ulps.p999, 4),
         significant(d.all.relative.largest, 3), significant(d.all.relative.p999, 3),
         significant(d.sums.relative(), 3), nan_text(d.all),
         closest ? std::string(name_of(closest->bound->measure)) + " " + significant(closest->found, 3) : "",
         closest ? significant(closest->most, 3) : "", std::string(name_of(a.verdict.verdict))});
    if (a.verdict.verdict == caustics::Verdict::Equal) continue;
    firsts += "  " + one_line(a.parity.pass) + " " + one_line(a.parity.attachment) + " (" + a.verdict.reason +
              ")\n" + first_text(d);
  }
  return table.text() + firsts;
}

std::string counts_text(const std::vector<JudgedCounts>& judged) {
  Table table({false, true, true, true, true, false});
  table.row({"pass", "vertices", "primitives", "samples passed", "fragments", ""});
  for (const auto& [c, agree] : judged) {
    const auto both = [](std::uint64_t a, std::uint64_t b) {
      return a == b ? grouped(a) : grouped(a) + " | " + grouped(b);
    };
    table.row({one_line(c.pass), both(c.reference.vertices, c.tested.vertices),
               both(c.reference.primitives, c.tested.primitives),
               c.counts_samples ? both(c.reference.samples_passed, c.tested.samples_passed) : "-",
               both(c.reference.fragments, c.tested.fragments), agree ? "agree" : "DIFFER"});
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
               {"covered_texels", d.covered},
               {"coverage_mismatches", d.coverage_mismatches},
               {"ulps", {{"max", d.all.ulps.largest}, {"p99.9", d.all.ulps.p999}}},
               {"relative", {{"max", d.all.relative.largest}, {"p99.9", d.all.relative.p999}}},
               {"relative_l1", d.sums.relative()},
               {"nan", {{"both", d.all.nan_both}, {"software", d.all.nan_only_a}, {"gl", d.all.nan_only_b}}},
               {"kind", name_of(a.kind)},
               {"verdict", name_of(a.verdict.verdict)}};
  if (!a.verdict.reason.empty()) json["reason"] = a.verdict.reason;
  for (const BoundCheck& c : a.verdict.checks)
    json["bounds"].push_back({{"measure", name_of(c.bound->measure)}, {"found", c.found}, {"most", c.most}});
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

std::string parity_text(const ParityReport& report) {
  std::string text = one_line(report.scene) + "\n  software  " + report.reference + "\n  gl        " +
                     report.tested + "\n  class     " + std::string(name_of(report.judged.driver)) + "\n\n";
  for (const std::string& name : report.judged.missing) text += "MISSING " + one_line(name) + "\n";
  text += "each pass on the software device's inputs\n" + attachments_text(report.judged.isolated);
  text += "\ncounts (software | gl)\n" + counts_text(report.judged.counts);
  text += "\nthe whole frame, each backend by itself\n" + attachments_text(report.judged.whole_frame);
  return text;
}

Json parity_json(const ParityReport& report) {
  Json json = {{"scene", report.scene},
               {"software", report.reference},
               {"gl", report.tested},
               {"driver_class", name_of(report.judged.driver)},
               {"differing_values", report.judged.differing_values()},
               {"within_bounds", report.judged.passes()},
               {"missing", report.judged.missing},
               {"isolated", Json::array()},
               {"whole_frame", Json::array()},
               {"counts", Json::array()}};
  for (const JudgedAttachment& a : report.judged.isolated) json["isolated"].push_back(attachment_json(a));
  for (const JudgedAttachment& a : report.judged.whole_frame) {
    json["whole_frame"].push_back(attachment_json(a));
  }
  for (const auto& [c, agree] : report.judged.counts) {
    json["counts"].push_back({{"pass", c.pass},
                              {"agree", agree},
                              {"software", result_json(c.reference, c.counts_samples)},
                              {"gl", result_json(c.tested, c.counts_samples)}});
  }
  return json;
}

}  // namespace caustics::app
