// The pictures on casters and receivers, which light and rays of sight meet in any order: all in one texture,
// side by side (passes/shared/dressed_meeting.glsl reads it).
#pragma once
#include <map>
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// Texels in all: 128 MiB on a GPU.
inline constexpr std::int64_t kMostCasterTexels = std::int64_t{4096} * 4096;

struct CasterTexels {
  struct Place {
    int x = 0, y = 0, width = 0, height = 0;  // texels
  };
  Image image;                  // RGBA16F
  std::map<int, Place> places;  // by index into Scene::images
};

// Texels along a side of what is coarse.
inline constexpr int kMostCoarseTexels = 512;

// `images`: indices into Scene::images, each once; `coarse`: likewise, of those that are halved until they
// have kMostCoarseTexels a side, unless they are among the others. Where they need more than `most` texels,
// the largest is halved along both sides, by means of four, until they do not.
CasterTexels caster_texels(const Scene& scene, const std::vector<int>& images,
                           const std::vector<int>& coarse = {}, std::int64_t most = kMostCasterTexels);

}  // namespace caustics
