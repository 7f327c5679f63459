#include "passes/landing/landing.hpp"

#include <cmath>
#include <functional>
#include <optional>

#include "pipeline/measure/ledger.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/cube_map.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A light straight down from 10 m, casters around height 1, a floor at height 0. The caster map is one
// grid vertex at (0, 1, 0) repeated, so every texel of a 2 x 2 grid tells the same.
struct Bench {
  View view = down(4.0, 10.0, 20.0);
  glm::vec3 normal{0.0f, 1.0f, 0.0f};
  float facing = 1.0f;
  float ior = 1.5f;
  bool mirror = false;
  glm::vec3 color{1.0f};  // what glass lets through; of a mirror, its reflectance at normal incidence
  glm::vec3 absorption{0.0f};
  float dispersion = 0.0f;  // n_F - n_C
  glm::vec3 channel_share{1.0f};
  float bend = 0.0f;
  bool reflected = false;
  std::optional<glm::vec3> tint;  // the grid vertices' own colour, in place of `color`
  bool wyman = false;
  bool solid = false;
  float exit_height = 0.5f;
  glm::vec3 exit_normal{0.0f, -1.0f, 0.0f};
  glm::vec3 receivers_lower{-100.0f, 0.0f, -100.0f}, receivers_upper{100.0f, 0.0f, 100.0f};
  int iterations = 5;
  int estimator = ESTIMATOR_SECANT;
  bool paper_weights = false;
  Image receiver = floor_map(64, 0.0, 0.0);
  View impostors = with_atlas(cube_view({0.0, 2.0, 0.0}, {1.0, 20.0}), 300);
  Image impostor;  // positions around impostors.origin

  // Positions of the plane y = height + slope * x over the frame, as receiver_map writes them.
  Image floor_map(int size, double height, double slope) const {
    Image image(Format::RGBA32F, size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double px = -4.0 + 8.0 * (x + 0.5) / size;
        image.at(x, y, 0) = static_cast<float>(px);
        image.at(x, y, 1) = static_cast<float>(height + slope * px);
        image.at(x, y, 2) = static_cast<float>(4.0 - 8.0 * (y + 0.5) / size);
        image.at(x, y, 3) = 1.0f;
      }
    return image;
  }

  PassImages run() const {
    const std140::View seen = shader_view(view);
    const std140::Landing u{
        .caster = seen,
        .receiver = seen,
        .caustic = seen,
        .cone = {.axis = {0.0f, -1.0f, 0.0f}, .scale = 0.0f, .offset = 0.0f, .lambertian = 0},
        .light = {0.0f, -1.0f, 0.0f},
        .cell_area = 0.25f,
        .channel_share = channel_share,
        .bend = bend,
        .receivers_lower = receivers_lower,
        .exit_tolerance = 2.0f,
        .receivers_upper = receivers_upper,
        .landing_tolerance = 2.0f,
        .impostor_centre = impostors.origin,
        .tile_width = 0.0f,
        .tile_height = 0.0f,
        .tile_guard = 0.0f,
        .iterations = iterations,
        .estimator = estimator,
        .paper_weights = paper_weights,
        .is_reflection = reflected,
        .has_mirrors = mirror,
        .has_exit_maps = solid,
        .wyman_thickness = wyman,
        .has_caster_tint = tint.has_value(),
        .only_unconverged = 0,
        .impostor = shader_view(impostors)};
    Image materials(Format::RGBA32F, 3, 1);
    for (int c = 0; c < 3; ++c) {
      materials.at(1, 0, c) = absorption[c];
      materials.at(2, 0, c) = color[c];
    }
    materials.at(0, 0, 0) = ior;
    materials.at(0, 0, 1) = dispersion;
    materials.at(0, 0, 3) = mirror ? 1.0f : 0.0f;
    materials.at(1, 0, 3) = solid ? 1.0f : 0.0f;
    Image exit = floor_map(64, static_cast<double>(exit_height), 0.0);
    return run_pass(
        definition_of(landing_pass()),
        {.width = 2,
         .height = 2,
         .uniforms = uniform_bytes(u),
         .textures = {filled(2, 2, {0.0f, 1.0f, 0.0f, facing}), filled(2, 2, glm::vec4(normal, 0.0f)), exit,
                      filled(64, 64, glm::vec4(exit_normal, 1.0f)), receiver, materials,
                      tint ? filled(2, 2, glm::vec4(*tint, 1.0f)) : Image{}, impostor, Image{}}});
  }
};

