// Shapes recognised from meshes, and met in double precision.
#include "lab/reference/tracer/exact_shapes.hpp"

#include <cmath>
#include <limits>

#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

namespace caustics::tracer {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// A scene of one mesh.
Scene scene_of(Mesh mesh) {
  Scene scene;
  scene.meshes = {std::move(mesh)};
  return scene;
}

template <class Shape>
Shape shape_of(const Mesh& mesh, ShapeKind kind) {
  return std::get<Shape>(exact_shape_of(scene_of(mesh), 0, kind).form);
}

// The line with which a mesh is refused; empty where it is not.
std::string refusal(const Scene& scene, ShapeKind kind) {
  try {
    exact_shape_of(scene, 0, kind);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::BadInput);
    return error.what();
  }
  return {};
}

bool says(const std::string& line, const std::string& part) { return line.find(part) != std::string::npos; }

// Turned and moved, so that nothing lies along an axis of the scene.
Mesh turned(Mesh mesh) {
  const glm::dvec3 x = glm::normalize(glm::dvec3(0.6, 0.7, -0.2));
  const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(0.1, 0.2, 1.0), x)), z = glm::cross(x, y);
  for (Vertex& v : mesh.vertices) {
    const glm::dmat3 turn(x, y, z);
    v.position = glm::vec3(turn * glm::dvec3(v.position) + glm::dvec3(0.3, -0.2, 0.4));
    v.normal = glm::vec3(turn * glm::dvec3(v.normal));
  }
  test::finish(mesh, mesh.closedness);
  return mesh;
}

// 0, 1 but evenly between, and the same every time.
double number(int i, int which) { return std::fmod((i * 7 + which) * 0.6180339887498949, 1.0); }

// An upright wall around the y axis without lids, whose vertices stand at these angles, in degrees.
Mesh wall_of(const std::vector<double>& degrees, double radius, double height) {
  Mesh mesh;
  mesh.name = "wall";
  for (const double each : degrees) {
    const double angle = each * 3.14159265358979323846 / 180.0;
    const glm::dvec3 out(std::cos(angle), 0.0, std::sin(angle));
    for (const double y : {0.0, height})
      mesh.vertices.push_back(
          {.position = glm::vec3(radius * out + glm::dvec3(0.0, y, 0.0)), .normal = glm::vec3(out)});
  }
  const auto count = static_cast<std::uint32_t>(degrees.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % count);
    for (const std::uint32_t v : {a, a + 1, b + 1, a, b + 1, b}) mesh.indices.push_back(v);
  }
  test::finish(mesh, 0.0f);
  return mesh;
}

}  // namespace

TEST_CASE("exact shapes: a sphere's middle and radius are those of its mesh, and a floor is none") {
  const auto sphere = shape_of<ExactSphere>(test::sphere({0.0, 0.8, 0.0}, 0.5, 2, 0), ShapeKind::Sphere);
  CHECK(sphere.radius == Approx(0.5).epsilon(1e-6));
  CHECK(sphere.centre.y == Approx(0.8).epsilon(1e-6));
  const auto met = sphere.nearest({{0.0, 3.0, 0.0}, {0.0, -1.0, 0.0}}, 0.0, kFar);
  REQUIRE(met);
  CHECK(met->front);
  CHECK(met->distance == Approx(1.7).epsilon(1e-6));
  CHECK_FALSE(sphere.nearest({{0.0, 3.0, 0.0}, {0.0, -1.0, 0.0}}, 1.8, kFar)->front);
  CHECK(says(refusal(scene_of(test::floor(1.0, 0.0, 0)), ShapeKind::Sphere), "'floor' is no sphere"));
}

