// The closed forms against published and hand-checked numbers, against each other, and against rays
// traced in three dimensions by the plain vector form of Snell's law.
#include "lab/reference/closed_forms.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

constexpr double kPi = std::numbers::pi;
double degrees(double radians) { return radians * 180.0 / kPi; }
double radians(double degrees) { return degrees * kPi / 180.0; }

struct Ray {
  glm::dvec3 origin, direction;
};

// Snell's law as textbooks have it, on purpose not the form under test.
glm::dvec3 bent(const glm::dvec3& d, const glm::dvec3& outward, double n1, double n2) {
  const glm::dvec3 normal = glm::dot(d, outward) < 0.0 ? outward : -outward;
  const double ratio = n1 / n2, ci = -glm::dot(d, normal);
  const double ct = std::sqrt(1.0 - ratio * ratio * (1.0 - ci * ci));
  return ratio * d + (ratio * ci - ct) * normal;
}

// Where a ray that travels along -z at (b, 0) crosses z = -distance behind a sphere round the
// origin.
double traced_sphere_landing(double b, const GlassSphere& s) {
  const glm::dvec3 entry(b, 0.0, std::sqrt(s.radius * s.radius - b * b));
  const glm::dvec3 inside = bent({0.0, 0.0, -1.0}, entry / s.radius, 1.0, s.index);
  const glm::dvec3 exit = entry - 2.0 * glm::dot(entry, inside) * inside;
  const glm::dvec3 out = bent(inside, exit / s.radius, s.index, 1.0);
  return exit.x + out.x * (-s.distance - exit.z) / out.z;
}

double traced_water_landing(double x, const WaterWave& w) {
  const double slope = -w.amplitude * w.wave_number * std::sin(w.wave_number * x);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope, 0.0, 1.0));
  const glm::dvec3 d = bent({0.0, 0.0, -1.0}, normal, 1.0, w.index);
  return x - d.x * w.height(x) / d.z;
}

double traced_prism_deviation(double apex, double n, double incidence) {
  // Faces through the origin, the apex at the top: outward normals to the left and to the right.
  const glm::dvec3 left(-std::cos(apex / 2), std::sin(apex / 2), 0.0);
  const glm::dvec3 right(std::cos(apex / 2), std::sin(apex / 2), 0.0);
  // From the base's side of the left face's normal.
  const glm::dvec3 along(-left.y, left.x, 0.0);
  const glm::dvec3 d = -std::cos(incidence) * left - std::sin(incidence) * along;
  const glm::dvec3 out = bent(bent(d, left, 1.0, n), right, n, 1.0);
  return std::acos(glm::dot(d, out));
}

template <typename F>
double slope_of(const F& f, double x, double step = 1e-6) {
  return (f(x + step) - f(x - step)) / (2.0 * step);
}

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

}  // namespace

TEST_CASE("Interfaces: critical and Brewster angles, reflectance at normal incidence") {
  CHECK(degrees(critical_angle(1.33)) == Approx(48.7535).margin(1e-4));
  CHECK(degrees(critical_angle(1.5)) == Approx(41.8103).margin(1e-4));
  CHECK(degrees(critical_angle(2.42)) == Approx(24.4075).margin(1e-4));
  CHECK(degrees(brewster_angle(1.33)) == Approx(53.061).margin(1e-3));
  CHECK(fresnel(1.0, 1.0, 1.33).mean() == Approx(0.02006).margin(1e-5));
  CHECK(fresnel(1.0, 1.0, 1.5).mean() == Approx(0.04).epsilon(1e-12));
  CHECK(fresnel(1.0, 1.0, 2.42).mean() == Approx(0.17239).margin(1e-5));
  CHECK(fresnel(std::cos(brewster_angle(2.42)), 1.0, 2.42).p == Approx(0.0).margin(1e-15));
  CHECK_FALSE(refraction_angle(radians(42.0), 1.5, 1.0));
  CHECK(fresnel(std::cos(radians(42.0)), 1.5, 1.0).mean() == 1.0);
  CHECK(fresnel(1e-9, 1.0, 1.0).mean() == 0.0);
}