LandingStatus status(const PassImages& out) {
  return static_cast<LandingStatus>(static_cast<int>(out["landing"].at(0, 0, 3)));
}

// The unit normal tilted by `degrees` from up towards +x.
glm::vec3 tilted(double degrees) {
  const double a = degrees * 3.14159265358979323846 / 180.0;
  return {static_cast<float>(std::sin(a)), static_cast<float>(std::cos(a)), 0.0f};
}

}  // namespace

TEST_CASE("landing: through a level surface light falls straight and loses its Fresnel share") {
  // R0 = ((1.5 - 1) / (1.5 + 1))^2 = 0.04.
  const PassImages out = Bench{}.run();
  REQUIRE(status(out) == LandingStatus::Landed);
  const glm::vec4 p = texel(out["landing"], 0, 0);
  CHECK(p.x == 0.0f);
  CHECK(p.y == Approx(0.0).margin(1e-5));
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96));
  CHECK(out["landing_fresnel"].at(0, 0, 1) == Approx(0.25 * 0.04));
  CHECK(out["landing_fresnel"].at(0, 0, 3) == 0.25f);
}

TEST_CASE("landing: a tilted surface bends light by Snell's law") {
  // Incidence 30 degrees: sin t = 0.5 / 1.5, t = 19.4712 degrees; the ray leans 10.5288 degrees away
  // from the vertical, against the tilt, and falls 1 m: x = -tan 10.5288 degrees.
  Bench bench;
  bench.normal = tilted(30.0);
  const PassImages out = bench.run();
  REQUIRE(status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == Approx(-std::tan(0.183762)).epsilon(1e-4));
}

TEST_CASE("landing: an index of 1 bends nothing and loses nothing") {
  Bench bench;
  bench.ior = 1.0f;
  bench.normal = tilted(60.0);
  const PassImages out = bench.run();
  CHECK(out["landing"].at(0, 0, 0) == 0.0f);
  CHECK(out["landing_flux"].at(0, 0, 2) == 0.25f);
}

TEST_CASE("landing: a slab of two parallel surfaces leaves the direction as it was") {
  Bench bench;
  bench.solid = true;
  const PassImages out = bench.run();
  REQUIRE(status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == 0.0f);
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96 * 0.96));
  CHECK(out["landing_absorbed"].at(0, 0, 3) == Approx(0.5));
}

TEST_CASE("landing: a solid absorbs by Beer and Lambert along the path inside, per channel") {
  Bench bench;
  bench.solid = true;
  bench.absorption = {0.0f, 1.0f, 4.0f};
  const PassImages out = bench.run();
  const double in = 0.25 * 0.96;
  CHECK(out["landing_absorbed"].at(0, 0, 0) == Approx(0.0).margin(1e-9));
  CHECK(out["landing_absorbed"].at(0, 0, 1) == Approx(in * (1.0 - std::exp(-0.5))));
  CHECK(out["landing_absorbed"].at(0, 0, 2) == Approx(in * (1.0 - std::exp(-2.0))));
  CHECK(out["landing_flux"].at(0, 0, 2) == Approx(in * std::exp(-2.0) * 0.96));
}

TEST_CASE("landing: under an open surface the medium absorbs down to the receiver") {
  Bench bench;
  bench.absorption = {1.0f, 0.0f, 0.0f};
  CHECK(bench.run()["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96 * std::exp(-1.0)));
}

TEST_CASE("landing: beyond the critical angle nothing leaves and the flux is booked") {
  // asin(1 / 1.5) = 41.81 degrees: an exit surface leaning 45 degrees reflects all.
  Bench bench;
  bench.solid = true;
  bench.exit_normal = -tilted(45.0);
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::TotalReflection);
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96));
  bench.exit_normal = -tilted(41.0);
  CHECK(status(bench.run()) == LandingStatus::Landed);
}

