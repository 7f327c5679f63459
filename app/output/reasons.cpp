#include "app/output/reasons.hpp"

#include <algorithm>
#include <cstdio>

#include "app/shell/table.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

void print(const char* heading, const Table& table) {
  std::fprintf(stderr, "%s\n%s", heading, table.text().c_str());
}

std::string reason_of(const FramePlan& plan, const PassReport& report) {
  const auto pass = std::find_if(plan.passes.begin(), plan.passes.end(),
                                 [&](const PlannedPass& each) { return each.label == report.label; });
  if (pass == plan.passes.end()) return "before the frame";
  return report.result.left_out ? "draws nothing: " + std::string(why_left_out(*pass))
                                : one_line(pass->reason);
}

}  // namespace

void print_reasons(const RenderedFrame& frame, const std::vector<PassReport>& reports) {
  Table effects, passes({false, true, false}), skipped;
  for (const NamedEffect& named : named_effects()) {
    const Effect& effect = frame.effects().*named.effect;
    effects.row({effect.active ? "yes" : "no", std::string(named.name), one_line(effect.reason)});
  }
  for (const PassReport& report : reports)
    passes.row(
        {one_line(report.label), duration_text(report.result.milliseconds), reason_of(frame.plan(), report)});
  for (const SkippedPass& pass : frame.plan().skipped)
    skipped.row({one_line(pass.name), one_line(pass.reason)});
  print("effects", effects);
  print("passes", passes);
  if (!frame.plan().skipped.empty()) print("not run", skipped);
}

}  // namespace caustics::app
