#include "pipeline/measure/picture_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/measure/surface_steps.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

constexpr int kLeastBlock = 4, kMostBlocks = 64;

int blocks(int pixels, int side) { return (pixels + side - 1) / side; }

}  // namespace

PictureBlocks::PictureBlocks(ImageView view_position, const View& camera)
    : position_(std::move(view_position)),
      camera_(camera),
      side_(std::max(kLeastBlock, blocks(std::max(position_.width(), position_.height()), kMostBlocks))),
      across_(static_cast<std::size_t>(blocks(position_.width(), side_))),
      upward_(static_cast<std::size_t>(blocks(position_.height(), side_))) {}

std::optional<PictureBlocks::Place> PictureBlocks::find(const glm::dvec3& p) const {
  const glm::dvec3 q = camera_.coordinates(p);
  if (camera_.perspective && !(q.z > 0.0)) return {};
  const glm::dvec2 at = (camera_.window(q) - camera_.window_lower) /
                        (camera_.window_upper - camera_.window_lower) *
                        glm::dvec2(position_.width(), position_.height());
  if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < position_.width() && at.y < position_.height())) return {};
  const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
  const auto here = surface_at(position_, x, y);
  if (!here) return {};
  const auto across = surface_step(position_, *here, x, y, 1, 0),
             upward = surface_step(position_, *here, x, y, 0, 1);
  if (!across || !upward) return {};
  // A point of the surface in this pixel is at most half a step off along both; twice that allows for bends.
  if (exact::length(p - *here) > exact::length(*across) + exact::length(*upward)) return {};
  const double area = exact::length(exact::cross(*across, *upward));
  if (!(area > 0.0)) return {};
  return Place{static_cast<std::size_t>(y / side_) * across_ + static_cast<std::size_t>(x / side_),
               1.0 / area};
}

}  // namespace caustics