TEST_CASE("landing: every vertex's flux is accounted for to rounding") {
  Bench bench;
  bench.solid = true;
  bench.absorption = {0.5f, 1.0f, 2.0f};
  bench.exit_normal = -tilted(20.0);
  const PassImages out = bench.run();
  for (int c = 0; c < 3; ++c)
    CHECK(double(out["landing_flux"].at(0, 0, c)) + double(out["landing_fresnel"].at(0, 0, c)) +
              double(out["landing_absorbed"].at(0, 0, c)) ==
          Approx(0.25).epsilon(1e-6));
}

TEST_CASE("landing: the secant meets a tilted plane exactly") {
  // The ray x = -s t, y = 1 - c t with tan = s / c from 30 degrees' tilt meets y = 0.3 x where
  // 1 - c t = -0.3 s t.
  Bench bench;
  bench.normal = tilted(30.0);
  bench.receiver = bench.floor_map(64, 0.0, 0.3);
  bench.iterations = 2;
  const double s = std::sin(0.183762), c = std::cos(0.183762);
  const double t = 1.0 / (c - 0.3 * s);
  const PassImages out = bench.run();
  REQUIRE(status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == Approx(-s * t).epsilon(1e-4));
  CHECK(out["landing"].at(0, 0, 1) == Approx(-0.3 * s * t).epsilon(1e-3));
}

TEST_CASE("landing: the paper's estimator contracts by the squared sine on a level plane") {
  // x_{k+1}^2 - x*^2 = sin^2(theta) (x_k^2 - x*^2), started at 0 (from x_{k+1}^2 = h^2 +
  // (x_k sin theta)^2). After k steps x^2 = x*^2 (1 - sin^(2k) theta); with nearest texels of 1/8 m at
  // theta = 10.5 degrees the quantisation of the look-up is what remains.
  Bench bench;
  bench.normal = tilted(30.0);
  bench.estimator = ESTIMATOR_PAPER;
  bench.receiver = bench.floor_map(1024, 0.0, 0.0);
  const double theta = 0.183762, exact = 1.0 / std::cos(theta);
  for (const int k : {1, 2, 3}) {
    bench.iterations = k;
    const glm::vec4 p = texel(bench.run()["landing"], 0, 0);
    const double x = std::hypot(double(p.x), 1.0 - double(p.y));
    CHECK(x == Approx(exact * std::sqrt(1.0 - std::pow(std::sin(theta), 2 * k))).margin(8.0 / 1024));
  }
}

TEST_CASE("landing: light that meets no receiver is missed, light that leaves the map is outside") {
  Bench bench;
  bench.receiver = Image(Format::RGBA32F, 8, 8);
  CHECK(status(bench.run()) == LandingStatus::Missed);
  bench.receiver = bench.floor_map(64, 0.0, 0.0);
  bench.normal = tilted(85.0);
  bench.ior = 3.0f;
  bench.view.window_lower = glm::dvec2(-0.2);
  bench.view.window_upper = glm::dvec2(0.2);
  CHECK(status(bench.run()) == LandingStatus::Outside);
  // Where the floor ends inside the window, the same ray passes it.
  bench.receivers_lower = {-0.2f, 0.0f, -0.2f};
  bench.receivers_upper = {0.2f, 0.0f, 0.2f};
  CHECK(status(bench.run()) == LandingStatus::Missed);
}

TEST_CASE("landing: of light that leaves the map, only what goes towards the receivers' box is outside") {
  // A mirror turned by 45 degrees sends the light to -x or +x along y = 1; the map sees 0.2 m around.
  Bench bench;
  bench.mirror = true;
  bench.normal = tilted(45.0);
  bench.view.window_lower = glm::dvec2(-0.2);
  bench.view.window_upper = glm::dvec2(0.2);
  const auto wall_at = [&](float x) {
    bench.receivers_lower = {x, 0.0f, -1.0f};
    bench.receivers_upper = {x, 2.0f, 1.0f};
    return status(bench.run());
  };
  const float side = wall_at(5.0f) == LandingStatus::Outside ? 1.0f : -1.0f;
  CHECK(wall_at(5.0f * side) == LandingStatus::Outside);
  CHECK(wall_at(-5.0f * side) == LandingStatus::Missed);
}

