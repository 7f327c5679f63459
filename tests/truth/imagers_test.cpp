// Surfaces without aberration: parallel light meets in one point, so all that a spot has of size
// comes from the tessellation and the maps.
#include "lab/reference/imagers.hpp"

#include <algorithm>
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/revolved.hpp"
#include "tests/truth/rows.hpp"

namespace caustics::test {

namespace {

constexpr double kPi = 3.14159265358979323846;

// How finely a scene is cut up.
struct Fineness {
  int grid = 256, rings = 64;
  int sectors() const { return 4 * rings; }
  std::string text() const {
    return "grid = map " + std::to_string(grid) + ", " + std::to_string(rings) + " rings of " +
           std::to_string(sectors()) + " facets";
  }
};

// A scene in which light along -y that meets the caster at r from the axis lands at landing(r).
struct Imager {
  Scene scene;
  double inner = 0.0, outer = 0.3;  // of what is compared, metres
  double lever = 1.0;               // most from the surface to the floor, metres
  // Of the surface at r: its height, the r component of its unit normal, and by how much the
  // landing turns with the normal, radians a radian.
  std::function<double(double)> height, tilt;
  double turn = 1.0, steepest = 0.0;  // of the ray that leaves, tan from the vertical
  std::function<double(double)> landing;
  double texel = 0.0;  // of the maps that hold the bending surface, metres, where they interpolate it
};

void add_floor_and_light(Imager& imager, double half) {
  imager.scene.materials.insert(imager.scene.materials.begin(), diffuse(0.8f));
  imager.scene.meshes.insert(imager.scene.meshes.begin(), floor(half, 0.0, 0));
  imager.scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
}

std::function<double(double)> tilt_of(std::function<double(double)> slope) {
  return [slope](double r) { return slope(r) / std::sqrt(1.0 + slope(r) * slope(r)); };
}

// Flat above, hyperboloid below, its vertex `plane` metres above the floor; focus at 1 m.
Imager hyperbolic_lens(double plane, const Fineness& fine) {
  const HyperbolicLens lens{.index = 1.5, .focus = 1.0};
  const double radius = 0.3, rim = plane - lens.surface(radius), top = rim + 0.02;
  Imager imager;
  imager.outer = 0.97 * radius;  // within texels of the rim the wall's normals mix in
  imager.landing = [=](double r) { return lens.landing(r, plane); };
  imager.height = [=](double r) { return plane - lens.surface(r); };
  imager.tilt = tilt_of([=](double r) { return lens.slope(r); });
  Mesh mesh;
  mesh.name = "lens";
  mesh.material = 1;
  const auto flat = [&](double r) { return ProfilePoint{r, top, 0.0, 1.0}; };
  revolve(mesh, profile(0.0, radius, 1, flat), fine.sectors());
  revolve(mesh, {{radius, top, 1.0, 0.0}, {radius, rim, 1.0, 0.0}}, fine.sectors());
  const auto exit = [&](double r) { return ProfilePoint{r, imager.height(r), -lens.slope(r), -1.0}; };
  revolve(mesh, profile(0.0, radius, fine.rings, exit), fine.sectors());
  finish(mesh, 1.0f);
  imager.scene.materials = {glass(1.5f)};
  imager.scene.meshes = {mesh};
  // Snell: n cos(inside) / cos(outside) - 1, largest at the rim.
  const double inside = std::atan(-lens.slope(radius)), outside = std::asin(1.5 * std::sin(inside));
  imager.turn = 1.5 * std::cos(inside) / std::cos(outside) - 1.0;
  imager.steepest = std::tan(outside - inside);
  imager.lever = rim;
  imager.texel = 2.0 * radius / fine.grid;
  add_floor_and_light(imager, 1.0);
  return imager;
}

// An open sheet over a floor within the glass, its vertex `plane` metres above it; focus at 1 m.
Imager ellipsoidal_entry(double plane, const Fineness& fine) {
  const EllipsoidalEntry face{.index = 1.5, .focus = 1.0};
  const double radius = 0.3;
  Imager imager;
  imager.outer = radius;
  imager.landing = [=](double r) { return face.landing(r, plane); };
  imager.height = [=](double r) { return plane - face.surface(r); };
  imager.tilt = tilt_of([=](double r) { return face.slope(r); });
  Mesh mesh;
  mesh.name = "entry face";
  mesh.material = 1;
  const auto entry = [&](double r) { return ProfilePoint{r, imager.height(r), face.slope(r), 1.0}; };
  revolve(mesh, profile(0.0, radius, fine.rings, entry), fine.sectors());
  finish(mesh, 0.0f);
  imager.scene.materials = {glass(1.5f)};
  imager.scene.meshes = {mesh};
  const double outside = std::atan(face.slope(radius)), inside = std::asin(std::sin(outside) / 1.5);
  imager.turn = 1.0 - std::cos(outside) / (1.5 * std::cos(inside));
  imager.steepest = std::tan(outside - inside);
  imager.lever = plane;
  add_floor_and_light(imager, 1.0);
  return imager;
}

// The rim of a bowl, r from 0.75 to 1 m, so far out that what it mirrors comes down to the focus
// 0.25 m above the bowl's vertex. The floor lies `plane` metres above the vertex.
Imager paraboloid(double plane, const Fineness& fine) {
  const ParaboloidMirror bowl{.focus = 0.25};
  const double inner = 0.75, outer = 1.0;
  Imager imager;
  imager.inner = inner;
  imager.outer = outer;
  imager.landing = [=](double r) { return bowl.landing(r, plane); };
  imager.height = [=](double r) { return bowl.surface(r) - plane; };
  imager.tilt = tilt_of([=](double r) { return bowl.slope(r); });
  Mesh mesh;
  mesh.name = "bowl";
  mesh.material = 1;
  const auto wall = [&](double r) { return ProfilePoint{r, imager.height(r), -bowl.slope(r), 1.0}; };
  revolve(mesh, profile(inner, outer, fine.rings, wall), fine.sectors());
  finish(mesh, 0.0f);
  imager.scene.materials = {metal(glm::vec3(1.0f))};
  imager.scene.meshes = {mesh};
  imager.turn = 2.0;
  imager.steepest = inner / (bowl.surface(inner) - 0.25);
  imager.lever = bowl.surface(outer) - plane;
  add_floor_and_light(imager, 1.2);
  return imager;
}

// What straight lines between vertices, and between texels where a map of the surface is
// interpolated, do to a landing: the normal's error turns the ray, the height's error moves it
// along.
double landing_bound(const Imager& i, const Fineness& fine) {
  const double ring = (i.outer - i.inner) / fine.rings;
  const double step = 2.0 * kPi / fine.sectors(), sagitta = i.outer * step * step / 8.0;
  double normal = linear_error(i.tilt, i.inner, i.outer, ring);
  double height = linear_error(i.height, i.inner, i.outer, ring);
  if (i.texel > 0.0) {
    // The texels' diagonal.
    normal += linear_error(i.tilt, i.inner, i.outer, 1.5 * i.texel);
    height += linear_error(i.height, i.inner, i.outer, 1.5 * i.texel);
  }
  // Between two sectors the facet's middle is nearer to the axis by the sagitta, with the tilt
  // shrunk as much.
  const double r = i.outer, small = 1e-4 * r;
  const double tilt_slope = (i.tilt(r) - i.tilt(r - small)) / small;
  const double height_slope = std::fabs(i.height(r) - i.height(r - small)) / small;
  normal += std::fabs(i.tilt(r) / r - tilt_slope) * sagitta;
  height += height_slope * sagitta;
  const double cosine = std::sqrt(1.0 - i.tilt(r) * i.tilt(r));
  const double slant = 1.0 + i.steepest * i.steepest;
  return i.lever * slant * i.turn * normal / cosine + i.steepest * height + 16.0 * kUlp * i.lever * slant;
}

struct Landings {
  double worst = 0.0;                       // distance from the closed form's landing, metres
  double spread = 0.0;                      // root mean square of the same
  int lost = 0, compared = 0, outside = 0;  // rays; outside: of the map's window
};

Landings compare(const Imager& imager, const Rendering& r) {
  const Image& landing = r[light_texture(kLanding, 0)];
  const Image& entry = r[light_texture("caster_position", 0)];
  Landings found;
  double sum = 0.0;
  for (int y = 0; y < landing.height(); ++y)
    for (int x = 0; x < landing.width(); ++x) {
      if (entry.at(x, y, 3) == 0.0f) continue;
      const glm::dvec2 p{entry.at(x, y, 0), entry.at(x, y, 2)};
      const double from_axis = glm::length(p);
      if (from_axis > imager.outer || from_axis < imager.inner || from_axis == 0.0) continue;
      ++found.compared;
      const float status = landing.at(x, y, 3);
      if (status == float(LandingStatus::Outside)) {
        ++found.outside;
      } else if (status != float(LandingStatus::Landed)) {
        ++found.lost;
        continue;
      }
      const glm::dvec2 expected = p / from_axis * imager.landing(from_axis);
      const glm::dvec2 at{landing.at(x, y, 0), landing.at(x, y, 2)};
      const double off = glm::length(at - expected);
      found.worst = std::max(found.worst, off);
      sum += off * off;
    }
  found.spread = std::sqrt(sum / std::max(1, found.compared - found.lost));
  return found;
}

Landings measure(const Bench& bench, const Imager& imager, const Fineness& fine) {
  Settings settings = small_settings(fine.grid, fine.grid, 8);
  const Landings found = compare(imager, bench.render(imager.scene, settings, {kLanding, kCausticMap}));
  INFO(found.lost << " of " << found.compared << " rays did not land");
  CHECK(found.compared > fine.grid);
  CHECK(found.lost == 0);
  // At a focus the map's window shrinks to the spot, of which it may leave out this share.
  CHECK(found.outside <= settings.outside_share * found.compared);
  return found;
}

using MakeImager = Imager (*)(double plane, const Fineness&);

void add_rows(const Bench& bench, MakeImager make, const std::string& name, const std::vector<double>& planes,
              double focus, Rows& rows) {
  const Fineness fine{.grid = bench.full ? 512 : 256, .rings = bench.full ? 128 : 64};
  for (const double plane : planes) {
    const Imager imager = make(plane, fine);
    const Landings found = measure(bench, imager, fine);
    char text[64];
    std::snprintf(text, sizeof text, "landing radius, floor at %.2f m, worst, m", plane);
    rows.push_back({name, text, found.worst, landing_bound(imager, fine), fine.text()});
  }
  for (const Fineness& f : {Fineness{fine.grid / 2, fine.rings / 2}, Fineness{fine.grid, fine.rings / 2},
                            Fineness{fine.grid / 2, fine.rings}, fine}) {
    const Imager imager = make(focus, f);
    const Landings found = measure(bench, imager, f);
    rows.push_back({name, "spot at the focus, root mean square radius, m", found.spread,
                    landing_bound(imager, f), f.text()});
  }
}

// ---- Irradiance behind the hyperbolic lens, halfway to its focus.

Row lens_irradiance(const Bench& bench) {
  const double plane = 0.5;
  const Fineness fine{.grid = bench.full ? 512 : 256, .rings = bench.full ? 128 : 64};
  Imager imager = hyperbolic_lens(plane, fine);
  const HyperbolicLens lens{.index = 1.5, .focus = 1.0};
  const double reach = lens.landing(0.27, plane);
  imager.scene.cameras = {camera_down(0.25, 1.2 * reach)};
  Settings settings = small_settings(fine.grid, fine.grid, bench.full ? 64 : 32);
  const Rendering r = bench.render(imager.scene, settings, {"aov_caustic"});
  const auto truth = [&](double landed) {
    double low = 0.0, high = 0.3;
    for (int i = 0; i < 60; ++i)
      (lens.landing(0.5 * (low + high), plane) < landed ? low : high) = 0.5 * (low + high);
    const double passed = 0.96 * (1.0 - fresnel(std::cos(std::atan(lens.slope(low))), 1.5, 1.0).mean());
    return passed * lens.irradiance(low, plane);
  };
  const double texel = texel_on_floor(imager.scene, r, settings);
  std::vector<double> picture, exact, shifted;
  for (int y = 0; y < settings.height; ++y)
    for (int x = 0; x < settings.width; ++x) {
      const glm::dvec2 p = 1.2 * reach * (2.0 * (glm::dvec2(x, y) + 0.5) / double(settings.width) - 1.0);
      const double landed = glm::length(p);
      if (landed > reach) continue;
      picture.push_back(double(r["aov_caustic"].at(x, y, 0)));
      exact.push_back(truth(landed));
      shifted.push_back(truth(landed + texel));
    }
  return {"hyperbolic lens", "irradiance, floor at half the focus, relative L1", relative_l1(picture, exact),
          relative_l1(shifted, exact), fine.text()};
}

}  // namespace

Rows imager_rows(const Bench& bench) {
  Rows rows;
  add_rows(bench, hyperbolic_lens, "hyperbolic lens", {0.25, 0.5, 0.75, 1.0, 1.5}, 1.0, rows);
  rows.push_back(lens_irradiance(bench));
  add_rows(bench, ellipsoidal_entry, "ellipsoidal entry", {0.5, 1.0, 1.5}, 1.0, rows);
  add_rows(bench, paraboloid, "paraboloid mirror", {0.25, 0.1}, 0.25, rows);
  return rows;
}

}  // namespace caustics::test

TEST_CASE("truth: lens, entry face and mirror without aberration send light to a point") {
  // Bounds: what straight lines between vertices and between texels of the exit map account for.
  caustics::test::check_rows(caustics::test::imager_rows);
}