TEST_CASE("exact shapes: a coarse ring has the walls and lids of a tube, whichever way it lies") {
  const auto ring = shape_of<ExactCylinder>(turned(test::ring(0.5, 0.54, 0.18, 24, 0)), ShapeKind::Cylinder);
  REQUIRE(ring.walls.size() == 2);
  CHECK(ring.walls[0].radius == Approx(0.54).epsilon(1e-6));
  CHECK(ring.walls[1].radius == Approx(0.5).epsilon(1e-6));
  CHECK(ring.walls[0].outward == 1.0);
  CHECK(ring.walls[1].outward == -1.0);
  CHECK(ring.height == Approx(0.18).epsilon(1e-6));
  CHECK(ring.lower_lid);
  CHECK(ring.upper_lid);
  CHECK(ring.least_cosine == -2.0);
  // Through the axis half-way up: outer wall, inner wall, and both again, turn by turn from outside and from
  // within.
  const glm::dvec3 middle = ring.foot + ring.axis * 0.09;
  const Ray ray{middle - 2.0 * ring.middle, ring.middle};
  double from = 0.0;
  for (const double expected : {1.46, 1.5, 2.5, 2.54}) {
    const auto met = ring.nearest(ray, from, kFar);
    REQUIRE(met);
    CHECK(met->distance == Approx(expected).epsilon(1e-6));
    CHECK(met->front == (expected == 1.46 || expected == 2.5));
    CHECK(glm::length(glm::cross(met->normal, ring.middle)) < 1e-12);
    from = met->distance + 1e-9;
  }
  CHECK_FALSE(ring.nearest(ray, from, kFar));
}

TEST_CASE("exact shapes: a tube has no gap at its rims, and light that enters it leaves it") {
  const auto ring = shape_of<ExactCylinder>(turned(test::ring(0.2, 0.54, 0.18, 48, 0)), ShapeKind::Cylinder);
  const glm::dvec3 across = glm::cross(ring.axis, ring.middle);
  for (int i = 0; i < 2000; ++i) {
    // From all around to within the body, some to its very rims.
    const double turn = 6.2831853 * number(i, 0), radius = i % 2 ? 0.54 : 0.2 + 0.34 * number(i, 1);
    const glm::dvec3 out = ring.middle * std::cos(turn) + across * std::sin(turn);
    const glm::dvec3 inside = ring.foot + out * (radius - 1e-7) + ring.axis * (0.18 * number(i, 2));
    const glm::dvec3 origin =
        inside + 3.0 * glm::dvec3(number(i, 3) - 0.5, number(i, 4) - 0.5, number(i, 5) - 0.5);
    const Ray ray{origin, glm::normalize(inside - origin)};
    int meetings = 0;
    bool in_turn = true;
    for (auto met = ring.nearest(ray, -kFar, kFar); met; met = ring.nearest(ray, met->distance + 1e-12, kFar))
      in_turn = in_turn && met->front == (meetings++ % 2 == 0);
    CHECK(in_turn);
    CHECK(meetings >= 2);
    CHECK(meetings % 2 == 0);
  }
}

TEST_CASE("exact shapes: a rod's lids are whole discs, and half a wall ends where its mesh does") {
  const auto rod = shape_of<ExactCylinder>(test::ring(0.0, 0.3, 1.0, 16, 0), ShapeKind::Cylinder);
  CHECK(rod.walls.size() == 1);
  CHECK(rod.nearest({{0.0, 2.0, 0.0}, {0.0, -1.0, 0.0}}, 0.0, kFar)->distance == Approx(1.0));
  const auto half = shape_of<ExactCylinder>(test::half_ring(1.0, 0.8, 16, 0), ShapeKind::Cylinder);
  CHECK(half.walls[0].outward == -1.0);
  CHECK(half.least_cosine == Approx(0.0).margin(1e-6));
  CHECK(half.nearest({{0.0, 0.4, 0.0}, {1.0, 0.0, 0.0}}, 0.0, kFar)->front);
  CHECK_FALSE(half.nearest({{0.0, 0.4, 0.0}, {-1.0, 0.0, 0.0}}, 0.0, kFar));
  CHECK_FALSE(half.nearest({{0.0, 0.9, 0.0}, {1.0, 0.0, 0.0}}, 0.0, kFar));
}

