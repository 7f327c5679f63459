// What a study's settings are measured against.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/study/row.hpp"
#include "pipeline/gpu/image.hpp"

namespace caustics::study {

// Which pixels count, in the order of an image's rows; 0: left out; empty: nothing is.
using Mask = std::vector<std::uint8_t>;

struct Truth {
  Image caustic;                  // lux; rows from the bottom
  std::optional<double> noise{};  // sum of the standard errors over sum of the caustic, where known
  double white = 0.0;             // lux: white_of the caustic
  Mask mask{};
};

// The 99th percentile of the lit selected pixels' largest channel; 0 where none is lit.
double white_of(const Image& image, const Mask& mask = {});

// `name` is what messages call it. Throws Error (BadInput): not finite, or black within the mask.
Truth make_truth(Image caustic, Mask mask, const std::string& name);
// Of the caustic's size: the standard error of each pixel. Throws Error (BadInput): not finite.
void set_noise(Truth& truth, const Image& error, const std::string& name);

// All but FLIP, which compares pictures for a screen.
Figures measure_against(const Truth& truth, const Image& caustic);

}  // namespace caustics::study