TEST_CASE("Interfaces: reflectance is the same from both sides of a ray") {
  for (const double incidence : {0.1, 0.5, 1.0, 1.5}) {
    const double inside = *refraction_angle(incidence, 1.0, 1.5);
    const Reflectance from_air = fresnel(std::cos(incidence), 1.0, 1.5);
    const Reflectance from_glass = fresnel(std::cos(inside), 1.5, 1.0);
    CHECK(from_air.s == Approx(from_glass.s).epsilon(1e-12));
    CHECK(from_air.p == Approx(from_glass.p).epsilon(1e-9));
  }
}

TEST_CASE("Refraction of directions agrees with the textbook form and is exact at equal indices") {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 0.9, -0.2));
  const glm::dvec3 d = glm::normalize(glm::dvec3(0.4, -0.8, 0.5));
  for (const double n : {1.0003, 1.33, 1.5, 2.42}) {
    const glm::dvec3 t = *refract_direction(d, normal, 1.0 / n);
    CHECK(glm::length(t - bent(d, normal, 1.0, n)) < 1e-14);
  }
  const glm::dvec3 grazing = glm::normalize(glm::dvec3(1.0, -1e-9, 0.0));
  CHECK(glm::length(*refract_direction(grazing, {0.0, 1.0, 0.0}, 1.0) - grazing) < 1e-16);
  CHECK_FALSE(refract_direction(grazing, {0.0, 1.0, 0.0}, 1.5));
}

TEST_CASE("Absorption of glTF's volume leaves the colour after its distance") {
  CHECK(beer_lambert(absorption_of(0.3, 0.25), 0.25) == Approx(0.3).epsilon(1e-14));
  CHECK(beer_lambert(0.0, 7.0) == 1.0);
}

TEST_CASE("Sphere: landing agrees with a traced ray, its derivative with differences") {
  for (const double n : {0.75, 1.33, 1.5, 2.42}) {
    const GlassSphere s{.radius = 1.3, .index = n, .distance = 2.2};
    for (int i = 0; i < 40; ++i) {
      const double b = s.largest_impact() * 0.995 * i / 40.0;
      CHECK(s.landing(b) == Approx(traced_sphere_landing(b, s)).margin(1e-11));
      CHECK(s.landing_derivative(b) ==
            Approx(slope_of([&](double x) { return s.landing(std::fabs(x)) * (x < 0 ? -1 : 1); }, b))
                .epsilon(1e-5));
    }
  }
}

TEST_CASE("Sphere: foci, folds and the rays that never arrive") {
  const GlassSphere s{.radius = 1.0, .index = 1.5, .distance = 1.2};
  CHECK(s.paraxial_focus() == Approx(1.5).epsilon(1e-14));
  CHECK(s.axis_crossing(1e-6) == Approx(1.5).epsilon(1e-9));
  CHECK(s.marginal_focus() == Approx(1.00623).margin(1e-5));
  CHECK(s.axis_crossing(1.0 - 1e-12) == Approx(s.marginal_focus()).margin(1e-5));
  CHECK(s.landing_derivative(0.52281) == Approx(0.0).margin(1e-4));
  CHECK(std::fabs(s.landing(0.52281)) == Approx(0.074023).margin(1e-6));
  CHECK(s.landing(0.80033) == Approx(0.0).margin(1e-5));
  CHECK(s.largest_impact() == Approx(0.99837).margin(1e-5));
  CHECK(degrees(s.deviation(1.0)) == Approx(96.4).margin(0.05));
  CHECK(s.chord(0.5) == Approx(2.0 * std::cos(std::asin(0.5 / 1.5))).epsilon(1e-14));
  // Rays that bend at the entry only, traced.
  const double b = 0.6;
  const glm::dvec3 entry(b, 0.0, 0.8);
  const glm::dvec3 inside = bent({0.0, 0.0, -1.0}, entry, 1.0, 1.5);
  const double traced = entry.x + inside.x * (-s.distance - entry.z) / inside.z;
  CHECK(s.single_surface_landing(b) == Approx(traced).epsilon(1e-13));
}

TEST_CASE("Sphere: irradiance on the plane without losses") {
  const GlassSphere s{.radius = 1.3, .index = 1.5, .distance = 2.2, .loss = InterfaceLoss::None};
  CHECK(s.irradiance(0.165) == Approx(7.774).margin(1e-3));
  CHECK(s.irradiance(0.315) == Approx(2.610).margin(1e-3));
  CHECK(s.irradiance(0.615) == Approx(0.665).margin(1e-3));
  CHECK(s.irradiance(0.915) == Approx(0.2531).margin(1e-4));
}

