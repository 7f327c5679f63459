// The camera that shows given points as large as its picture allows.
#pragma once
#include <optional>
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// Of the picture's half width and height, on each side.
inline constexpr double kFramingMargin = 0.12;

// Looks along `forward` (unit) with the vertical field of view `vertical_fov` (radians, in (0, pi)) and
// stands where all points (scene space) lie within the picture of this aspect (width over height), as near as
// can be, with kFramingMargin to spare and the points in its middle; but no nearer than where `least`
// (metres, > 0) fills it. No points: as if the origin were one.
Camera framing_camera(const std::vector<glm::dvec3>& points, const glm::dvec3& forward, double vertical_fov,
                      double aspect, double least);

// The camera with another vertical field of view (degrees, in (0, 180); an orthographic one has none) and its
// picture's middle `zoom` times as large.
Camera with_lens(Camera camera, std::optional<float> fov, float zoom);

}  // namespace caustics
