#include <algorithm>

#include "app/flux.hpp"
#include "app/plan_report.hpp"
#include "app/summary.hpp"
#include "app/table.hpp"
#include "app/terminal.hpp"

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
    return text_;
  }

 private:
  const Scene& of() const { return report_.judged.scene; }
  const Effects& judged() const { return report_.judged.effects; }

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
    table.row({"camera", one_line(report_.judged.camera->name)});
    text_ += table.text();
  }

  // Meshes of one material and one judgement share a line.
  void surfaces() {
    struct Group {
      std::size_t first, count;
    };
    std::vector<Group> groups;
    for (std::size_t i = 0; i < judged().surfaces.size(); ++i) {
      const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
        return judged().surfaces[group.first].reason == judged().surfaces[i].reason;
      });
      same == groups.end() ? groups.push_back({i, 1}) : void(++same->count);
    }
    heading("surfaces");
    Table table;
    for (const Group& group : groups) {
      const std::string more =
          group.count == 1 ? "" : " and " + std::to_string(group.count - 1) + " more";
      table.row({mesh_label(of(), static_cast<int>(group.first)) + more,
                 std::string(caustics::name_of(judged().surfaces[group.first].role)),
                 one_line(judged().surfaces[group.first].reason)});
    }
    text_ += table.text();
  }

  void lights() {
    heading("lights");
    Table table;
    for (std::size_t i = 0; i < of().lights.size(); ++i) {
      const Light& light = of().lights[i];
      table.row({std::to_string(i), light_label(of(), static_cast<int>(i)), name_of(light.type),
                 significant(light.intensity, 6) + " " + intensity_unit(light)});
    }
    text_ += table.text();
  }

  void expectations() {
    heading("caustics to expect");
    Table table;
    for (const Expectation& e : judged().expectations) {
      table.row({yes_no(e.expected),
                 "light " + light_label(of(), e.light) + " through " + mesh_label(of(), e.mesh),
                 e.reason});
    }
    if (judged().expectations.empty()) {
      table.row({yes_no(false), "nothing in the scene bends or mirrors light"});
    }
    text_ += table.text();
  }

  void effects() {
    heading("effects");
    Table table;
    for (const Effect& effect : judged().list) {
      table.row({yes_no(effect.active), effect.name, one_line(effect.reason)});
    }
    text_ += table.text();
  }

  void passes() {
    const FramePlan& plan = report_.plan;
    heading("passes (" + std::to_string(plan.passes.size()) + ", textures of " +
            bytes_text(static_cast<double>(plan.bytes())) + ")");
    Table table;
    for (const PlannedPass& pass : plan.passes) {
      std::vector<int> targets = pass.writes;
      if (pass.depth >= 0) targets.push_back(pass.depth);
      std::string written;
      for (const int target : targets) {
        const PlannedTexture& texture = plan.textures[static_cast<std::size_t>(target)];
        written += (written.empty() ? "" : ", ") + texture.name + " " +
                   std::string(format_name(texture.format));
      }
      table.row({one_line(pass.label),
                 std::to_string(pass.width) + "x" + std::to_string(pass.height),
                 one_line(pass.reason)});
      table.row({"", "", "writes " + one_line(written)});
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
    if (of().notes.empty()) return;
    heading("notes");
    for (const std::string& note : of().notes) text_ += "  " + one_line(note) + "\n";
  }

  const PlanReport& report_;
  bool colour_;
  std::string text_;
};

}  // namespace

std::string plan_text(const PlanReport& report, bool colour) {
  return TextReport(report, colour).text();
}

}  // namespace caustics::app
