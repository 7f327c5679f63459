#include "raster/lane_dispatch.hpp"

#include <cstdlib>
#include <string>

#include "pipeline/gpu/error.hpp"
#include "raster/software_device.hpp"

namespace caustics {

namespace raster {

void render_tile_plain4(const TileJob&, TileCounters&);
void render_tile_sse41(const TileJob&, TileCounters&);
void render_tile_avx2(const TileJob&, TileCounters&);
void render_tile_avx512(const TileJob&, TileCounters&);

namespace {

struct CompiledLanes {
  Lanes lanes;
  TileKernel tile_kernel;
  bool (*usable)();  // by this processor
};

bool everywhere() { return true; }

// What this build was made for (cmake/lanes.cmake), narrow to wide.
constexpr CompiledLanes kCompiled[] = {
    {Lanes::Scalar, render_tile_plain4, everywhere},
#if defined(CAUSTICS_COMPILES_plain4)
    {Lanes::Plain4, render_tile_plain4, everywhere},
#endif
#if defined(CAUSTICS_COMPILES_sse41)
    {Lanes::Sse41x4, render_tile_sse41, [] { return __builtin_cpu_supports("sse4.1") != 0; }},
#endif
#if defined(CAUSTICS_COMPILES_avx2)
    {Lanes::Avx2x8, render_tile_avx2,
     [] { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }},
#endif
#if defined(CAUSTICS_COMPILES_avx512)
    {Lanes::Avx512x16, render_tile_avx512,
     [] {
       return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
              __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
              __builtin_cpu_supports("fma");
     }},
#endif
};

const CompiledLanes* find(Lanes lanes) {
  for (const CompiledLanes& compiled : kCompiled)
    if (compiled.lanes == lanes) return &compiled;
  return nullptr;
}

}  // namespace

bool is_supported(Lanes lanes) {
  const CompiledLanes* compiled = find(lanes);
  return compiled && compiled->usable();
}

Lanes default_lanes() {
  const char* wanted = std::getenv("CAUSTICS_LANES");
  if (!wanted || !*wanted) return supported_lanes().back();
  for (const Lanes lanes : supported_lanes())
    if (lanes_name(lanes) == wanted) return lanes;
  std::string names;
  for (const Lanes lanes : supported_lanes()) {
    names += ' ';
    names += lanes_name(lanes);
  }
  throw Error(ExitCode::WrongUsage,
              "CAUSTICS_LANES is '" + std::string(wanted) + "'; this build and processor have:" + names);
}

TileKernel tile_kernel(Lanes lanes) {
  const CompiledLanes* compiled = find(lanes);
  return compiled ? compiled->tile_kernel : nullptr;
}

}  // namespace raster

std::vector<Lanes> supported_lanes() {
  std::vector<Lanes> result;
  for (int i = 0; i < kLanesCount; ++i)
    if (raster::is_supported(static_cast<Lanes>(i))) result.push_back(static_cast<Lanes>(i));
  return result;
}

}  // namespace caustics
