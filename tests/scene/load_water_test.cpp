// extras.water: what makes a mesh water that moves.
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Gltf sheet(const std::string& water, const std::string& more = "") {
  return level_square(R"("water":)" + water, more);
}

}  // namespace

TEST_CASE("A mesh without extras.water is none, and keeps its triangles") {
  Gltf gltf = sheet("{}");
  gltf.node = R"("mesh":0,"extras":{"waters":{}})";
  const Scene scene = load(gltf);
  CHECK(scene.waters.empty());
  CHECK(scene.meshes.at(0).indices.size() == 6);
}

TEST_CASE("Empty extras.water has the documented defaults") {
  const Scene scene = load(sheet("{}"));
  REQUIRE(scene.waters.size() == 1);
  const Water& water = scene.waters[0];
  CHECK(water.name == "pool");
  CHECK(water.columns == 256);
  CHECK(water.rows == 256);
  CHECK(water.settings.speed == 0.5);
  CHECK(water.settings.damping == 0.4);
  CHECK(water.settings.start == 0.0);
  CHECK(water.settings.interval == 0.4);
  CHECK(water.radius == Approx(0.1));   // 1/20 of 2 m
  CHECK(water.height == Approx(0.02));  // 1/5 of that
  // 0.5 m/s may go half a cell, 2 / 512 m, in a step; 0.4 s are 51.2 of those, so 52 steps.
  CHECK(water.steps_per_plop == 52);
  CHECK(water.step * 52 == Approx(0.4));
}

TEST_CASE("A mesh's own extras count where its node has none") {
  Gltf gltf = sheet("{}");
  gltf.node = R"("mesh":0)";
  std::string json = gltf.json();
  const std::string mesh = R"("meshes":[{)";
  json.insert(json.find(mesh) + mesh.size(), R"("extras":{"water":{"cells":16}},)");
  CHECK(load_text(json).waters.at(0).columns == 16);
}

TEST_CASE("A sheet's triangles are split until no edge is longer than a cell's diagonal") {
  const Scene scene = load(sheet(R"({"cells":32})"));
  const Mesh& mesh = scene.meshes.at(0);
  // The diagonal of 2.83 m in halves: 5 times down to 0.088 m, a cell's.
  CHECK(mesh.indices.size() == 6 * 1024);
  // The first diagonal's twice: a file without normals has two flat triangles that share none.
  CHECK(mesh.vertices.size() == 33 * 33 + 33);
  // Its bounds hold waves of 4 times the largest plop.
  CHECK(mesh.upper.y - mesh.lower.y == Approx(8.0 * scene.waters.at(0).height));
}

TEST_CASE("The grid's columns run along the node's x axis") {
  // A sheet of 4 x 2 m, turned by 30 degrees about y.
  const Scene scene = load(sheet(R"({"cells":64})", R"(,"scale":[2,1,1],"rotation":[0,0.25881904510252074,0,
                                    0.9659258262890683])"));
  const Water& water = scene.waters.at(0);
  CHECK(water.columns == 64);
  CHECK(water.rows == 32);
  CHECK(water.dx == Approx(4.0 / 64));
  CHECK(water.right.x == Approx(std::sqrt(0.75)));
  CHECK(water.right.z == Approx(-0.5));
}

TEST_CASE("Water's values out of range are refused with their place") {
  const auto problem = [](const std::string& water) { return refusal(sheet(water)); };
  CHECK(contains(problem("1"), "nodes[0].extras.water: is no object"));
  CHECK(contains(problem(R"({"speed":0})"), "speed must be 0.001 to 100"));
  CHECK(contains(problem(R"({"speed":"fast"})"), "extras.water.speed"));
  CHECK(contains(problem(R"({"damping":-1})"), "damping must be 0 to 1000"));
  CHECK(contains(problem(R"({"cells":4})"), "extras.water.cells"));
  CHECK(contains(problem(R"({"start":-1})"), "start must be 0 to 3600"));
  CHECK(contains(problem(R"({"plops":{"interval":0}})"), "plops.interval must be 0.01 to 10000"));
  CHECK(contains(problem(R"({"plops":{"radius":0.001}})"), "plops.radius must be at least 3 cells"));
  CHECK(contains(problem(R"({"plops":{"radius":2}})"), "at most half the sheet's shorter side"));
  CHECK(contains(problem(R"({"plops":{"height":0.2}})"), "plops.height must be 0 to the plops' radius"));
  CHECK(contains(problem(R"({"plops":{"seed":1.5}})"), "extras.water.plops.seed"));
  CHECK(contains(problem(R"({"speed":100,"cells":2048})"), "more than 20000 steps a second"));
  CHECK(contains(problem(R"({"dampng":1})"), "extras.water.dampng: is not known; use speed, damping"));
}

TEST_CASE("Water on anything but a level open sheet is refused") {
  CHECK(contains(refusal(sheet("{}", R"(,"rotation":[0.7071067811865475,0,0,0.7071067811865475])")),
                 "no horizontal sheet"));
  CHECK(contains(refusal(sheet("{}", R"(,"rotation":[1,0,0,0])")), "turn its faces over"));
}

TEST_CASE("Water may rise by a quarter of its sheet's shorter side at rest") {
  // A sheet of 4 x 1 m, its long side turned up by an angle whose sine is 0.05, then 0.1: 0.2 and 0.4 m.
  const auto turned = [](const std::string& half_sine, const std::string& half_cosine) {
    return sheet("{}", R"(,"scale":[2,1,0.5],"rotation":[0,0,)" + half_sine + "," + half_cosine + "]");
  };
  CHECK(load(turned("0.0250078", "0.9996873")).waters.size() == 1);
  CHECK(contains(refusal(turned("0.0500628", "0.9987461")), "no horizontal sheet"));
}

TEST_CASE("All waters together have a limited number of cells") {
  Gltf gltf = sheet(R"({"cells":16})", R"(,"children":[1]},{"mesh":0,"extras":{"water":{"cells":16}})");
  LoadOptions options;
  options.max_water_cells = 512;
  CHECK(load_text(gltf.json(), options).waters.size() == 2);
  options.max_water_cells = 511;
  CHECK(contains(refusal(gltf.json(), options), "nodes[1].extras.water: cannot be: it has more cells"));
}

TEST_CASE("Waters may not ask for endless steps before time 0") {
  // 2 million cells, 15 000 steps a second.
  CHECK(
      contains(refusal(sheet(R"({"cells":1500,"speed":10,"start":3600})")), "too many steps before time 0"));
  // The defaults after the longest start: 31 billion.
  CHECK(load(sheet(R"({"start":3600})")).waters.size() == 1);
}

TEST_CASE("Splitting a water's triangles keeps to the limit on triangles") {
  LoadOptions options;
  options.max_triangles = 100;
  const Scene scene = load_text(sheet(R"({"cells":32})").json(), options);
  CHECK(scene.meshes.at(0).indices.size() == 6 * 16);
}