TEST_CASE("Sphere: shares of the flux over the whole disc") {
  const auto share = [](double n, InterfaceLoss loss) {
    return GlassSphere{.index = n, .loss = loss}.transmitted_share();
  };
  CHECK(share(1.33, InterfaceLoss::Unpolarised) == Approx(0.88230).margin(1e-5));
  CHECK(share(1.5, InterfaceLoss::Unpolarised) == Approx(0.83554).margin(1e-5));
  CHECK(share(2.42, InterfaceLoss::Unpolarised) == Approx(0.62645).margin(1e-5));
  CHECK(share(1.5, InterfaceLoss::Polarised) == Approx(0.84061).margin(1e-5));
  CHECK(share(1.0, InterfaceLoss::Unpolarised) == Approx(1.0).epsilon(1e-9));
  // A bubble of air in water: light beyond b = n R is totally reflected.
  CHECK(share(1.0 / 1.33, InterfaceLoss::None) == Approx(1.0 - 0.4347).margin(1e-3));
  CHECK(mean_absorption({.index = 1.5, .absorption = 0.8}) == Approx(0.246768).margin(1e-6));
}

TEST_CASE("A disc's area inside a box") {
  CHECK(disc_in_box(1.0, {-2.0, -2.0}, {2.0, 2.0}) == Approx(kPi).epsilon(1e-14));
  CHECK(disc_in_box(1.0, {0.0, -2.0}, {2.0, 0.0}) == Approx(kPi / 4).epsilon(1e-14));
  CHECK(disc_in_box(2.0, {0.1, 0.2}, {0.4, 0.3}) == Approx(0.03).epsilon(1e-13));
  CHECK(disc_in_box(0.2, {0.3, 0.3}, {0.4, 0.4}) == Approx(0.0).margin(1e-16));
  CHECK(disc_in_box(1.0, {0.5, -2.0}, {2.0, 2.0}) == Approx(kPi / 3 - std::sqrt(3.0) / 4).epsilon(1e-13));
}

TEST_CASE("Sphere: pixel means agree with the profile, with traced rays, and keep the flux") {
  for (const double distance : {1.2, 1.5, 2.2}) {  // a fold ring; the paraxial focus; beyond it
    const GlassSphere s{.radius = 1.0, .index = 1.5, .distance = distance};
    const FloorSquare floor{.lower = glm::dvec2(-0.5), .side = 1.0, .pixels = 40};
    const FloorIrradiance exact = irradiance_average(s, floor);
    CHECK(sum_of(exact.values) * 0.025 * 0.025 == Approx(exact.flux).epsilon(1e-12));

    // Rays on a jittered grid over the sphere's disc, traced.
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> jitter(0.0, 1.0);
    constexpr int kSide = 2000;
    std::vector<double> traced(1600, 0.0);  // 40 x 40 pixels
    double flux = 0.0;
    const double largest = s.largest_impact();
    for (int i = 0; i < kSide * kSide; ++i) {
      const int column = i % kSide, row = i / kSide;
      const double x = 2.0 * (column + jitter(random)) / kSide - 1.0;
      const double y = 2.0 * (row + jitter(random)) / kSide - 1.0;
      const double b = std::hypot(x, y);
      if (b >= largest || b == 0.0) continue;
      const double scale = traced_sphere_landing(b, s) / b;
      const int px = static_cast<int>(std::floor((x * scale + 0.5) * 40.0));
      const int py = static_cast<int>(std::floor((y * scale + 0.5) * 40.0));
      if (px < 0 || px >= 40 || py < 0 || py >= 40) continue;
      const double amount = 4.0 / (double(kSide) * kSide) * s.transmittance(b);
      traced[static_cast<std::size_t>(py) * 40 + static_cast<std::size_t>(px)] += amount / (0.025 * 0.025);
      flux += amount;
    }
    CHECK(exact.flux == Approx(flux).epsilon(5e-4));
    double difference = 0.0;
    for (std::size_t k = 0; k < traced.size(); ++k) difference += std::fabs(traced[k] - exact.values[k]);
    CHECK(difference / sum_of(exact.values) < 0.004);  // the noise of four million rays
  }
  const GlassSphere s{.radius = 1.0, .index = 1.5, .distance = 2.2};
  CHECK(annulus_average(s, 0.3, 0.3002) == Approx(s.irradiance(0.3001)).epsilon(1e-3));
  const FloorIrradiance one = irradiance_average(s, {glm::dvec2(0.3, 0.3), 1e-3, 1}, 64);
  CHECK(one.values[0] == Approx(s.irradiance(0.3005 * std::numbers::sqrt2)).epsilon(2e-3));
}