TEST_CASE("exact shapes: a wall's facets may reach over any arc of less than half a turn") {
  for (const double arc : {40.0, 150.0, 160.0, 170.0}) {
    INFO(arc);
    const double rest = 0.5 * (360.0 - arc);
    const auto wall = shape_of<ExactCylinder>(wall_of({0.0, arc, arc + rest}, 0.3, 0.5), ShapeKind::Cylinder);
    CHECK(wall.walls.size() == 1);
    CHECK(wall.walls[0].radius == Approx(0.3).epsilon(1e-6));
    CHECK(wall.height == Approx(0.5).epsilon(1e-6));
  }
  // Of more they look inward, against their vertices' normals.
  CHECK(says(refusal(scene_of(wall_of({0.0, 190.0, 275.0}, 0.3, 0.5)), ShapeKind::Cylinder),
             "normals must point straight away"));
}

TEST_CASE("exact shapes: a cylinder in small or in large is the same in small or in large") {
  // The first of its facets leans a little, so that two facets' normals do not give its axis.
  const auto leaning = [](Mesh mesh) {
    mesh.vertices[1].position *= 1.0f + 2e-4f;
    return turned(mesh);
  };
  for (const Mesh& mesh :
       {leaning(wall_of({0, 30, 70, 110, 140, 180, 230, 260, 300, 340}, 0.5, 0.8)),
        turned(test::ring(0.5, 0.54, 0.18, 24, 0)), turned(test::half_ring(1.0, 0.8, 16, 0))}) {
    const auto whole = shape_of<ExactCylinder>(mesh, ShapeKind::Cylinder);
    for (const double scale : {0x1p-20, 0x1p-10, 0x1p10}) {
      INFO(mesh.vertices.size() << " " << scale);
      Mesh scaled = mesh;
      for (Vertex& v : scaled.vertices) v.position *= static_cast<float>(scale);
      test::finish(scaled, mesh.closedness);
      const auto other = shape_of<ExactCylinder>(scaled, ShapeKind::Cylinder);
      CHECK(glm::length(other.axis - whole.axis) < 1e-9);
      CHECK(glm::length(other.middle - whole.middle) < 1e-9);
      CHECK(glm::length(other.foot / scale - whole.foot) < 1e-9);
      CHECK(other.height / scale == Approx(whole.height).epsilon(1e-9));
      REQUIRE(other.walls.size() == whole.walls.size());
      for (std::size_t i = 0; i < whole.walls.size(); ++i) {
        CHECK(other.walls[i].radius / scale == Approx(whole.walls[i].radius).epsilon(1e-9));
        CHECK(other.walls[i].outward == whole.walls[i].outward);
      }
      CHECK(other.least_cosine == Approx(whole.least_cosine).margin(1e-9));
      CHECK(other.lower_lid == whole.lower_lid);
      CHECK(other.upper_lid == whole.upper_lid);
    }
  }
}

TEST_CASE("exact shapes: a wall with a second gap is no part of a cylinder") {
  Mesh broken = test::half_ring(1.0, 0.8, 16, 0);
  broken.indices.erase(broken.indices.begin() + 8 * 6, broken.indices.begin() + 9 * 6);
  test::finish(broken, 0.0f);
  CHECK(refusal(scene_of(broken), ShapeKind::Cylinder) != "");
  CHECK(refusal(scene_of(test::half_ring(1.0, 0.8, 16, 0)), ShapeKind::Cylinder) == "");
}

