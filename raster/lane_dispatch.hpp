// Which instruction sets this build and this processor have.
#pragma once
#include "pipeline/gpu/shader.hpp"
#include "raster/tile_job.hpp"

namespace caustics::raster {

bool is_supported(Lanes lanes);
// The lanes named by the environment variable CAUSTICS_LANES, else the widest supported ones. Throws
// Error (WrongUsage) for a name that is unknown or not supported.
Lanes default_lanes();
// The tile renderer compiled for these lanes.
TileKernel tile_kernel(Lanes lanes);

}  // namespace caustics::raster