TEST_CASE("Sphere: all flux that is not sent beyond the square lies in it") {
  const GlassSphere s{.radius = 0.5, .index = 1.5, .distance = 0.8};
  // Rays near the rim go far: 1 % of the flux lands more than a metre from the axis.
  const double share = kPi * 0.25 * s.transmitted_share();
  CHECK(irradiance_average(s, {.pixels = 16}).flux < 0.99 * share);
  CHECK(irradiance_average(s, {glm::dvec2(-50.0), 100.0, 16}).flux == Approx(share).epsilon(1e-3));
  const GlassSphere air{.radius = 0.5, .index = 1.0, .distance = 0.8};
  const FloorIrradiance shadow = irradiance_average(air, {.pixels = 20});
  CHECK(shadow.flux == Approx(kPi * 0.25).epsilon(1e-9));
  CHECK(shadow.values[10 * 20 + 10] == Approx(1.0).epsilon(1e-9));
  CHECK(shadow.values[0] == 0.0);
}

TEST_CASE("Sphere: however few rings of rays are counted, they keep the flux") {
  const GlassSphere s{.radius = 1.0, .index = 1.33, .distance = 1.6, .loss = InterfaceLoss::None};
  for (const int rings : {1, 2, 5, 50})  // the farthest land 5 m from the axis
    CHECK(annulus_average(s, 0.0, 10.0, rings) * 100.0 == Approx(1.0).epsilon(1e-9));
}

TEST_CASE("Sphere: a ring of rays whose light crosses the axis lies evenly on both sides of it") {
  const GlassSphere s{.radius = 1.0, .index = 1.5, .distance = 1.2, .loss = InterfaceLoss::None};
  // Of four rings the first lands from the axis to `first`, the third from `inner` to beyond the axis; the
  // others farther away than 50 mm.
  const double end = std::asin(s.largest_impact());
  const auto impact = [&](int i) { return std::sin(end * i / 4.0); };
  const double first = s.landing(impact(1)), inner = s.landing(impact(2)), outer = s.landing(impact(3));
  REQUIRE(std::min({first, inner, -outer, -s.landing(impact(4))}) > 0.05);
  const auto flux = [&](int i) { return kPi * (std::pow(impact(i), 2.0) - std::pow(impact(i - 1), 2.0)); };
  const double expected = flux(1) * 0.05 / first + flux(3) * 0.1 / (inner - outer);
  CHECK(annulus_average(s, 0.0, 0.05, 4) * kPi * 0.05 * 0.05 == Approx(expected).epsilon(1e-9));
}

TEST_CASE("Sphere: a smaller one is the same in small, and a bubble's last ray has no way inside it") {
  for (const double n : {0.75, 1.33, 1.5, 2.42}) {
    const GlassSphere large{.radius = 1.0, .index = n}, small{.radius = 0.01, .index = n};
    CHECK(small.largest_impact() == Approx(0.01 * large.largest_impact()).epsilon(1e-12));
    CHECK(small.chord(0.006) == Approx(0.01 * large.chord(0.6)).epsilon(1e-12));
  }
  const GlassSphere bubble{.radius = 1.0, .index = 0.75};
  CHECK(bubble.chord(bubble.largest_impact()) == Approx(0.0).margin(1e-7));
}

TEST_CASE("Water: landing, derivative and first focus") {
  const WaterWave w{.amplitude = 0.02, .wave_number = 9.5, .index = 1.33, .depth = 1.2};
  for (double x = -0.4; x < 0.4; x += 0.013) {
    CHECK(w.landing(x) == Approx(traced_water_landing(x, w)).margin(1e-13));
    CHECK(w.landing_derivative(x) ==
          Approx(slope_of([&](double t) { return w.landing(t); }, x)).margin(1e-7));
  }
  // At the first focus below a crest the rays of the crest meet.
  WaterWave focused = w;
  focused.depth = w.first_focus() - w.amplitude;
  CHECK(focused.landing_derivative(0.0) == Approx(0.0).margin(1e-12));
  CHECK(focused.landing_derivative(0.01) > 0.0);
}

