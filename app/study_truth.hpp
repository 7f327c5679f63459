// A study's truth from files, and a setting's figures against it.
#pragma once
#include <filesystem>

#include "lab/study/truth.hpp"

namespace caustics::app {

// The pixels of an image of this size that a mask selects; "": all. Throws Error (BadInput) where it cannot
// be read or has another size.
study::Mask read_mask(const std::filesystem::path& mask, int width, int height);

// A file's layer `caustic` and, where it has one, `caustic_error`, the standard error of each pixel.
// Throws Error (BadInput): no such layer, another size than the picture, not finite, or black
// within the mask.
study::Truth read_truth(const std::filesystem::path& file, int width, int height,
                        const std::filesystem::path& mask);

// All figures, FLIP too.
study::Figures figures_against(const study::Truth& truth, const Image& caustic);

}  // namespace caustics::app
