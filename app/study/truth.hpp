// What a study's settings are measured against.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/selection.hpp"
#include "app/study/row.hpp"
#include "pipeline/gpu/image.hpp"

namespace caustics::app {

struct Truth {
  Image caustic;                  // lux; rows from the bottom
  std::optional<double> noise{};  // sum of the standard errors over sum of the caustic, where known
  double white = 0.0;             // lux: the 99th percentile of the lit selected pixels' largest channel
  Selection selection{};          // --mask
};

// A file's layer `caustic` and, where it has one, `caustic_error`, the standard error of each pixel.
// Throws Error (BadInput): no such layer, another size than the picture, not finite, or black
// within the mask.
Truth read_truth(const std::filesystem::path& file, int width, int height, const std::filesystem::path& mask);
// The same of an image that the program drew itself; `name` is what messages call it.
Truth make_truth(Image caustic, const std::filesystem::path& mask, const std::string& name);

// Throws what the others throw where a mask cannot be read or has another size.
void check_mask(int width, int height, const std::filesystem::path& mask);

Figures measure_against(const Truth& truth, const Image& caustic);

}  // namespace caustics::app