TEST_CASE("landing: the paper's weight is N.L and ignores Fresnel") {
  Bench bench;
  bench.paper_weights = true;
  bench.normal = tilted(60.0);
  const PassImages out = bench.run();
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.125));
  CHECK(out["landing_fresnel"].at(0, 0, 0) == 0.0f);
}

TEST_CASE("landing: a texel without a caster writes zeros") {
  Bench bench;
  bench.facing = 0.0f;
  const PassImages out = bench.run();
  CHECK(texel(out["landing"], 0, 0) == glm::vec4(0.0f));
  CHECK(texel(out["landing_flux"], 1, 1) == glm::vec4(0.0f));
}

TEST_CASE("landing: a point light's cell subtends its solid angle") {
  // A cell of 0.25 tangent units squared on the axis: 0.25 sr by the midpoint form.
  Bench bench;
  bench.view.perspective = true;
  bench.view.near = 0.1;
  const PassImages out = bench.run();
  CHECK(out["landing_fresnel"].at(0, 0, 3) == Approx(0.25));
}

TEST_CASE("landing: a mirror sends light by the law of reflection and absorbs what its colour lacks") {
  // A steep mirror, its normal 60 degrees from up: light from above leaves along (sin 120, cos 120, 0) =
  // (0.8660254, -0.5, 0) and falls 1 m over 1.7320508 m.
  Bench bench;
  bench.mirror = true;
  bench.normal = tilted(60.0);
  const PassImages all = bench.run();
  CHECK(status(all) == LandingStatus::Landed);
  CHECK(all["landing"].at(0, 0, 0) == Approx(1.7320508).epsilon(1e-4));
  CHECK(all["landing"].at(0, 0, 1) == Approx(0.0).margin(1e-4));
  CHECK(all["landing_flux"].at(0, 0, 0) == 0.25f);
  CHECK(all["landing_absorbed"].at(0, 0, 0) == 0.0f);
  // Copper's red and blue at cos 0.5: f + (1 - f) 0.5^5.
  bench.color = {0.95f, 0.64f, 0.54f};
  const PassImages copper = bench.run();
  CHECK(copper["landing_flux"].at(0, 0, 0) == Approx(0.25 * (0.95 + 0.05 / 32)));
  CHECK(copper["landing_flux"].at(0, 0, 2) == Approx(0.25 * (0.54 + 0.46 / 32)));
  CHECK(copper["landing_absorbed"].at(0, 0, 2) == Approx(0.25 * (0.46 - 0.46 / 32)));
  CHECK(copper["landing_fresnel"].at(0, 0, 2) == 0.0f);
}

TEST_CASE("landing: the back of a mirror's wall mirrors as its front does") {
  Bench bench;
  bench.mirror = true;
  bench.normal = -tilted(60.0);
  bench.facing = -1.0f;
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == Approx(1.7320508).epsilon(1e-4));
}

TEST_CASE("landing: what a level mirror sends back towards the light lands nowhere") {
  Bench bench;
  bench.mirror = true;
  const LandingStatus where = status(bench.run());
  CHECK((where == LandingStatus::Missed || where == LandingStatus::Outside ||
         where == LandingStatus::NotConverged));
}

TEST_CASE("landing: the index is n_d and the branch's bend of n_F - n_C") {
  // Index 1.5 + 2 * 0.05 = 1.6 at 30 degrees: t = asin(0.5 / 1.6) = 18.2099 degrees, x = -tan(30 - 18.2099).
  Bench bench;
  bench.normal = tilted(30.0);
  bench.dispersion = 0.05f;
  bench.channel_share = {0.25f, 0.5f, 0.0f};
  bench.bend = 2.0f;
  const PassImages out = bench.run();
  CHECK(texel(out["landing"], 0, 0).x == Approx(-0.208716).epsilon(1e-4));
  // Each channel carries its share of the branch's flux; what entered stays whole.
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.5 * out["landing_flux"].at(0, 0, 1)));
  CHECK(out["landing_flux"].at(0, 0, 2) == 0.0f);
  CHECK(out["landing_fresnel"].at(0, 0, 3) == 0.25f);
}