TEST_CASE("Water: strip means keep the flux, before and behind the focus") {
  WaterWave w{.amplitude = 0.3 / 12.0, .wave_number = 12.0, .index = 1.33};
  const double period = 2.0 * kPi / 12.0;
  for (const double share : {0.6, 1.0, 1.7}) {
    w.depth = share * w.first_focus();
    w.fresnel = false;
    const std::vector<double> strips = irradiance_average(w, -period / 2, period / 2, 64);
    CHECK(sum_of(strips) / 64.0 == Approx(1.0).epsilon(1e-5));
    if (share < 1.0) {
      const std::vector<double> narrow = irradiance_average(w, -1e-4, 1e-4, 1);
      CHECK(narrow[0] == Approx(w.irradiance(0.0)).epsilon(1e-4));
      CHECK(strips[32] > strips[0]);  // bright under the crest
    }
  }
  w.amplitude = 0.0;
  CHECK(irradiance_average(w, -1.0, 1.0, 8, 0.5)[1] == Approx(0.0).margin(1e-12));
  CHECK(irradiance_average(w, -1.0, 1.0, 8, 0.5)[3] == Approx(1.0).epsilon(1e-9));
}

TEST_CASE("Slab: shift and transmittance") {
  CHECK(slab_offset(radians(40.0), 1.5, 0.7) == Approx(0.195628).margin(1e-6));
  CHECK(slab_floor_shift(radians(40.0), 1.5, 0.7) == Approx(0.255375).margin(1e-6));
  CHECK(slab_floor_shift(radians(40.0), 1.0, 0.7) == Approx(0.0).margin(1e-15));
  CHECK(slab_transmittance(0.0, 1.5, 0.3) == Approx(0.96 * 0.96).epsilon(1e-12));
  CHECK(slab_transmittance_all_bounces(0.0, 1.5) == Approx(0.96 / 1.04).epsilon(1e-12));
  const double inside = *refraction_angle(0.7, 1.0, 1.5);
  CHECK(slab_transmittance(0.7, 1.5, 0.3, 2.0) / slab_transmittance(0.7, 1.5, 0.3) ==
        Approx(std::exp(-0.6 / std::cos(inside))).epsilon(1e-12));
}

TEST_CASE("A point light over flat water") {
  const LightOverWater l{.height = 0.8, .depth = 1.1, .index = 1.33};
  CHECK(l.irradiance(1e-5) == Approx(l.irradiance(0.0)).epsilon(1e-8));
  // Flux through a cone lands in a disc: the integral of E 2 pi X dX is that of T 2 pi sin dtheta.
  double landed = 0.0, sent = 0.0;
  constexpr int kSteps = 4000;
  for (int i = 0; i < kSteps; ++i) {
    const double t0 = 1.2 * i / kSteps, t1 = 1.2 * (i + 1) / kSteps, t = 0.5 * (t0 + t1);
    const double x0 = l.landing(t0), x1 = l.landing(t1);
    landed += l.irradiance(t) * kPi * (x1 - x0) * (x1 + x0);
    sent += (1.0 - fresnel(std::cos(t), 1.0, 1.33).mean()) * 2 * kPi * (std::cos(t0) - std::cos(t1));
  }
  CHECK(landed == Approx(sent).epsilon(1e-6));
}

TEST_CASE("Prism: deviation, its minimum, and colours") {
  const double apex = radians(60.0);
  CHECK(degrees(*prism_deviation(apex, 1.5, radians(50.0))) == Approx(37.20931515808));
  CHECK(degrees(prism_least_deviation(apex, 1.5)) == Approx(37.1808).margin(1e-4));
  CHECK(degrees(prism_least_incidence(apex, 1.5)) == Approx(27.92).margin(0.005));
  CHECK_FALSE(prism_deviation(apex, 1.5, radians(27.9)));
  for (const double incidence : {30.0, 48.6, 50.0, 75.0})
    CHECK(*prism_deviation(apex, 1.5, radians(incidence)) ==
          Approx(traced_prism_deviation(apex, 1.5, radians(incidence))).epsilon(1e-9));
  CHECK(bk7_index(0.4861) == Approx(1.522376).margin(2e-6));
  CHECK(bk7_index(0.5876) == Approx(1.516800).margin(2e-6));
  CHECK(bk7_index(0.6563) == Approx(1.514322).margin(2e-6));
  CHECK(degrees(*prism_deviation(apex, 1.522376, radians(50.0))) == Approx(39.1410).margin(1e-4));
  CHECK(degrees(*prism_deviation(apex, 1.514322, radians(50.0))) == Approx(38.4384).margin(1e-4));
  // The Cauchy formula has the index at the d line and the Abbe number between F and C.
  const double f = dispersive_index(1.5168, 20.0 / 64.17, 486.1);
  const double d = dispersive_index(1.5168, 20.0 / 64.17, 587.6);
  const double c = dispersive_index(1.5168, 20.0 / 64.17, 656.3);
  CHECK(d == Approx(1.5168).margin(1e-5));
  CHECK((d - 1.0) / (f - c) == Approx(64.17).epsilon(2e-3));
}

