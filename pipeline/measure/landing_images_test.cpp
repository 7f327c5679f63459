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
    for (const std::string name :
         {kLanding, kLandingFlux, kLandingFresnel, kLandingAbsorbed, kCellFlux, kCellNear, kCellFar}) {
      images[light_texture(name, 0)] = filled(2, 1, glm::vec4(1.0f));
      Image& far = images[light_texture(far_texture(name), 0)] = filled(2, 1, glm::vec4(0.0f));
      for (int c = 0; c < 4; ++c) far.at(static_cast<int>(landed_far), 0, c) = 2.0f;
    }
  }
  bool has(const std::string& name) const { return images.count(name) > 0; }
  ImageView read(const std::string& name) const { return images.at(name); }
};

}  // namespace

TEST_CASE("landing images: what landed on the farthest receivers alone stands in the place of the rest") {
  for (const std::size_t landed_far : {0u, 1u}) {
    const Textures textures(landed_far);
    const auto has = [&](const std::string& name) { return textures.has(name); };
    const auto read = [&](const std::string& name) { return textures.read(name); };
    const std::vector<BranchImages> all = branch_images(0, {Branch{}}, has, read);
    const std::vector<CellImages> all_cells = cell_images(0, {Branch{}}, has, read);
    REQUIRE(all.size() == 1);
    REQUIRE(all_cells.size() == 1);
    const BranchImages& images = all[0];
    const CellImages& cells = all_cells[0];
    for (const ImageView* image : {&images.landing, &images.flux, &images.fresnel, &images.absorbed,
                                   &images.cell_flux, &cells.near, &cells.far})
      for (int x = 0; x < 2; ++x) {
        INFO("texel " << x << ", far " << landed_far);
        CHECK(image->at(x, 0, 3) == (x == static_cast<int>(landed_far) ? 2.0f : 1.0f));
        CHECK(image->at(x, 0, 0) == image->at(x, 0, 3));
      }
  }
}
