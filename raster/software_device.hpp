// The software Device: a deterministic tile rasterizer that executes pass definitions on the CPU.
//
// It does what the OpenGL 4.5 specification asks of the part of the pipeline that the contract names,
// and resolves what the specification leaves open as Mesa's llvmpipe does: 8 sub-pixel bits rounded to
// even, left and bottom edges inclusive in y-up coordinates, clipping at all six planes without a guard
// band. The result is the same to the bit for every number of threads and every lane width. It knows no
// pass, does not multisample, and has no mipmaps, stencil or lines.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/gpu/device.hpp"

namespace caustics {

// Draws are sorted into tiles together, up to so many primitives: a draw of more takes several batches, so
// that its memory does not grow with it. A quarter and four times as many take the same time, all at once a
// third more (4.2 million cells).
inline constexpr std::size_t kPrimitivesPerBatch = std::size_t{1} << 18;

// Bytes of shaded vertices: draws that take more are not sorted together, and a pass whose draws do gives
// their memory back, instead of leaving it to the next.
inline constexpr std::size_t kMostKeptOfDraws = std::size_t{32} << 20;

struct SoftwareOptions {
  int threads = 0;                          // 0: all that the machine has
  std::optional<Lanes> lanes{};             // none: CAUSTICS_LANES from the environment, else the widest
  std::size_t batch = kPrimitivesPerBatch;  // primitives; the bits are the same for every number
};

// Throws Error (WrongUsage) for lanes that this build or processor lacks, or a negative thread count.
std::unique_ptr<Device> make_software_device(const SoftwareOptions& options = {});

// What the device takes for a draw beside textures, in bytes: a batch's shaded vertices, and its primitives
// set up and sorted into tiles. `vertices`: of a mesh with indices, which are shaded all at once; else 0.
std::size_t draw_bytes(const PassDefinition& definition, std::size_t vertices, std::size_t primitives);

// The lane widths that are compiled in and that this processor can run, narrowest first.
std::vector<Lanes> supported_lanes();

}  // namespace caustics
