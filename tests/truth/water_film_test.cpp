// Water that moves, from the waves to the light on the floor (figure 8 of the paper).
#include <cmath>

#include "pipeline/renderer/moving_water.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/water.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A pool at one moment after another, as the program renders it.
class Film {
 public:
  Film(Scene scene, const Settings& settings)
      : scene_(std::move(scene)),
        settings_(settings),
        renderer_(scene_, settings_, pass_registry(), *device_,
                  {.goal = {{"picture", "aov_caustic", "aov_direct", kCausticMap, kLandingFresnel},
                            all_attachments()}}) {}

  const Rendering& show(double seconds) {
    renderer_.show_waters(seconds);
    out_ = rendering_of(renderer_);
    return out_;
  }

  Ledger ledger() const { return ledger_of(out_, settings_); }
  const Mesh& water() const { return scene_.meshes[1]; }

 private:
  Scene scene_;
  Settings settings_;
  std::unique_ptr<Device> device_ = make_software_device();
  FrameRenderer renderer_;
  Rendering out_;
};

WaterSettings waves() {
  return {.speed = 0.5,
          .damping = 0.2,
          .cells = 64,
          .start = 2.0,
          .interval = 0.3,
          .radius = 0.2,
          .height = 0.02,
          .seed = 5};
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double ma = mean(a), mb = mean(b);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - ma) * (b[i] - mb);
    aa += (a[i] - ma) * (a[i] - ma);
    bb += (b[i] - mb) * (b[i] - mb);
  }
  return ab / std::sqrt(aa * bb);
}

// The water's height over the middle of each of n x n equal parts of the sheet, row 0 at +z as in the
// picture; its mesh has a vertex in every middle where n is half its own parts.
std::vector<double> heights(const Mesh& water, int n) {
  std::vector<double> result(static_cast<std::size_t>(n * n), 0.0);
  for (const Vertex& v : water.vertices) {
    const double x = (static_cast<double>(v.position.x) + 1.0) * 0.5 * n - 0.5;
    const double y = (1.0 - static_cast<double>(v.position.z)) * 0.5 * n - 0.5;
    const int i = static_cast<int>(std::floor(x + 0.5)), j = static_cast<int>(std::floor(y + 0.5));
    if (i < 0 || j < 0 || i >= n || j >= n || std::fabs(x - i) > 1e-3 || std::fabs(y - j) > 1e-3) continue;
    result[static_cast<std::size_t>(j * n + i)] = static_cast<double>(v.position.y);
  }
  return result;
}

}  // namespace

TEST_CASE("water film: all light that enters is booked in every frame, and as much enters") {
  Film film(pool_scene(0.4, waves()), through_two_surfaces(small_settings(128, 128, 64)));
  for (int n = 0; n < 12; ++n) {
    film.show(n / 8.0);
    const Ledger ledger = film.ledger();
    INFO("frame " << n);
    // A vertical light of 1 lux on 4 square metres, in grid cells of 2 m / 124 whose middles are in or out:
    // 1 / 124 a side at worst.
    CHECK(ledger.entered[0] == Approx(4.0).epsilon(0.01));
    const double lost =
        ledger.missed[0] + ledger.outside[0] + ledger.not_converged[0] + ledger.total_reflection[0];
    // What a wave at the edge throws beyond the floor: it is booked as missed.
    CHECK(lost < 0.05 * ledger.entered[0]);
    CHECK(ledger.fresnel[0] == Approx(0.02 * ledger.entered[0]).epsilon(0.05));
    CHECK(ledger.in_map[0] + lost + ledger.fresnel[0] == Approx(ledger.entered[0]).epsilon(1e-4));
  }
}