TEST_CASE("Ring: envelope, cusp and floor irradiance") {
  CHECK(glm::length(ring_envelope(2.0, 0.0) - glm::dvec2(1.0, 0.0)) < 1e-15);
  CHECK(ring_axis_crossing(2.0, 0.0) == 1.0);
  // Each reflected ray touches the envelope: the envelope's tangent runs along it, through the
  // point.
  for (const double t : {0.2, 0.7, 1.2}) {
    const glm::dvec2 wall = 2.0 * glm::dvec2(std::cos(t), std::sin(t));
    const glm::dvec2 ray(-std::cos(2 * t), -std::sin(2 * t));
    const glm::dvec2 to = ring_envelope(2.0, t) - wall;
    CHECK(to.x * ray.y - to.y * ray.x == Approx(0.0).margin(1e-14));
    const glm::dvec2 along = ring_envelope(2.0, t + 1e-5) - ring_envelope(2.0, t - 1e-5);
    CHECK(std::fabs(along.x * ray.y - along.y * ray.x) < 1e-8);
    const double crossing = wall.x - wall.y * ray.x / ray.y;
    CHECK(ring_axis_crossing(2.0, t) == Approx(crossing).epsilon(1e-12));
  }
  // Jacobian of (t, s) -> place on the floor, by differences; R cos(t) is that of the incoming
  // light.
  const auto place = [](double t, double s) {
    return 2.0 * glm::dvec2(std::cos(t), std::sin(t)) - s * glm::dvec2(std::cos(2 * t), std::sin(2 * t));
  };
  const double t = 0.4, s = 0.5, step = 1e-6;
  const glm::dvec2 by_t = (place(t + step, s) - place(t - step, s)) / (2 * step);
  const glm::dvec2 by_s = (place(t, s + step) - place(t, s - step)) / (2 * step);
  const double area = std::fabs(by_t.x * by_s.y - by_t.y * by_s.x);
  CHECK(ring_irradiance(2.0, t, s) == Approx(2.0 * std::cos(t) / area).epsilon(1e-8));
}

TEST_CASE("A hyperbolic lens sends every ray to one point") {
  const HyperbolicLens lens{.index = 1.5, .focus = 2.0};
  for (const double r : {0.1, 0.5, 1.0, 1.6}) {
    const double z = lens.surface(r);
    CHECK(r * r == Approx(1.25 * z * z + 2.0 * 0.5 * 2.0 * -z).epsilon(1e-13));
    const double dz = slope_of([&](double x) { return lens.surface(x); }, r);
    const glm::dvec3 out = bent({0.0, 0.0, 1.0}, glm::normalize(glm::dvec3(-dz, 0.0, 1.0)), 1.5, 1.0);
    CHECK(r + out.x * (2.0 - z) / out.z == Approx(0.0).margin(1e-8));
    CHECK(lens.landing(r, 1.2) == Approx(r + out.x * (1.2 - z) / out.z).epsilon(1e-8));
    const double slope = slope_of([&](double x) { return lens.landing(x, 1.2); }, r);
    CHECK(lens.irradiance(r, 1.2) == Approx(r / (lens.landing(r, 1.2) * slope)).epsilon(1e-7));
  }
  CHECK(lens.irradiance(0.0, 1.2) == Approx(6.25).epsilon(1e-12));
  CHECK(lens.irradiance(1e-4, 1.2) == Approx(6.25).epsilon(1e-6));
}
