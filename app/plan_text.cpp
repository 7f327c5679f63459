#include <algorithm>
#include <map>
#include <tuple>

#include "app/expectations.hpp"
#include "app/loaded_scene.hpp"
#include "app/output/light_groups.hpp"
#include "app/plan_report.hpp"
#include "app/shell/table.hpp"
#include "app/shell/terminal.hpp"
#include "app/texture_label.hpp"
#include "passes/registry.hpp"

namespace caustics::app {

const char* name_of(LightType type) {
  switch (type) {
    case LightType::Directional:
      return "directional";
    case LightType::Point:
      return "point";
    case LightType::Spot:
      return "spot";
  }
  return "?";
}

bool PlanReport::draws_nothing(const PlannedPass& pass) const {
  // Of layers, and of what is drawn for no single light, only the frame knows.
  if (pass.only_if == 0 || pass.light < 0 || pass.drawn_for->layer > 0) return false;
  const int source = loaded.scene().lights[static_cast<std::size_t>(pass.light)].source;
  return std::any_of(ledgers.begin(), ledgers.end(), [&](const LightLedger& ledger) {
    return ledger.light == source && !(sum(ledger.ledger.entered) > 0.0);
  });
}

std::vector<std::string> PlanReport::notes() const {
  std::vector<std::string> notes = loaded.scene().notes;
  notes.insert(notes.end(), idle.begin(), idle.end());
  return notes;
}

std::size_t PlanReport::passes_that_draw_nothing() const {
  return static_cast<std::size_t>(std::count_if(
      plan.passes.begin(), plan.passes.end(), [&](const PlannedPass& pass) { return draws_nothing(pass); }));
}

namespace {

class TextReport {
 public:
  TextReport(const PlanReport& report, bool colour) : report_(report), colour_(colour) {}

  std::string text() {
    scene();
    surfaces();
    lights();
    expectations();
    effects();
    passes();
    skipped();
    notes();
    costs();
    return text_;
  }

 private:
  const Scene& of() const { return report_.loaded.scene(); }
  const Effects& called_for() const { return report_.effects; }

  void heading(const std::string& title) {
    text_ += (text_.empty() ? "" : "\n") + (colour_ ? "\033[1m" + title + "\033[0m" : title) + "\n";
  }
  std::string yes_no(bool yes) const {
    if (!colour_) return yes ? "yes" : "no ";
    return yes ? "\033[32myes\033[0m" : "\033[33mno \033[0m";
  }

  void scene() {
    std::size_t triangles = 0;
    for (const Mesh& mesh : of().meshes) triangles += mesh.indices.size() / 3;
    const Bounds bounds = bounds_of(of());
    const glm::dvec3 size = bounds.empty() ? glm::dvec3(0.0) : bounds.upper - bounds.lower;
    heading(one_line(of().file));
    Table table;
    table.row({"meshes", grouped(of().meshes.size()) + ", " + grouped(triangles) + " triangles"});
    table.row({"size", significant(size.x, 3) + " x " + significant(size.y, 3) + " x " +
                           significant(size.z, 3) + " m"});
    table.row({"camera", one_line(report_.loaded.camera().name)});
    if (report_.loaded.moves()) table.row({"moves", movement()});
    text_ += table.text();
  }

  // "for 2.5 s, then again; 3 meshes".
  std::string movement() const {
    const std::size_t meshes = report_.loaded.moving_meshes().size();
    return "for " + significant(report_.loaded.duration(), 4) + " s, then again; " +
           (meshes == 0 ? "no meshes" : grouped(meshes) + (meshes == 1 ? " mesh" : " meshes"));
  }

  // Meshes of one material and one judgement share a line.
  void surfaces() {
    struct Group {
      std::size_t first, count;
    };
    std::vector<Group> groups;
    for (std::size_t i = 0; i < called_for().surfaces.size(); ++i) {
      const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
        return called_for().surfaces[group.first].reason == called_for().surfaces[i].reason;
      });
      same == groups.end() ? groups.push_back({i, 1}) : void(++same->count);
    }
    heading("surfaces");
    Table table;
    for (const Group& group : groups) {
      const std::string more = group.count == 1 ? "" : " and " + std::to_string(group.count - 1) + " more";
      table.row({mesh_label(of(), static_cast<int>(group.first)) + more,
                 std::string(caustics::name_of(called_for().surfaces[group.first].role)),
                 one_line(called_for().surfaces[group.first].reason)});
    }
    text_ += table.text();
  }

