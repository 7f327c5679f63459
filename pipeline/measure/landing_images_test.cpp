#include "pipeline/measure/landing_images.hpp"

#include <map>

#include "pipeline/plan/frame_plan.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A light's textures of two texels, each all of one value; those of the farthest receivers hold 2 where they
// have landed, the nearest 1.
struct Textures {
  std::map<std::string, Image> images;

  explicit Textures(std::size_t landed_far) {
    for (const std::string name : {kLanding, kLandingFlux, kLandingFresnel, kLandingAbsorbed, kCellFlux}) {
      images[light_texture(name, 0)] = filled(2, 1, glm::vec4(1.0f));
      Image& far = images[light_texture(far_texture(name), 0)] = filled(2, 1, glm::vec4(0.0f));
      for (int c = 0; c < 4; ++c) far.at(static_cast<int>(landed_far), 0, c) = 2.0f;
    }
  }
  BranchImages merged() const {
    return images_of_branch(
        0, Branch{}, [&](const std::string& name) { return images.count(name) > 0; },
        [&](const std::string& name) { return ImageView(images.at(name)); });
  }
};

}  // namespace

TEST_CASE("landing images: what landed on the farthest receivers alone stands in the place of the rest") {
  for (const std::size_t landed_far : {0u, 1u}) {
    const Textures textures(landed_far);
    const BranchImages images = textures.merged();
    for (const ImageView* image :
         {&images.landing, &images.flux, &images.fresnel, &images.absorbed, &images.cell_flux})
      for (int x = 0; x < 2; ++x) {
        INFO("texel " << x << ", far " << landed_far);
        CHECK(image->at(x, 0, 3) == (x == static_cast<int>(landed_far) ? 2.0f : 1.0f));
        CHECK(image->at(x, 0, 0) == image->at(x, 0, 3));
      }
  }
}
