#include "pipeline/renderer/parity.hpp"

#include <algorithm>
#include <optional>

#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/interrupt.hpp"

namespace caustics {

namespace {

class Comparison {
 public:
  Comparison(const FramePlan& plan, const Registry& registry, const SceneOnDevice& reference,
             const SceneOnDevice& tested, const FrameInputs& inputs)
      : plan_(plan),
        registry_(registry),
        reference_(reference),
        tested_(tested),
        inputs_(inputs),
        reference_targets_(plan, reference.device()),
        fed_targets_(plan, tested.device()),
        contents_(plan.textures.size()) {}

  // Runs one pass on both devices, the tested one on the reference's inputs.
  void run(const PlannedPass& planned, const ParityWatch& watch, FrameParity& out) {
    const PassRun tested_run = prepare_pass(plan_, planned, registry_, tested_, fed_targets_, inputs_);
    const PassRun reference_run =
        prepare_pass(plan_, planned, registry_, reference_, reference_targets_, inputs_);
    out.counts.push_back({planned.label, planned.definition->count_samples,
                          reference_.device().run(reference_run), tested_.device().run(tested_run)});
    const PassDefinition& definition = *planned.definition;
    for (std::size_t i = 0; i < planned.writes.size(); ++i)
      if (planned.writes[i] != PlannedPass::kNothing)
        compare(planned, planned.writes[i], definition.writes[i].clear, watch, out);
    if (planned.depth >= 0) compare(planned, planned.depth, {definition.depth->clear}, watch, out);
  }

  // Runs the whole plan on the tested device by itself, and compares what is there at the end.
  void run_whole_frame(const AfterPass& after, FrameParity& out) {
    const FrameTargets targets(plan_, tested_.device());
    run_plan(plan_, registry_, tested_, targets, inputs_, after);
    // Backwards: a texture that several passes draw into is reported with the last of them.
    for (auto planned = plan_.passes.rbegin(); planned != plan_.passes.rend(); ++planned)
      for (const int index : planned->attachments()) {
        std::optional<Image>& content = contents_[static_cast<std::size_t>(index)];
        if (!content) continue;
        const Image found = tested_.device().read_back(targets[index]);
        out.whole_frame.push_back({planned->label, plan_.textures[static_cast<std::size_t>(index)].name,
                                   difference(*content, found)});
        content.reset();
      }
    std::reverse(out.whole_frame.begin(), out.whole_frame.end());
  }

 private:
  // `background`: what is there where nothing is drawn.
  void compare(const PlannedPass& planned, int index, const std::array<float, 4>& background,
               const ParityWatch& watch, FrameParity& out) {
    std::optional<Image>& content = contents_[static_cast<std::size_t>(index)];
    content = reference_.device().read_back(reference_targets_[index]);
    const Image found = tested_.device().read_back(fed_targets_[index]);
    out.isolated.push_back({planned.label, plan_.textures[static_cast<std::size_t>(index)].name,
                            difference(*content, found, {}, background)});
    if (watch) watch(out.isolated.back(), *content, found);
    fed_targets_.replace(index, *content);
  }

  const FramePlan& plan_;
  const Registry& registry_;
  const SceneOnDevice& reference_;
  const SceneOnDevice& tested_;
  const FrameInputs& inputs_;
  FrameTargets reference_targets_;
  FrameTargets fed_targets_;                    // on the tested device, holding what the reference drew
  std::vector<std::optional<Image>> contents_;  // of the reference's textures, once drawn
};

}  // namespace

FrameParity compare_devices(const FramePlan& plan, const Registry& registry, const SceneOnDevice& reference,
                            const SceneOnDevice& tested, const FrameInputs& inputs, const ParityWatch& watch,
                            const AfterPass& after) {
  FrameParity out;
  Comparison comparison(plan, registry, reference, tested, inputs);
  const std::size_t total = 2 * plan.passes.size();
  for (const PlannedPass& planned : plan.passes) {
    stop_if_interrupted();
    comparison.run(planned, watch, out);
    if (after && !after(planned, out.counts.back().tested, out.counts.size(), total))
      throw Error(ExitCode::Interrupted, "interrupted after pass '" + planned.label + "'");
  }
  comparison.run_whole_frame(
      [&](const PlannedPass& planned, const PassResult& result, std::size_t done, std::size_t) {
        return !after || after(planned, result, plan.passes.size() + done, total);
      },
      out);
  return out;
}

}  // namespace caustics