TEST_CASE("landing: the reflected branch carries the Fresnel share along the mirrored ray") {
  // Normal 60 degrees towards +x: light is turned by 120 degrees and falls 30 degrees below the level, and
  // lands 1 / tan 30 = 1.7321 m to the right. R at 60 degrees for n = 1.5: ct = sqrt(1 - 0.75 / 2.25) =
  // 0.81650, Rs =
  // ((0.5 - 1.22474) / 1.72474)^2 = 0.176577, Rp = ((0.81650 - 0.75) / 1.56650)^2 = 0.001802, mean 0.089190.
  Bench bench;
  bench.normal = tilted(60.0);
  bench.reflected = true;
  const PassImages out = bench.run();
  REQUIRE(status(out) == LandingStatus::Landed);
  CHECK(texel(out["landing"], 0, 0).x == Approx(1.73205).epsilon(1e-4));
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.089190).epsilon(1e-4));
  CHECK(out["landing_fresnel"].at(0, 0, 0) == 0.0f);
}

TEST_CASE("landing: metal has no reflected branch, its light is mirrored already") {
  Bench bench;
  bench.mirror = true;
  bench.reflected = true;
  CHECK(status(bench.run()) == LandingStatus::Empty);
}

TEST_CASE("landing: the base colour tints what glass lets through") {
  Bench bench;
  bench.color = {1.0f, 0.5f, 0.25f};
  const PassImages out = bench.run();
  CHECK(out["landing_flux"].at(0, 0, 1) == Approx(0.25 * 0.96 * 0.5));
  CHECK(out["landing_absorbed"].at(0, 0, 2) == Approx(0.25 * 0.96 * 0.75));
}

TEST_CASE("landing: Newton's method meets a plane whatever its slope") {
  // f is linear along a ray to a plane, so a forward difference is exact but for rounding, and but for a
  // stencil that straddles the root, which the guard catches.
  for (const double slope : {0.0, 0.3, -0.3, 0.8}) {
    Bench bench;
    bench.normal = tilted(30.0);
    bench.estimator = ESTIMATOR_NEWTON;
    bench.receiver = bench.floor_map(64, 0.0, slope);
    const PassImages out = bench.run();
    REQUIRE(status(out) == LandingStatus::Landed);
    // The ray leans 10.5288 degrees towards -x: y = 1 + x / tan, and y = slope x.
    const double x = 1.0 / (slope - 1.0 / std::tan(10.5288 * 3.14159265358979323846 / 180.0));
    CHECK(texel(out["landing"], 0, 0).x == Approx(x).margin(2e-4));
  }
}

TEST_CASE("landing: Newton's method is held where its slope is none") {
  // A step of 3 m under the ray: whatever happens there, every value stays finite and in range.
  Bench bench;
  bench.normal = tilted(30.0);
  bench.estimator = ESTIMATOR_NEWTON;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 32; ++x) bench.receiver.at(x, y, 1) = -3.0f;
  for (const int iterations : {1, 2, 3, 5, 20}) {
    bench.iterations = iterations;
    const PassImages out = bench.run();
    for (int c = 0; c < 4; ++c) {
      CHECK(std::isfinite(out["landing"].at(0, 0, c)));
      CHECK(std::fabs(out["landing"].at(0, 0, c)) < 30.0f);
    }
  }
}

