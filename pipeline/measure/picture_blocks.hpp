// Which block of a picture's pixels shows a place of the scene.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "pipeline/gpu/image_view.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics {

// Square blocks of pixels: 4 a side, or more where the picture would have more than 64 of them along its
// longer side.
class PictureBlocks {
 public:
  // `view_position`: of what the camera sees without casters, scene space, w != 0 where there is a surface.
  PictureBlocks(ImageView view_position, const View& camera);

  struct Place {
    std::size_t block = 0;
    double pixels_per_area = 0.0;  // of the surface, per square metre
  };
  // None where the picture does not show the surface there.
  std::optional<Place> find(const glm::dvec3& p) const;

  std::size_t across() const { return across_; }
  std::size_t upward() const { return upward_; }
  std::size_t count() const { return across_ * upward_; }  // row by row
  int side() const { return side_; }                       // of a block, pixels
  const View& camera() const { return camera_; }

 private:
  ImageView position_;
  View camera_;
  int side_;
  std::size_t across_, upward_;
};

}  // namespace caustics
