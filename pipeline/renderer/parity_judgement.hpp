// A comparison of two devices (parity.hpp), judged by the bounds of the driver's class: attachment by
// attachment, as the plan says what there must be.
#pragma once
#include <string>
#include <vector>

#include "pipeline/gpu/parity_bounds.hpp"
#include "pipeline/renderer/parity.hpp"

namespace caustics {

struct JudgedAttachment {
  AttachmentParity parity;
  ImageKind kind = ImageKind::Shading;
  ParityVerdict verdict;
};

// Vertices and primitives submitted must be the same, samples passed as the class has it. Fragments may
// differ: how often a shader runs is the implementation's own affair (OpenGL 4.6, 4.2.4).
struct JudgedCounts {
  PassCounts counts;
  bool agree = false;
};

struct JudgedFrame {
  DriverClass driver = DriverClass::LlvmpipeFused;
  std::vector<JudgedAttachment> isolated, whole_frame;
  std::vector<JudgedCounts> counts;
  // What the plan has and the comparison has not: "landing[sun] landing_flux[0]", "landing[sun] counts".
  std::vector<std::string> missing;

  bool passes() const;  // nothing beyond its bound, no counts apart, nothing missing
  std::size_t differing_values() const;
};

// What an attachment of a pass holds when the pass is fed with the reference's inputs: `write` is its place
// among the definition's, -1 the depth attachment.
ImageKind kind_of(const PlannedPass& planned, const Registry& registry, int write);
// What a texture holds at the end of a frame that the device has drawn by itself.
ImageKind kind_in_frame(const FramePlan& plan, int texture);

JudgedFrame judge(const FrameParity& parity, const FramePlan& plan, const Registry& registry,
                  DriverClass driver);

}  // namespace caustics
