// extras.exact_shape: what a mesh stands for.
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Gltf sheet(const std::string& shape, const std::string& more = "") {
  return level_square(R"("exact_shape":)" + shape, more);
}

}  // namespace

TEST_CASE("A mesh without extras.exact_shape stands for itself") {
  Gltf gltf = sheet("\"sphere\"");
  gltf.node = R"("mesh":0,"extras":"exact_shape")";
  CHECK(load(gltf).stated_shapes.empty());
}

TEST_CASE("extras.exact_shape names a sphere or a cylinder, and adds no triangle") {
  const Scene scene = load(sheet("\"sphere\""));
  REQUIRE(scene.stated_shapes.size() == 1);
  CHECK(scene.stated_shapes[0].mesh == 0);
  CHECK(scene.stated_shapes[0].kind == ShapeKind::Sphere);
  CHECK(scene.meshes.at(0).indices.size() == 6);
  CHECK(load(sheet("\"cylinder\"")).stated_shapes.at(0).kind == ShapeKind::Cylinder);
}

TEST_CASE("extras.exact_shape states waves in the mesh's own coordinates") {
  const std::string two = R"([{"amplitude":0.1,"k":[2,-3],"phase":0.25},{"amplitude":1,"k":[0,1]}])";
  const Scene scene =
      load(sheet(R"({"level":0.5,"waves":)" + two + "}", R"(,"translation":[3,4,5],"scale":[2,2,2])"));
  const StatedShape& shape = scene.stated_shapes.at(0);
  CHECK(shape.kind == ShapeKind::Waves);
  CHECK(shape.field.level == 0.5);
  REQUIRE(shape.field.waves.size() == 2);
  CHECK(shape.field.waves[0].amplitude == 0.1);
  CHECK(shape.field.waves[0].k == glm::dvec2(2.0, -3.0));
  CHECK(shape.field.waves[0].phase == 0.25);
  CHECK(shape.field.waves[1].phase == 0.0);
  CHECK(shape.field.axes[0] == glm::dvec3(2.0, 0.0, 0.0));
  // The scene's origin lies in the middle of its only mesh.
  CHECK(glm::length(shape.field.origin) < 1e-12);
}

TEST_CASE("extras.exact_shape that is no shape is refused") {
  const auto why = [](const std::string& shape) { return refusal(sheet(shape)); };
  CHECK(contains(why("\"cube\""), "nodes[0].extras.exact_shape: is no shape that is known"));
  CHECK(contains(why("{}"), "exact_shape.waves: must be a list of 1 to 64 waves"));
  CHECK(contains(why(R"({"waves":[]})"), "must be a list"));
  CHECK(contains(why(R"({"waves":[{"amplitude":1}]})"), "waves[0].k: is missing"));
  CHECK(contains(why(R"({"waves":[{"amplitude":1,"k":[1,0],"phases":1}]})"), "phases: is not known"));
  CHECK(contains(why(R"({"waves":[{"amplitude":1,"k":[1,0],"phase":1e9}]})"), "take out whole turns"));
  CHECK(contains(why(R"({"waves":[7]})"), "waves[0]: is no object"));
}