  void lights() {
    heading("lights");
    Table table;
    for (std::size_t i = 0; i < of().sources.size(); ++i) {
      const Light& light = of().sources[i];
      table.row({std::to_string(i), light_label(of(), static_cast<int>(i)), name_of(light.type),
                 significant(light.intensity, 6) + " " + intensity_unit(light),
                 size_text(of(), static_cast<int>(i))});
    }
    text_ += table.text();
  }

  void expectations() {
    heading("caustics to expect");
    Table table;
    for (const Expectation& e : known_expectations(of(), called_for(), report_.ledgers)) {
      table.row({yes_no(e.expected),
                 "light " + light_label(of(), e.light) + " through " + mesh_label(of(), e.mesh), e.reason});
    }
    for (const FurtherShare& found : called_for().further_shares)
      table.row({"",
                 "light " + light_label(of(), source_of_light(found.light)) + " through " +
                     mesh_label(of(), found.mesh),
                 percent(found.share) + " of what lands of it goes other ways than through two surfaces, " +
                     percent(found.seen) + " of what is seen of that light"});
    if (called_for().expectations.empty()) {
      table.row({yes_no(false), "nothing in the scene bends or mirrors light"});
    }
    text_ += table.text();
    for (const LightLedger& ledger : report_.ledgers) {
      if (ledger.error.judged && ledger.error.landed > 0.0)
        text_ += "  light " + light_label(of(), ledger.light) + ": whatever the sizes, the picture errs by " +
                 percent(ledger.error.relative(ledger.error.model)) + "; " +
                 percent(ledger.error.relative(ledger.error.not_followed)) +
                 " of its light lands by ways that are not followed\n";
      const std::string warning = leaving_sentence(of(), ledger);
      if (!warning.empty()) text_ += "  warning: " + warning + "\n";
    }
  }

  void effects() {
    heading("effects");
    Table table;
    for (const NamedEffect& named : named_effects()) {
      const Effect& effect = called_for().*named.effect;
      table.row({yes_no(effect.active), std::string(named.name), one_line(effect.reason)});
    }
    text_ += table.text();
  }

  // Passes that do the same for the samples of one light, or of each pixel, are a group; groups come in the
  // order of their first passes.
  std::vector<std::vector<const PlannedPass*>> groups() const {
    std::vector<std::vector<const PlannedPass*>> groups;
    std::map<std::tuple<int, const DrawnFor*, bool, int>, std::size_t> group_of;
    for (const PlannedPass& pass : report_.plan.passes) {
      const bool sampled = pass.sample > 0, alone = pass.light < 0 && !sampled;
      const int light = pass.light < 0 ? -1 : source(pass);
      const auto [found, is_new] =
          group_of.try_emplace({pass.pass, pass.drawn_for, sampled, light}, groups.size());
      if (is_new || alone) {
        groups.push_back({&pass});
      } else {
        groups[found->second].push_back(&pass);
      }
    }
    return groups;
  }

  int source_of_light(int light) const { return of().lights[static_cast<std::size_t>(light)].source; }

  int source(const PlannedPass& pass) const {
    return of().lights[static_cast<std::size_t>(pass.light)].source;
  }

  // "landing[sun] RGBA32F", or "landing[sun.00..sun.15] RGBA32F" of passes that write a texture each.
  std::string texture_text(int first, int last) const {
    const std::vector<PlannedTexture>& textures = report_.plan.textures;
    const PlannedTexture& texture = textures[static_cast<std::size_t>(first)];
    const PlannedTexture& other = textures[static_cast<std::size_t>(last)];
    const auto of_branch = [](const std::string& name) { return name.find(' ') != name.npos; };
    std::string label = texture_label(texture, of());
    if (first != last) {
      const std::string last_label = texture_label(other, of());
      if (of_branch(texture.name) || of_branch(other.name))
        label += " .. " + last_label;
      else
        label.replace(label.rfind(']'), label.npos, ".." + last_label.substr(last_label.find('[') + 1));
    }
    return label + " " + std::string(format_name(texture.format));
  }