TEST_CASE("landing: Wyman's thickness is the mean of two, by the angles") {
  // Exit plane 0.5 m below the entry point: d_V = 0.5 straight down. Normal tilted by 30 degrees: d_N = 0.5 /
  // cos 30 = 0.577350; incidence 30, refraction 19.4712 degrees: 0.649040 * 0.5 + 0.350960 * 0.577350 =
  // 0.527147.
  Bench bench;
  bench.normal = tilted(30.0);
  bench.solid = true;
  bench.wyman = true;
  CHECK(bench.run()["landing_absorbed"].at(0, 0, 3) == Approx(0.527147).epsilon(1e-5));
  // Straight on, the two are one.
  bench.normal = tilted(0.0);
  CHECK(bench.run()["landing_absorbed"].at(0, 0, 3) == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("landing: a grid vertex's own colour takes the place of its material's, once for both surfaces") {
  // 0.96 is left at either surface of the slab.
  Bench bench;
  bench.solid = true;
  bench.color = {0.1f, 0.1f, 0.1f};
  bench.tint = glm::vec3(0.5f, 1.0f, 0.0f);
  const PassImages out = bench.run();
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96 * 0.96 * 0.5));
  CHECK(out["landing_flux"].at(0, 0, 1) == Approx(0.25 * 0.96 * 0.96));
  CHECK(out["landing_flux"].at(0, 0, 2) == 0.0f);
  CHECK(out["landing_absorbed"].at(0, 0, 2) == Approx(0.25 * 0.96));
}

TEST_CASE("landing: a mirror's own colour at a grid vertex is its reflectance there") {
  // Light straight onto a mirror that leans by 45 degrees: Schlick's grazing share is (1 - cos 45)^5 =
  // 0.002155.
  Bench bench;
  bench.mirror = true;
  bench.color = {1.0f, 1.0f, 1.0f};
  bench.tint = glm::vec3(0.5f, 0.25f, 0.0f);
  bench.normal = tilted(45.0);
  const PassImages out = bench.run();
  const double grazing = std::pow(1.0 - std::sqrt(0.5), 5.0);
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * (0.5 + 0.5 * grazing)));
  CHECK(out["landing_flux"].at(0, 0, 2) == Approx(0.25 * grazing));
}

namespace {

// A level floor's distance along d from a point at this height.
double to_floor(const glm::dvec3& d, double height) { return d.y < 0.0 ? height / -d.y : 0.0; }

// How far from (0, 1, 0) the light has landed.
double flown(const PassImages& out) {
  return glm::length(glm::dvec3(glm::vec3(texel(out["landing"], 0, 0))) - glm::dvec3(0.0, 1.0, 0.0));
}

// A mirror at (0, 1, 0) that sends the light from above along (-0.6, -0.8, 0), and impostors to find it by.
Bench impostor_bench(const glm::dvec3& centre, const std::function<double(const glm::dvec3&)>& distance,
                     int side = 600) {
  Bench bench;
  bench.mirror = true;
  bench.normal = {-0.948683298f, 0.316227766f, 0.0f};
  bench.estimator = ESTIMATOR_IMPOSTOR;
  bench.impostors = with_atlas(cube_view(centre, {1.0, 20.0}), side);
  bench.impostor = positions_around(bench.impostors, distance);
  return bench;
}

}  // namespace

TEST_CASE("landing: distance impostors meet a plane by the paper's start alone") {
  // The start d0 = D(R) (1 - |p| / D(p)) is exact on a plane; one step more must leave it there. 1 m down at
  // 0.8 a metre: 1.25 m.
  Bench bench = impostor_bench({0.0, 2.0, 0.0}, [](const glm::dvec3& d) { return to_floor(d, 2.0); });
  bench.iterations = 1;
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::Landed);
  CHECK(flown(out) == Approx(1.25).epsilon(1e-5));
  CHECK(out["landing_flux"].at(0, 0, 3) < 1e-5f);
}

