// Coarser copies of the materials' pictures for the camera, which reads of them what a pixel covers instead
// of single texels (passes/shared/mip_levels.glsl).
//
// Level k has max(1, floor(side / 2^k)) texels a side, each the mean over its part of level k - 1: weighted
// by overlap where a side is odd, so that every level keeps the picture's mean but for rounding. Linear
// light.
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

// Down to one texel, level 0 included.
int mip_level_count(int width, int height);

// Of an image of four channels, all levels but 0 in one: level 1 at its lower left corner, beside it level 2,
// above that level 3 ...
Image coarser_levels(const Image& image);

// Of any of its textures?
bool has_mip_map(const Material& material);

// Makes Scene::coarser, and states the levels of the materials' textures, of those that the camera may see on
// a surface that is no clear glass.
void add_mip_levels(Scene& scene);

}  // namespace caustics
