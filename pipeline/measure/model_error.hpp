// How far a light's caustic is from what light itself would draw, by the model: rays of a frame's own grid
// vertices are followed through the scene all their way, and where they land is held against where the frame
// has put them (docs/accuracy.md).
#pragma once
#include <vector>

#include "pipeline/measure/drawn_points.hpp"
#include "pipeline/measure/error_estimate.hpp"
#include "pipeline/measure/landing_images.hpp"
#include "pipeline/measure/light_paths.hpp"
#include "pipeline/measure/picture_blocks.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

// What a frame has more of than light, summed over the pixels of each of a picture's blocks: irradiance over
// the light's intensity, three channels a block, row by row from the bottom.
struct Surplus {
  int side = 1;            // of a block, pixels
  std::size_t across = 0;  // blocks
  std::vector<double> values;
};

// One light's rays, its samples' together, and what both have put into the picture's blocks.
class ModelError {
 public:
  // `rays`: about how many of all samples'. All must outlive it.
  ModelError(const LightPaths& paths, const PictureBlocks& blocks, int rays);

  struct Sample {
    const Light& light;
    const View& caster;  // LightViews::caster
    const std::vector<BranchImages>& branches;
    double share = 1.0;  // of the sample's flux, in the light's unit
    int samples = 1;     // of the light
    // Set for a light whose size is drawn: its points, and the places of the vertices.
    const DrawnPoints* points = nullptr;
    ImageView caster_position{};
    double unseen = 0.0;  // unseen_share
  };
  void add(const Sample& sample);
  const LightPaths& paths() const { return paths_; }

  // Puts into the estimate what the frame alone does not know: `model`, `sampling`, `not_followed`; `missing`
  // where that light would land in the picture; and takes all light that lands for the whole.
  void complete(ErrorEstimate& estimate) const;
  Surplus surplus() const;

 private:
  struct Vertex;
  // Three a block; `sizes`: what was added to the values, whatever its sign.
  struct Sums {
    std::vector<double> values, sizes;
  };
  void compare(const Sample& sample, Vertex& vertex);
  static LightRay ray_onto(const Sample& sample, const Vertex& vertex);
  void follow(const Sample& sample, const std::vector<Vertex>& vertices);
  void take(const LightLanding& landing, const Vertex& vertex);
  bool sees(const glm::dvec3& p) const;
  void put(int half, std::size_t block, const glm::dvec3& light);
  std::vector<double> signs(const Sums& surplus) const;

  const LightPaths& paths_;
  const PictureBlocks& blocks_;
  int rays_;
  bool any_drawn_ = false;
  int least_step_ = 0;  // between the vertices that are judged, along both sides of the grid
  Sums surplus_[2];     // of rays in turn: what the frame has more of than light
  double lit_ = 0.0;    // in the picture, by light
  double lost_ = 0.0;   // of that, what goes the way of the passes, which have not found its landing
  double landed_ = 0.0;
  double unseen_ = 0.0;  // beside that, what would land through parts of casters that the grid does not show
  double followed_ = 0.0;  // of what has landed, on ways that the passes take; or all that they have landed
};

}  // namespace caustics