TEST_CASE("exact shapes: a shape's box holds the mesh that it stands for, and hardly more") {
  const Mesh sphere = test::sphere({0.3, 0.8, -0.2}, 0.5, 3, 0);
  const Mesh ring = test::ring(0.5, 0.54, 0.18, 96, 0), half = test::half_ring(1.0, 0.8, 96, 0);
  const auto compare = [](const Bounds& box, const Bounds& mesh, double more) {
    for (int i = 0; i < 3; ++i) {
      CHECK(box.lower[i] <= mesh.lower[i] + 1e-6);
      CHECK(box.lower[i] >= mesh.lower[i] - more);
      CHECK(box.upper[i] >= mesh.upper[i] - 1e-6);
      CHECK(box.upper[i] <= mesh.upper[i] + more);
    }
  };
  compare(exact_shape_of(scene_of(sphere), 0, ShapeKind::Sphere).bounds(), bounds_of(sphere), 0.01);
  compare(exact_shape_of(scene_of(ring), 0, ShapeKind::Cylinder).bounds(), bounds_of(ring), 0.01);
  // Half a wall has the whole one's box.
  const Bounds whole = exact_shape_of(scene_of(half), 0, ShapeKind::Cylinder).bounds();
  compare(whole, bounds_of(test::ring(0.9, 1.0, 0.8, 96, 0)), 0.01);
  const ExactWaves waves{
      .field = {.level = 0.1, .waves = {{0.05, {7.0, 2.0}, 0.3}, {0.02, {-3.0, 11.0}, 1.0}}},
      .lower = {-1.0, -2.0},
      .upper = {1.0, 3.0}};
  CHECK(waves.bounds().lower.y == Approx(0.03).margin(0.01));
  CHECK(waves.bounds().upper.y == Approx(0.17).margin(0.01));
  CHECK(waves.bounds().lower.z == Approx(-2.0));
  CHECK(waves.bounds().upper.x == Approx(1.0));
}

TEST_CASE("exact shapes: what is no cylinder is refused, and says why") {
  const auto why = [](const Mesh& mesh) { return refusal(scene_of(mesh), ShapeKind::Cylinder); };
  CHECK(says(why(test::sphere({0.0, 0.0, 0.0}, 1.0, 2, 0)), "along one axis or across it"));
  CHECK(says(why(test::floor(1.0, 0.0, 0)), "'floor' is no cylinder"));
  CHECK(says(why(test::box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, 0)), "normals must point straight away"));
  Mesh dented = test::ring(0.5, 0.54, 0.18, 24, 0);
  for (Vertex& v : dented.vertices)  // an ellipse
    v.position.x *= 1.01f;
  CHECK(says(why(dented), "to a thousandth"));
  Mesh holed = test::ring(0.5, 0.54, 0.18, 24, 0);
  holed.indices.erase(holed.indices.begin(), holed.indices.begin() + 6);
  CHECK(says(why(holed), "without holes"));
  Mesh lidless = test::ring(0.0, 0.3, 1.0, 24, 0);
  lidless.indices.erase(lidless.indices.end() - 60, lidless.indices.end());  // ten triangles of the lower lid
  CHECK(says(why(lidless), "its lids must reach"));
}

TEST_CASE("exact shapes: waves are met where their heights are, at the first of all meetings") {
  const HeightField field{.level = 0.1, .waves = {{0.05, {7.0, 2.0}, 0.3}, {0.02, {-3.0, 11.0}, 1.0}}};
  ExactWaves waves{.field = field, .lower = {-1.0, -1.0}, .upper = {1.0, 1.0}};
  int met_at_all = 0;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 a(2.0 * number(i, 0) - 1.0, i % 3 ? 0.3 : -0.1, 2.0 * number(i, 1) - 1.0);
    const glm::dvec3 b(2.0 * number(i, 2) - 1.0, 0.1 + 0.06 * number(i, 3), 2.0 * number(i, 4) - 1.0);
    const Ray ray{a, b - a};
    const auto above = [&](double t) { return ray.at(t).y - waves.height({ray.at(t).x, ray.at(t).z}); };
    const auto met = waves.nearest(ray, 0.0, 1.0);
    // Step by step to the first change of sign.
    double first = 2.0;
    for (int k = 1; k <= 4000 && first > 1.0; ++k)
      if ((above(k / 4000.0) > 0.0) != (above(0.0) > 0.0)) first = k / 4000.0;
    if (first > 1.0) {
      if (met) CHECK(std::fabs(above(met->distance)) < 1e-14);  // a graze between two steps
      continue;
    }
    ++met_at_all;
    REQUIRE(met);
    CHECK(std::fabs(above(met->distance)) < 1e-14);
    CHECK(met->distance <= first + 1e-12);
    CHECK(met->front == (above(0.0) > 0.0));
  }
  CHECK(met_at_all > 100);
}