  // Names the first and the last texture of each attachment that somebody needs.
  std::string written(const std::vector<const PlannedPass*>& group) const {
    std::string text;
    const std::size_t colors = group.front()->writes.size();
    for (std::size_t i = 0; i <= colors; ++i) {
      const auto texture = [&](const PlannedPass* pass) {
        return i < colors ? pass->writes[i] : pass->depth;
      };
      const auto needed = [&](const PlannedPass* pass) { return texture(pass) >= 0; };
      const auto first = std::find_if(group.begin(), group.end(), needed);
      if (first == group.end()) continue;
      const auto last = std::find_if(group.rbegin(), group.rend(), needed);
      text += (text.empty() ? "" : ", ") + texture_text(texture(*first), texture(*last));
    }
    return text;
  }

  std::string pass_label(const PlannedPass& pass, std::size_t count) const {
    if (count == 1) return pass.label;
    std::string text(pass_registry()[static_cast<std::size_t>(pass.pass)].name);
    if (pass.light >= 0) {
      const std::string& name = of().sources[static_cast<std::size_t>(source(pass))].name;
      text += "[" + (name.empty() ? std::to_string(source(pass)) : name) + "]";
    }
    const std::string_view label = pass.drawn_for->label;
    return text.append(label.empty() ? "" : ".").append(label) + " x " + std::to_string(count);
  }

  void passes() {
    const FramePlan& plan = report_.plan;
    const std::size_t idle = report_.passes_that_draw_nothing();
    heading("passes (" + std::to_string(plan.before.size() + plan.passes.size()) +
            (idle == 0 ? std::string() : ", " + std::to_string(idle) + " of them draw nothing") +
            ", textures of " + bytes_text(static_cast<double>(plan.bytes())) + ")");
    Table table;
    for (const PlannedSteps& steps : plan.before) {
      table.row({one_line(steps.label),
                 std::to_string(steps.writes.width) + "x" + std::to_string(steps.writes.height),
                 one_line(steps.reason) + ", before the frame"});
      table.row({"", "",
                 "writes " + one_line(texture_label(steps.writes, of())) + " " +
                     std::string(format_name(steps.writes.format))});
    }
    for (const std::vector<const PlannedPass*>& group : groups()) {
      const PlannedPass& pass = *group.front();
      table.row({one_line(pass_label(pass, group.size())),
                 std::to_string(pass.width) + "x" + std::to_string(pass.height),
                 report_.draws_nothing(pass) ? "draws nothing: its light reaches no caster (occlusion query)"
                                             : one_line(pass.reason)});
      table.row({"", "", "writes " + one_line(written(group))});
    }
    text_ += table.text();
  }

  void skipped() {
    if (report_.plan.skipped.empty()) return;
    heading("not run");
    Table table;
    for (const SkippedPass& pass : report_.plan.skipped) {
      table.row({one_line(pass.name), one_line(pass.reason)});
    }
    text_ += table.text();
  }

  void notes() {
    const std::vector<std::string> notes = report_.notes();
    if (notes.empty()) return;
    heading("notes");
    for (const std::string& note : notes) text_ += "  " + one_line(note) + "\n";
  }

  void costs() {
    heading("time and memory");
    const MemoryJudgement& judged = report_.memory;
    text_ += "  a PNG picture takes about " + significant(report_.seconds, 2) + " s of processors, and " +
             bytes_text(static_cast<double>(judged.needed)) + " of the " +
             bytes_text(static_cast<double>(judged.budget.bytes)) + " " + one_line(judged.budget.whose) +
             "\n";
    if (!judged.refusal.empty()) text_ += "  render would refuse it: " + one_line(judged.refusal) + "\n";
  }

  const PlanReport& report_;
  bool colour_;
  std::string text_;
};

}  // namespace

std::string plan_text(const PlanReport& report, bool colour) { return TextReport(report, colour).text(); }

}  // namespace caustics::app
