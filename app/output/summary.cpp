#include "app/output/summary.hpp"

#include <algorithm>

#include "app/expectations.hpp"
#include "app/loaded_scene.hpp"
#include "app/output/first_lines.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/effects/idle_settings.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/settings/setting.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

namespace {

// More than this many sentences of one kind are counted instead of printed.
constexpr std::size_t kMostSentences = 12;

std::string words(const char* account) {
  std::string text = account;
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

// "light 'sun': 87.3% of the light onto its casters is in the map; fresnel 8.1%, missed 4.6%".
std::string ledger_sentence(const Scene& scene, const LightLedger& entry) {
  const std::string light = "light " + light_label(scene, entry.light) + ": ";
  const double entered = sum(entry.ledger.entered);
  if (!(entered > 0.0)) return light + "no light reaches a caster";
  std::string line =
      light + percent(sum(entry.ledger.in_map) / entered) + " of the light onto its casters is in the map";
  std::string losses;
  for (const auto& [name, flux] : accounts(entry.ledger)) {
    const bool loss = std::string(name) != "entered" && std::string(name) != "in_map";
    if (!loss || !(sum(flux) > 0.001 * entered)) continue;
    losses += (losses.empty() ? "; lost: " : ", ") + words(name) + " " + percent(sum(flux) / entered);
  }
  return line + losses;
}

// Of the light that lands, what goes other ways than the passes follow is worth a sentence from here on.
constexpr double kWorthSaying = 0.05;

// No more than that is worth a figure.
std::string part_text(double share) { return share > 1.0 ? "over 100%" : percent(share); }

// "; error 1.2%: map 0.9%, grid 0.2%, missing 0.1%, model 12.0% +- 0.5%"; empty where there is no estimate.
// `alone`: the sum was said before.
std::string error_text(const ErrorEstimate& error, const std::string& why_not_judged, bool alone) {
  if (!(error.landed > 0.0)) return {};
  const auto part = [&](double value) { return part_text(error.relative(value)); };
  std::string text = "; error" + (alone ? "" : " " + part_text(error.total())) + ": map " + part(error.map) +
                     ", grid " + part(error.grid) + ", missing " + part(error.missing);
  if (!error.judged) return text + ", model not known: " + why_not_judged;
  text += ", model " + part(error.model) + " +- " + part(error.sampling);
  if (error.relative(error.not_followed) > kWorthSaying)
    text += "; " + part(error.not_followed) + " of its light lands by ways that are not followed";
  return text;
}

// Sentences that say the same of several things, "materials[1].x: why", as one of the first and so many more.
std::vector<std::string> gathered(const std::vector<std::string>& sentences) {
  struct Group {
    std::string what, says;
    std::size_t more = 0;
  };
  std::vector<Group> groups;
  for (const std::string& sentence : sentences) {
    const std::size_t end = std::min(sentence.find(": "), sentence.size());
    const std::string says = sentence.substr(end);
    const auto same = std::find_if(groups.begin(), groups.end(),
                                   [&](const Group& group) { return !says.empty() && group.says == says; });
    if (same == groups.end()) {
      groups.push_back({sentence.substr(0, end), says});
    } else {
      ++same->more;
    }
  }
  std::vector<std::string> lines;
  lines.reserve(groups.size());
  for (const Group& group : groups)
    lines.push_back(group.what + (group.more == 0 ? "" : " and " + grouped(group.more) + " more") +
                    group.says);
  return lines;
}

void print_some(const char* kind, const std::vector<std::string>& sentences) {
  for (std::size_t i = 0; i < std::min(sentences.size(), kMostSentences); ++i) {
    std::fprintf(stderr, "%s: %s\n", kind, one_line(sentences[i]).c_str());
  }
  if (sentences.size() > kMostSentences) {
    std::fprintf(stderr, "%s: and %zu more; 'caustics plan' lists all\n", kind,
                 sentences.size() - kMostSentences);
  }
}

}  // namespace

void print_summary(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers,
                   const std::optional<SeenCaustic>& seen, const std::vector<std::string>& given,
                   bool verbose) {
  std::fputs(first_lines(frame, ledgers, seen).c_str(), stderr);
  const std::vector<std::string>& notes = frame.scene().notes;
  const std::size_t said = verbose ? 0 : frame.loaded().added().size();
  print_some("note", gathered({notes.begin() + static_cast<std::ptrdiff_t>(said), notes.end()}));
  print_some("note", idle_settings(given, frame.scene(), frame.settings(), frame.effects()));
  if (frame.effects().dim_lights.active) print_some("note", {frame.effects().dim_lights.reason});
  if (frame.effects().blended_layers.active) print_some("note", {frame.effects().blended_layers.reason});
  std::vector<std::string> missing;
  for (const NoCaustic& each :
       missing_caustics(frame.scene(), known_expectations(frame.scene(), frame.effects(), ledgers)))
    missing.push_back(each.sentence());
  if (!missing.empty() && shows_none(frame, ledgers)) missing.erase(missing.begin());  // is said
  print_some("no caustic", missing);
  for (const LightLedger& ledger : ledgers) {
    std::fprintf(stderr, "%s%s\n", ledger_sentence(frame.scene(), ledger).c_str(),
                 error_text(ledger.error, why_not_judged(frame), ledgers.size() == 1).c_str());
    for (const std::string& warning :
         {leaving_sentence(frame.scene(), ledger), leaning_sentence(frame.scene(), ledger)})
      if (!warning.empty()) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  }
}

void print_work(const RenderedFrame& frame, const Timing& timing,
                const std::vector<std::filesystem::path>& outputs, int drawn) {
  std::string files;
  for (const std::filesystem::path& file : outputs) {
    files += (files.empty() ? "" : ", ") + one_line(file.string());
  }
  std::string frames = drawn > 0 ? ", " + std::to_string(drawn) + " frame" : "";
  if (drawn > 1) frames += "s";
  const Settings& settings = frame.settings();
  const std::string sides = frame.effects().caustics.active ? ", grid " + number_text(settings.grid) +
                                                                  ", map " + number_text(settings.map)
                                                            : "";
  std::fprintf(stderr, "%s: %dx%d%s%s in %s (load %s, prepare %s, passes %s, write %s) on %s\n",
               files.c_str(), settings.width, settings.height, sides.c_str(), frames.c_str(),
               duration_text(timing.total).c_str(), duration_text(timing.load).c_str(),
               duration_text(timing.prepare).c_str(), duration_text(timing.passes).c_str(),
               duration_text(timing.write).c_str(), one_line(frame.device().description()).c_str());
}

}  // namespace caustics::app
