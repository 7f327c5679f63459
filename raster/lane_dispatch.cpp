#include "raster/lane_dispatch.hpp"

#include <cstdlib>
#include <string>

#include "pipeline/gpu/error.hpp"
#include "raster/software_device.hpp"

namespace caustics {

namespace raster {

void render_tile_plain4(const TileJob&, TileCounters&);
#if defined(CAUSTICS_X86_LANES)
void render_tile_sse41(const TileJob&, TileCounters&);
void render_tile_avx2(const TileJob&, TileCounters&);
void render_tile_avx512(const TileJob&, TileCounters&);
#endif

bool is_supported(Lanes lanes) {
  switch (lanes) {
    case Lanes::Scalar:
    case Lanes::Plain4:
      return true;
#if defined(CAUSTICS_X86_LANES)
    case Lanes::Sse41x4:
      return __builtin_cpu_supports("sse4.1");
    case Lanes::Avx2x8:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case Lanes::Avx512x16:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
             __builtin_cpu_supports("fma");
#else
    case Lanes::Sse41x4:
    case Lanes::Avx2x8:
    case Lanes::Avx512x16:
      return false;
#endif
  }
  return false;
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
  switch (lanes) {
    case Lanes::Scalar:
    case Lanes::Plain4:
      return render_tile_plain4;
#if defined(CAUSTICS_X86_LANES)
    case Lanes::Sse41x4:
      return render_tile_sse41;
    case Lanes::Avx2x8:
      return render_tile_avx2;
    case Lanes::Avx512x16:
      return render_tile_avx512;
#else
    case Lanes::Sse41x4:
    case Lanes::Avx2x8:
    case Lanes::Avx512x16:
      break;
#endif
  }
  return nullptr;
}

}  // namespace raster

std::vector<Lanes> supported_lanes() {
  std::vector<Lanes> result;
  for (int i = 0; i < kLanesCount; ++i)
    if (raster::is_supported(static_cast<Lanes>(i))) result.push_back(static_cast<Lanes>(i));
  return result;
}

}  // namespace caustics
