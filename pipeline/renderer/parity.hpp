// Do two devices draw the same? Runs a frame plan on a reference and on a device under test, and
// compares every attachment of every pass.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "pipeline/gpu/difference.hpp"
#include "pipeline/renderer/run_plan.hpp"

namespace caustics {

// One attachment of one pass.
struct AttachmentParity {
  std::string pass;        // the pass's label
  std::string attachment;  // the texture's full name
  ImageDifference difference;
};

// What both devices counted in one pass.
struct PassCounts {
  std::string pass;
  bool counts_samples = false;
  PassResult reference, tested;
};

struct FrameParity {
  // Each pass fed with the reference's inputs, so that a difference is the pass's own.
  std::vector<AttachmentParity> isolated;
  // The device under test left to itself: every texture at the end of the frame.
  std::vector<AttachmentParity> whole_frame;
  std::vector<PassCounts> counts;
};

// Sees both devices' texels of each attachment of the isolated passes, before they are dropped.
using ParityWatch =
    std::function<void(const AttachmentParity& parity, const Image& reference, const Image& tested)>;

// The same scene on two devices. Both get the same frames and settings from `inputs`.
FrameParity compare_devices(const FramePlan& plan, const Registry& registry, const SceneOnDevice& reference,
                            const SceneOnDevice& tested, const FrameInputs& inputs,
                            const ParityWatch& watch = {}, const AfterPass& after = {});

}  // namespace caustics
