// How far an OpenGL driver may be from the software device: data, for each class of drivers and kind of
// image, every bound with its cause. What the start-up probe finds (gl_backend/gl_probe.hpp) decides the
// class, so that drivers that nobody has seen are judged too.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/gpu/difference.hpp"

namespace caustics {

enum class DriverClass : std::uint8_t {
  LlvmpipeFused,        // llvmpipe as the software device is: equal to the bit
  LlvmpipeOtherPoints,  // the same, but for points on the edges of texels or of the target
  LlvmpipeUnfused,      // llvmpipe without fused multiply-add
  Hardware,             // whatever else keeps `precise`
  ContractingHardware,  // contracts a * b + c all the same
  FourSubpixelBits,     // snaps corners to sixteenths of a pixel, or to anything much coarser than 1/256
};
inline constexpr std::size_t kDriverClasses = 6;
std::string_view name_of(DriverClass driver);

// What an image holds, which decides how a difference spreads in it.
enum class ImageKind : std::uint8_t {
  Shading,        // of a full-screen pass: each texel by itself, at the same place on all devices
  RasterizedMap,  // of triangles: coverage and interpolated values
  Samples,        // no image: how many samples passed the depth test
  FluxMap,        // sums of what points or triangles add
  Intermediate,   // between the passes of a frame that a device draws by itself
  Beauty,         // the radiance that the picture is made from
  Picture,        // 8 bits
  RandomDraws,    // of the tests: overlapping shapes at random, where each edge decides between two colours
};
inline constexpr std::size_t kImageKinds = 8;
std::string_view name_of(ImageKind kind);

enum class Measure : std::uint8_t {
  Coverage,     // texels that one image alone covers, of those covered; one is always allowed
  Jumps,        // share of texels that hold something else (ImageDifference::jumps); one is always allowed
  RelativeL1,   // sum |a - b| / sum |a|; of shading and rasterized maps where both cover and nothing jumps
  TotalFlux,    // difference of the sums, relative
  P999,         // 99.9th percentile of the relative difference of a value
  BeyondAStep,  // share of values more than 1/255 apart
};
std::string_view name_of(Measure measure);

struct ParityBound {
  ImageKind kind;
  Measure measure;
  std::array<double, kDriverClasses> most;  // by DriverClass; 0: no value may differ
  std::string_view cause;
};
std::span<const ParityBound> parity_bounds();

// What the measure says of a difference.
double measured(Measure measure, ImageKind kind, const ImageDifference& difference);

enum class Verdict : std::uint8_t { Equal, Within, Beyond };
std::string_view name_of(Verdict verdict);

struct BoundCheck {
  const ParityBound* bound = nullptr;
  double found = 0.0, most = 0.0;
  bool within = false;
};

struct ParityVerdict {
  Verdict verdict = Verdict::Equal;
  std::vector<BoundCheck> checks{};  // of all bounds that were asked
  std::string reason{};  // the cause of what is within, or what is wrong; empty where all is equal
  // The one that is nearest to its bound, or furthest beyond; null where none was asked.
  const BoundCheck* closest() const;
};

// Whatever the bounds, these are beyond: another size or format, a NaN or an infinity on one side alone, a
// kind without a bound, a bound without a cause.
ParityVerdict judge(const ImageDifference& difference, ImageKind kind, DriverClass driver,
                    std::span<const ParityBound> bounds = parity_bounds());

// Likewise of numbers of samples; one is always allowed where any is.
bool samples_agree(std::uint64_t reference, std::uint64_t tested, DriverClass driver);

}  // namespace caustics