TEST_CASE("exact shapes: waves of a mesh need their formula, and vertices that lie on it") {
  Scene scene = scene_of(test::wave_sheet(1.0, 0.5, 0.02, 6.0, 32, 0));
  CHECK(says(refusal(scene, ShapeKind::Waves), "extras.exact_shape"));
  const auto stated = [&](double amplitude, double k) {
    scene.stated_shapes = {{.mesh = 0,
                            .kind = ShapeKind::Waves,
                            .field = {.level = 0.5, .waves = {{amplitude, {k, 0.0}, 1.5707963267948966}}}}};
  };
  stated(0.02, 6.0);
  const auto waves = std::get<ExactWaves>(exact_shape_of(scene, 0, ShapeKind::Waves).form);
  CHECK(waves.side == 1.0);
  CHECK(waves.upper == glm::dvec2(1.0));
  const auto met = waves.nearest({{0.25, 2.0, 0.1}, {0.0, -1.0, 0.0}}, 0.0, kFar);
  REQUIRE(met);
  CHECK(met->distance == Approx(1.5 - 0.02 * std::cos(1.5)).epsilon(1e-14));
  const double slope = 0.12 * std::sin(1.5);
  CHECK(met->normal.x == Approx(slope / std::sqrt(1.0 + slope * slope)).epsilon(1e-12));
  stated(0.021, 6.0);
  CHECK(says(refusal(scene, ShapeKind::Waves), "to a thousandth of their height"));
  stated(0.02, 6e5);
  CHECK(says(refusal(scene, ShapeKind::Waves), "ten thousand waves"));
  stated(0.02, 6.0);
  scene.meshes[0].indices.resize(scene.meshes[0].indices.size() / 2);
  CHECK(says(refusal(scene, ShapeKind::Waves), "a rectangle of x and z once"));
}

TEST_CASE("exact shapes: each triangle of a rectangle of waves must be there") {
  Scene scene = scene_of(test::wave_sheet(1.0, 0.5, 0.0, 6.0, 4, 0));
  scene.stated_shapes = {{.mesh = 0, .kind = ShapeKind::Waves, .field = {.level = 0.5}}};
  CHECK(refusal(scene, ShapeKind::Waves).empty());
  std::vector<std::uint32_t>& indices = scene.meshes[0].indices;
  const std::vector<std::uint32_t> all = indices;
  REQUIRE(all.size() == 3 * 32);
  for (std::ptrdiff_t first = 0; first < 3 * 32; first += 3) {
    indices = all;
    indices.erase(indices.begin() + first, indices.begin() + first + 3);
    CHECK(says(refusal(scene, ShapeKind::Waves), "a rectangle of x and z once"));
  }
}

TEST_CASE("exact shapes: waves of a mesh that lies on its side, mirrored, are met from their outer side") {
  // x and y exchanged: what was up looks along +x, and triangles turn about.
  Mesh mesh = test::wave_sheet(1.0, 0.5, 0.02, 6.0, 32, 0);
  for (Vertex& v : mesh.vertices) {
    v.position = {v.position.y, v.position.x, v.position.z};
    v.normal = {v.normal.y, v.normal.x, v.normal.z};
  }
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
  Scene scene = scene_of(mesh);
  scene.stated_shapes = {
      {.mesh = 0,
       .kind = ShapeKind::Waves,
       .field = {.level = 0.5,
                 .waves = {{0.02, {6.0, 0.0}, 1.5707963267948966}},
                 .axes = {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1)}}}};
  const ExactShape shape = exact_shape_of(scene, 0, ShapeKind::Waves);
  const auto met = shape.nearest({{3.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}}, 0.0, kFar);
  REQUIRE(met);
  CHECK(met->distance == Approx(2.48).epsilon(1e-12));
  CHECK(met->front);
  CHECK(met->normal.x == Approx(1.0));
  CHECK_FALSE(shape.nearest({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, 0.0, kFar)->front);
}

}  // namespace caustics::tracer
