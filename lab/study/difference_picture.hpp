// Where a setting's caustic is brighter or darker than the truth, as a small picture.
#pragma once
#include "pipeline/gpu/image.hpp"

namespace caustics::study {

// The largest side of a picture, pixels.
inline constexpr int kPictureSide = 320;

// tested - truth: black where they are alike, orange where there is more light than in the truth, blue
// where there is less; of each pixel the channel that differs most. Full colour stands for `white`
// (lux) and more, two thirds of it for a tenth of that, one third for a hundredth, black for a
// thousandth and less. Larger images are averaged in boxes. Both have one
// size; rows from the bottom; display values.
Image difference_picture(const Image& tested, const Image& truth, double white);

// An image averaged in boxes until no side is above kPictureSide; as it is where none is.
Image small_picture(const Image& image);

}  // namespace caustics::study