TEST_CASE("landing: distance impostors that fall short go on by the ray's own distance") {
  // A sphere of 1 m whose centre lies 0.5 m beside the ray: q = sqrt(0.25 + d^2). d0 = 1 - 0.5, q0 =
  // 0.707107; d1 = 0.5 + (1 - q0) = 0.792893, q1 = 0.937379; d2 = 0.855514, q2 = 0.990920; d3 = 0.864595.
  Bench bench = impostor_bench(
      {-0.4, 1.3, 0.0}, [](const glm::dvec3& d) { return 1.0 / glm::length(d); }, 2400);
  const double steps[] = {0.792893, 0.855514, 0.864595};
  for (int k = 1; k <= 3; ++k) {
    bench.iterations = k;
    CHECK(flown(bench.run()) == Approx(steps[k - 1]).epsilon(2e-5));
  }
  // The exact distance is 0.866025; after one step a gap of 63 mm is left, which is not taken for a landing.
  bench.iterations = 1;
  CHECK(status(bench.run()) == LandingStatus::NotConverged);
  bench.iterations = 8;
  CHECK(status(bench.run()) == LandingStatus::Landed);
  CHECK(flown(bench.run()) == Approx(0.866025).epsilon(1e-4));
}

TEST_CASE("landing: distance impostors that go too far come back by the secant") {
  // The middle is 1 m above the mirror. Along the ray's direction it sees into a pit of 10 m below: D(R)
  // = 12.5 and d0 = 12.5 (1 - 1 / 2) = 6.25, where l = (-3.75, -6) points at the floor: q = 6 / 2 = 3, too
  // far. From q = 0.5 at 0 the secant gives 6.25 (1 - 0.5) / (3 - 0.5) = 1.25, which is the floor.
  Bench bench = impostor_bench({0.0, 2.0, 0.0}, [](const glm::dvec3& d) {
    const bool pit = d.y < 0.0 && d.x < 0.65 * d.y;
    return to_floor(d, pit ? 10.0 : 2.0);
  });
  bench.iterations = 1;
  const PassImages out = bench.run();
  CHECK(flown(out) == Approx(1.25).epsilon(1e-5));
  CHECK(status(out) == LandingStatus::Landed);
}

TEST_CASE("landing: distance impostors see all of a box room, over the cube's edges too") {
  // A room of 4 x 3 x 4 m. Mirrors turned many ways send the light at every wall, past edges and corners of
  // the cube; it must land on a wall, and in the ray's direction.
  const glm::dvec3 middle{0.3, 1.4, -0.2};
  const auto walls = [&](const glm::dvec3& from, const glm::dvec3& d) {
    double t = 1e30;
    const double lower[3] = {-2.0, 0.0, -2.0}, upper[3] = {2.0, 3.0, 2.0};
    for (int a = 0; a < 3; ++a)
      if (d[a] != 0.0) t = std::min(t, ((d[a] > 0.0 ? upper[a] : lower[a]) - from[a]) / d[a]);
    return t;
  };
  Bench bench = impostor_bench(middle, [&](const glm::dvec3& d) { return walls(middle, d); });
  bench.iterations = 12;
  bench.view = down(8.0, 10.0, 20.0);
  int landed = 0;
  for (int turn = 0; turn < 40; ++turn)
    for (const double lean : {0.15, 0.5, 0.7, 0.95, 1.2}) {
      const double a = 0.157 * turn;
      const glm::dvec3 n{std::sin(lean) * std::cos(a), std::cos(lean), std::sin(lean) * std::sin(a)};
      bench.normal = glm::vec3(n);
      const PassImages out = bench.run();
      // The light falls along -y: r = d - 2 (d.n) n.
      const glm::dvec3 r = glm::dvec3(0.0, -1.0, 0.0) + 2.0 * n.y * n;
      if (status(out) != LandingStatus::Landed) continue;
      ++landed;
      CHECK(flown(out) == Approx(walls({0.0, 1.0, 0.0}, r)).epsilon(0.01));
    }
  CHECK(landed == 200);
}

TEST_CASE("landing: distance impostors without a surface book what is missed") {
  Bench bench = impostor_bench({0.0, 2.0, 0.0}, [](const glm::dvec3&) { return 0.0; });
  CHECK(status(bench.run()) == LandingStatus::Missed);
  // From the very middle of the cube, where the start has no direction.
  bench = impostor_bench({0.0, 1.0, 0.0}, [](const glm::dvec3& d) { return to_floor(d, 1.0); });
  CHECK(flown(bench.run()) == Approx(1.25).epsilon(1e-5));
}