TEST_CASE("water film: where the water is curved like a crest the floor below is bright") {
  // 0.1 m deep the waves do not focus yet: E = 1 / (1 - d (1 - 1/n) (-laplace h)) to first order,
  // so brightness follows the negative Laplacian, and goes with the height.
  Film film(pool_scene(0.1, waves()), small_settings(256, 256, 32));
  for (const double seconds : {0.0, 0.5, 1.0, 1.5}) {
    const Rendering& r = film.show(seconds);
    const std::vector<double> h = heights(film.water(), 32);
    std::vector<double> bright, height, crest;
    for (int y = 2; y < 30; ++y)
      for (int x = 2; x < 30; ++x) {
        const auto at = [&](int i, int j) { return h[static_cast<std::size_t>(j * 32 + i)]; };
        bright.push_back(static_cast<double>(r["aov_caustic"].at(x, y, 0)));
        height.push_back(at(x, y));
        crest.push_back(4.0 * at(x, y) - at(x - 1, y) - at(x + 1, y) - at(x, y - 1) - at(x, y + 1));
      }
    INFO("at " << seconds << " s: curvature " << correlation(bright, crest) << ", height "
               << correlation(bright, height) << ", mean " << mean(bright));
    CHECK(correlation(bright, crest) > 0.95);
    CHECK(correlation(bright, height) > 0.8);
    CHECK(mean(bright) == Approx(1.0 - 0.0200588).epsilon(1e-3));
  }
}

TEST_CASE("water film: a frame alone is the frame of a film, to the bit") {
  const Settings settings = small_settings(64, 64, 48);
  Film film(pool_scene(0.4, waves()), settings);
  for (const double seconds : {0.25, 0.5, 0.75}) film.show(seconds);
  const std::string in_film = sha256(film.show(1.0)["picture"]);
  CHECK(sha256(Film(pool_scene(0.4, waves()), settings).show(1.0)["picture"]) == in_film);
}

TEST_CASE("water film: flat water lights the floor evenly at every moment") {
  WaterSettings calm = waves();
  calm.height = 0.0;
  Film film(pool_scene(0.4, calm), small_settings(128, 128, 32));
  for (const double seconds : {0.0, 1.0}) {
    const Rendering& r = film.show(seconds);
    for (int y = 1; y < 31; ++y)
      for (int x = 1; x < 31; ++x)
        CHECK(static_cast<double>(r["aov_caustic"].at(x, y, 0)) == Approx(1.0 - 0.0200588).epsilon(2e-3));
  }
}

namespace {

// A ball of glass hangs in the water, so that light is followed.
Scene pool_with_ball(const WaterSettings& settings) {
  Scene scene = pool_scene(0.6, settings);
  scene.meshes.push_back(sphere({0.0, 0.3, 0.0}, 0.15, 4, 2));
  scene.materials.push_back(glass(1.6f));
  return scene;
}

}  // namespace

TEST_CASE("water film: where light is followed a frame alone is the frame of a film, to the bit") {
  const Settings settings = small_settings(64, 64, 48);
  Film film(pool_with_ball(waves()), settings);
  const std::string early = sha256(film.show(0.25)["picture"]);
  const std::string in_film = sha256(film.show(1.0)["picture"]);
  CHECK(early != in_film);
  CHECK(sha256(Film(pool_with_ball(waves()), settings).show(1.0)["picture"]) == in_film);
  CHECK(film.ledger().residual() < 1e-5);
}

TEST_CASE("water film: flat water sends followed light where a sheet that never moves does") {
  WaterSettings calm = waves();
  calm.height = 0.0;
  Scene still = pool_with_ball(calm);
  Film film(still, small_settings(128, 128, 32));
  still.waters.clear();
  const Image moves = film.show(1.0)["aov_caustic"];
  const Rendering stands = render(still, small_settings(128, 128, 32), {"aov_caustic"});
  REQUIRE(stands.effects.further_surfaces.active);
  double difference = 0.0, sum = 0.0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const double light = static_cast<double>(stands["aov_caustic"].at(x, y, 0));
      difference += std::fabs(static_cast<double>(moves.at(x, y, 0)) - light);
      sum += light;
    }
  CHECK(difference < 0.03 * sum);
}
