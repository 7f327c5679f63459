#include "app/study/measure.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"

namespace caustics::app {

namespace {

// "caustic_map[sun]" -> "caustic_map"
// "landing.far" of "landing[sun].far".
std::string pass_name(const std::string& label) {
  const std::size_t owner = label.find('['), end = label.rfind(']');
  return owner == label.npos ? label : label.substr(0, owner) + label.substr(end + 1);
}

// The labels of what these textures depend on.
std::set<std::string> labels_for(const RenderedFrame& frame, const PlanGoal& goal) {
  std::set<std::string> labels;
  for (const PlannedPass& pass :
       make_plan(frame.scene(), frame.effects(), frame.settings(), pass_registry(), goal).passes)
    labels.insert(pass.label);
  return labels;
}

// What of a frame counts as what. The layer's own pass, which is there for the error alone, is in neither;
// nor are the steps of water, whose number depends on the moment shown before.
struct Division {
  explicit Division(const RenderedFrame& frame)
      : picture(labels_for(frame, {{"picture"}})),
        caustic(labels_for(frame, {{kCausticMap, kCascadeMap, far_texture(kCausticMap)}})) {}
  std::set<std::string> picture, caustic;
};

// The frames' times, pass by pass.
class Clock {
 public:
  explicit Clock(Division division) : division_(std::move(division)) {}

  void add(const std::vector<PassReport>& reports) {
    double all = 0.0, caustic = 0.0;
    for (const PassReport& report : reports) {
      if (!division_.picture.count(report.label)) continue;
      const double milliseconds = report.result.milliseconds;
      const bool makes = division_.caustic.count(report.label) > 0;
      all += milliseconds;
      if (makes) caustic += milliseconds;
      book(pass_name(report.label), makes, milliseconds);
    }
    frame_.push_back(all);
    caustic_.push_back(caustic);
  }

  void finish(Rendered& result) {
    result.frame = times_of(frame_);
    result.caustics = times_of(caustic_);
    for (Entry& entry : entries_) {
      entry.pass.runs /= static_cast<int>(frame_.size());
      entry.pass.median = times_of(entry.frames).median;
      result.passes.push_back(entry.pass);
    }
  }

 private:
  struct Entry {
    PassTime pass;
    std::vector<double> frames;
  };

  void book(const std::string& name, bool caustic, double milliseconds) {
    auto found = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& entry) { return entry.pass.name == name; });
    if (found == entries_.end())
      found = entries_.insert(entries_.end(), {{.name = name, .caustic = caustic}, {}});
    ++found->pass.runs;
    found->frames.resize(frame_.size() + 1);
    found->frames.back() += milliseconds;
  }

  Division division_;
  std::vector<double> frame_, caustic_;  // by frames
  std::vector<Entry> entries_;
};

void refuse_non_finite(const Image& caustic) {
  if (const std::size_t count = count_non_finite(caustic); count > 0) {
    throw Error(ExitCode::NumericFault,
                "the layer caustic has " + grouped(count) + " values that are not finite");
  }
}

std::uint64_t bytes_of(const RenderedFrame& frame) {
  return make_plan(frame.scene(), frame.effects(), frame.settings(), pass_registry(), {{"picture"}}).bytes();
}

}  // namespace

Rendered render_setting(FrameRequest request, int repeat,
                        const std::function<void(const std::string&)>& say) {
  request.backend.measure = repeat > 0;
  request.backend.compiling = [&](std::string_view shader) {
    say("compiling shader " + std::string(shader));
  };
  say("finding where the light goes");
  RenderedFrame frame(request, load_scene(request), {{"picture", "aov_caustic"}});
  Rendered result;
  result.device = frame.device().description();
  result.texture_bytes = bytes_of(frame);
  say(repeat > 0 ? "warming up" : "rendering");
  frame.run();
  result.caustic = frame.read("aov_caustic");
  refuse_non_finite(result.caustic);
  if (repeat == 0) return result;
  Clock clock{Division(frame)};
  for (int n = 0; n < repeat; ++n) {
    say("frame " + std::to_string(n + 1) + " of " + std::to_string(repeat));
    clock.add(frame.run());
  }
  clock.finish(result);
  return result;
}

}  // namespace caustics::app
