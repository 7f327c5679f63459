// Rays that Embree finds triangles for, met again in double precision.
#include "lab/reference/tracer/rays.hpp"

#include <cfenv>
#include <cmath>
#include <limits>
#include <utility>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/in_pieces.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/ray_queries.hpp"
#include "tests/support/shapes.hpp"

namespace caustics::tracer {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("tracer rays: a hit lies on the triangle's plane in double precision") {
  test::need_ray_queries();
  Scene scene;
  scene.meshes = {test::floor(2.0, 0.1, 0)};
  const RaySet rays(scene, {0});
  const double height = static_cast<double>(0.1f);  // what the vertices hold
  const Ray ray{{0.3, 1.7, -0.2}, glm::normalize(glm::dvec3(0.31, -1.0, 0.17))};
  const auto hit = rays.nearest(ray, 0.0, kFar);
  REQUIRE(hit);
  CHECK(hit->position.y == Approx(height).epsilon(1e-14));
  CHECK(hit->distance == Approx((1.7 - height) / -ray.direction.y).epsilon(1e-14));
  CHECK(hit->position.x == Approx(0.3 + 0.31 * (1.7 - height)).epsilon(1e-14));
  CHECK(hit->front);
  CHECK(hit->plane == glm::dvec3(0.0, 1.0, 0.0));
  CHECK(rays.blocked(ray, 0.0, kFar));
  CHECK_FALSE(rays.blocked(ray, 0.0, 1.0));
  CHECK_FALSE(rays.nearest({ray.origin, -ray.direction}, 0.0, kFar));
  // From below it is the back.
  CHECK_FALSE(rays.nearest({{0.3, -1.0, 0.0}, {0.0, 1.0, 0.0}}, 0.0, kFar)->front);
}

TEST_CASE("tracer rays: normals are interpolated between the vertices as the renderer does") {
  test::need_ray_queries();
  Scene scene;
  scene.meshes = {test::floor(1.0, 0.0, 0)};
  scene.meshes[0].vertices[0].normal = {0.6f, 0.8f, 0.0f};
  const RaySet rays(scene, {0});
  // A quarter of the way from the first corner (-1, 0, 1) to the second (1, 0, 1), on the triangle's edge but
  // a hair.
  const auto hit = rays.nearest({{-0.5, 1.0, 1.0 - 1e-6}, {0.0, -1.0, 0.0}}, 0.0, kFar);
  REQUIRE(hit);
  const glm::dvec3 expected =
      glm::normalize(0.75 * glm::dvec3(0.6, 0.8, 0.0) + 0.25 * glm::dvec3(0.0, 1.0, 0.0));
  CHECK(glm::length(hit->normal - expected) < 2e-6);
}

TEST_CASE("tracer rays: no meshes stop no ray") {
  test::need_ray_queries();
  const Scene scene;
  const RaySet rays(scene, {});
  CHECK(rays.empty());
  CHECK_FALSE(rays.blocked({}, 0.0, kFar));
}

// 2^-1060 is a denormal: halves of it stay only where denormals are not flushed.
TEST_CASE("tracer rays: building a scene leaves the floating-point mode as it was") {
  test::need_ray_queries();
  Scene scene;
  scene.meshes = {test::sphere({0.0, 0.0, 0.0}, 1.0, 4, 0)};
  volatile double tiny = 0x1p-1060;
  const RaySet rays(scene, {0});
  CHECK(tiny * 0.5 == 0x1p-1061);
  CHECK(std::fegetround() == FE_TONEAREST);
  int kept = 0;
  in_pieces(1, 2, [&](int) { kept = tiny * 0.5 == 0x1p-1061 ? 1 : 0; });
  CHECK(kept == 1);
}

TEST_CASE("tracer rays: an exact shape is met up to a hair's breadth from each side of its box") {
  test::need_ray_queries();
  for (const auto& [kind, mesh] : {std::pair{ShapeKind::Sphere, test::sphere({0.3, 0.8, -0.2}, 0.5, 3, 0)},
                                   std::pair{ShapeKind::Cylinder, test::ring(0.3, 0.54, 0.18, 48, 0)}}) {
    Scene scene;
    scene.meshes = {mesh};
    const ExactShape shape = exact_shape_of(scene, 0, kind);
    const RaySet rays(scene, {0}, {shape});
    const Bounds box = shape.bounds();
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0}) {
        // Along the side, so near that single precision just tells it from the side.
        Ray ray{box.centre(), glm::dvec3(0.0)};
        ray.origin[axis] = (side > 0.0 ? box.upper : box.lower)[axis] - side * 2e-6;
        ray.direction[(axis + 1) % 3] = 1.0;
        ray.origin -= 3.0 * ray.direction;
        INFO(mesh.name << " " << axis << " " << side);
        const auto hit = rays.nearest(ray, 0.0, kFar);
        REQUIRE(hit);
        CHECK(hit->triangle == -1);
        CHECK(hit->position[axis] == Approx(ray.origin[axis]).margin(1e-9));
        CHECK(rays.blocked(ray, 0.0, kFar));
        ray.origin[axis] += side * 4e-6;
        CHECK_FALSE(rays.nearest(ray, 0.0, kFar));
        CHECK_FALSE(rays.blocked(ray, 0.0, kFar));
      }
  }
}

}  // namespace caustics::tracer
