#include "pipeline/renderer/parity_judgement.hpp"

#include <algorithm>
#include <set>

namespace caustics {

namespace {

bool beyond_its_bound(const JudgedAttachment& a) { return a.verdict.verdict == Verdict::Beyond; }

const PlannedTexture& texture_of(const FramePlan& plan, int index) {
  return plan.textures[static_cast<std::size_t>(index)];
}

bool writes_eight_bits(const FramePlan& plan, const PlannedPass& pass) {
  return std::any_of(pass.writes.begin(), pass.writes.end(), [&](int index) {
    return index >= 0 && texture_of(plan, index).format == Format::RGBA8;
  });
}

class Judge {
 public:
  Judge(const FrameParity& parity, const FramePlan& plan, const Registry& registry, DriverClass driver)
      : parity_(parity), plan_(plan), registry_(registry) {
    judged_.driver = driver;
  }

  JudgedFrame judged() {
    std::set<int> drawn;
    for (const PlannedPass& pass : plan_.passes) {
      add_counts(pass);
      for (std::size_t i = 0; i < pass.writes.size(); ++i)
        add_isolated(pass, pass.writes[i], static_cast<int>(i));
      add_isolated(pass, pass.depth, -1);
      for (const int index : pass.attachments()) drawn.insert(index);
    }
    for (const int index : drawn) add_whole_frame(index);
    return std::move(judged_);
  }

 private:
  void add_counts(const PlannedPass& pass) {
    const auto found = std::find_if(parity_.counts.begin(), parity_.counts.end(),
                                    [&](const PassCounts& c) { return c.pass == pass.label; });
    if (found == parity_.counts.end()) return judged_.missing.push_back(pass.label + " counts");
    const PassResult &reference = found->reference, &tested = found->tested;
    const bool agree = reference.vertices == tested.vertices && reference.primitives == tested.primitives &&
                       (!found->counts_samples ||
                        samples_agree(reference.samples_passed, tested.samples_passed, judged_.driver));
    judged_.counts.push_back({*found, agree});
  }

  void add_isolated(const PlannedPass& pass, int index, int write) {
    if (index < 0) return;
    const std::string& name = texture_of(plan_, index).name;
    const auto found =
        std::find_if(parity_.isolated.begin(), parity_.isolated.end(),
                     [&](const AttachmentParity& a) { return a.pass == pass.label && a.attachment == name; });
    if (found == parity_.isolated.end()) return judged_.missing.push_back(pass.label + " " + name);
    const ImageKind kind = kind_of(pass, registry_, write);
    judged_.isolated.push_back({*found, kind, judge(found->difference, kind, judged_.driver)});
  }

  void add_whole_frame(int index) {
    const std::string& name = texture_of(plan_, index).name;
    const auto found = std::find_if(parity_.whole_frame.begin(), parity_.whole_frame.end(),
                                    [&](const AttachmentParity& a) { return a.attachment == name; });
    if (found == parity_.whole_frame.end()) return judged_.missing.push_back("whole frame " + name);
    const ImageKind kind = kind_in_frame(plan_, index);
    judged_.whole_frame.push_back({*found, kind, judge(found->difference, kind, judged_.driver)});
  }

  const FrameParity& parity_;
  const FramePlan& plan_;
  const Registry& registry_;
  JudgedFrame judged_;
};

}  // namespace

bool JudgedFrame::passes() const {
  return missing.empty() && std::none_of(isolated.begin(), isolated.end(), beyond_its_bound) &&
         std::none_of(whole_frame.begin(), whole_frame.end(), beyond_its_bound) &&
         std::all_of(counts.begin(), counts.end(), [](const JudgedCounts& c) { return c.agree; });
}

std::size_t JudgedFrame::differing_values() const {
  std::size_t sum = 0;
  for (const auto* list : {&isolated, &whole_frame})
    for (const JudgedAttachment& a : *list) sum += a.parity.difference.all.differing;
  return sum;
}

ImageKind kind_of(const PlannedPass& planned, const Registry& registry, int write) {
  const PassDefinition& definition = *planned.definition;
  const ColorWrite* color = write < 0 ? nullptr : &definition.writes[static_cast<std::size_t>(write)];
  if (color && color->format == Format::RGBA8) return ImageKind::Picture;
  if (registry[static_cast<std::size_t>(planned.pass)].draws == DrawSet::FullScreen)
    return ImageKind::Shading;
  return color && color->blend == kAccumulate ? ImageKind::FluxMap : ImageKind::RasterizedMap;
}

ImageKind kind_in_frame(const FramePlan& plan, int texture) {
  if (texture_of(plan, texture).format == Format::RGBA8) return ImageKind::Picture;
  const bool makes_picture =
      std::any_of(plan.passes.begin(), plan.passes.end(), [&](const PlannedPass& pass) {
        return writes_eight_bits(plan, pass) &&
               std::find(pass.reads.begin(), pass.reads.end(), texture) != pass.reads.end();
      });
  return makes_picture ? ImageKind::Beauty : ImageKind::Intermediate;
}

JudgedFrame judge(const FrameParity& parity, const FramePlan& plan, const Registry& registry,
                  DriverClass driver) {
  return Judge(parity, plan, registry, driver).judged();
}

}  // namespace caustics
