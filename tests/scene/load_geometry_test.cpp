// Vertices, indices and transforms: what the loader makes of geometry that is as it should be.
#include "pipeline/scene/gltf/topology.hpp"
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A cube of side 2 round the origin; corner i has the sign of bit k in coordinate k.
std::vector<float> cube_corners() {
  std::vector<float> values;
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 3; ++k) values.push_back((i >> k & 1) ? 1.0f : -1.0f);
  }
  return values;
}
const std::vector<std::uint8_t> kCube = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                         2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
const char* kGlass = R"(,"materials":[{"extensions":{"KHR_materials_transmission":
    {"transmissionFactor":1}}}])";

Gltf cube(const std::vector<std::uint8_t>& indices) {
  Gltf gltf;
  gltf.add(cube_corners(), 5126, "VEC3", 8);
  gltf.add(indices, 5121, "SCALAR", indices.size());
  gltf.mesh = R"("attributes":{"POSITION":0},"indices":1,"material":0)";
  gltf.rest = kGlass;
  return gltf;
}

Gltf strip_or_fan(int mode) {
  Gltf gltf;
  gltf.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, 5126, "VEC3", 4);
  if (mode == 6) {
    gltf = Gltf();
    gltf.add<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 5126, "VEC3", 4);
  }
  gltf.mesh = R"("attributes":{"POSITION":0},"mode":)" + std::to_string(mode);
  return gltf;
}

}  // namespace

TEST_CASE("An unindexed triangle without normals is shaded flat, centred at the origin") {
  const Scene scene = load(triangle());
  REQUIRE(scene.meshes.size() == 1);
  const Mesh& mesh = scene.meshes[0];
  REQUIRE(mesh.indices.size() == 3);
  CHECK(scene.origin == glm::dvec3(0.5, 0.5, 0));
  CHECK(mesh.lower == glm::vec3(-0.5, -0.5, 0));
  CHECK(mesh.upper == glm::vec3(0.5, 0.5, 0));
  for (const Vertex& vertex : mesh.vertices) CHECK(vertex.normal == glm::vec3(0, 0, 1));
  CHECK(has_note(scene, "no normals"));
  CHECK(scene.materials.size() == 1);
  CHECK(mesh.closedness == 0.0f);
  CHECK_FALSE(mesh.has_uv);
}

TEST_CASE("Strips and fans make the triangles that glTF winds") {
  for (const int mode : {5, 6}) {
    const Scene scene = load(strip_or_fan(mode));
    REQUIRE(scene.meshes.size() == 1);
    REQUIRE(scene.meshes[0].indices.size() == 6);
    CHECK(facing(scene.meshes[0], 0).z == 1.0f);
    CHECK(facing(scene.meshes[0], 1).z == 1.0f);
  }
}

TEST_CASE("Points and lines are left out with a note") {
  for (const int mode : {0, 1, 2, 3}) {
    const Scene scene = load(strip_or_fan(mode));
    CHECK(scene.meshes.empty());
    CHECK(has_note(scene, "points and lines"));
  }
}

TEST_CASE("Indices of all three widths give the same triangle") {
  for (const int type : {5121, 5123, 5125}) {
    Gltf gltf = triangle();
    if (type == 5121) gltf.add<std::uint8_t>({0, 1, 2}, type, "SCALAR", 3);
    if (type == 5123) gltf.add<std::uint16_t>({0, 1, 2}, type, "SCALAR", 3);
    if (type == 5125) gltf.add<std::uint32_t>({0, 1, 2}, type, "SCALAR", 3);
    gltf.mesh = R"("attributes":{"POSITION":0},"indices":1)";
    const Scene scene = load(gltf);
    REQUIRE(scene.meshes.size() == 1);
    CHECK(facing(scene.meshes[0], 0) == glm::vec3(0, 0, 1));
  }
}

TEST_CASE("A sparse accessor replaces elements of its base, or of zeros") {
  Gltf gltf = triangle();
  gltf.add<std::uint16_t>({1, 2}, 5123, "SCALAR", 2);
  gltf.add<float>({2, 0, 0, 0, 3, 0}, 5126, "VEC3", 2);
  const std::string sparse = R"("componentType":5126,"type":"VEC3","count":3,"sparse":{"count":2,
      "indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":2}}})";
  Gltf based = gltf;
  based.accessors += R"(,{"bufferView":0,)" + sparse;
  based.mesh = R"("attributes":{"POSITION":3})";
  Gltf zeros = gltf;
  zeros.accessors += ",{" + sparse;
  zeros.mesh = R"("attributes":{"POSITION":3})";
  for (const Gltf& each : {based, zeros}) {
    const Scene scene = load(each);
    CHECK(world(scene, scene.meshes.at(0).vertices.at(0)) == glm::vec3(0, 0, 0));
    CHECK(world(scene, scene.meshes[0].vertices.at(1)) == glm::vec3(2, 0, 0));
    CHECK(world(scene, scene.meshes[0].vertices.at(2)) == glm::vec3(0, 3, 0));
  }
}

TEST_CASE("Quantised positions and normals are converted as KHR_mesh_quantization says") {
  Gltf gltf;
  gltf.add<std::int16_t>({0, 0, 0, 32767, 0, 0, 0, -32768, 0}, 5122, "VEC3", 3, R"(,"normalized":true)");
  gltf.add<std::int8_t>({0, 0, -127, 0, 0, -128, 0, 0, -127}, 5120, "VEC3", 3, R"(,"normalized":true)");
  gltf.mesh = R"("attributes":{"POSITION":0,"NORMAL":1})";
  gltf.rest = R"(,"extensionsUsed":["KHR_mesh_quantization"],
                 "extensionsRequired":["KHR_mesh_quantization"])";
  const Scene scene = load(gltf);
  const Mesh& mesh = scene.meshes.at(0);
  CHECK(world(scene, mesh.vertices[1]) == glm::vec3(1, 0, 0));
  CHECK(world(scene, mesh.vertices[2]) == glm::vec3(0, -1, 0));
  for (const Vertex& vertex : mesh.vertices) CHECK(vertex.normal == glm::vec3(0, 0, -1));
}

TEST_CASE("Interleaved attributes are read at their stride") {
  Gltf gltf;
  gltf.add<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1}, 5126, "VEC3", 3);
  gltf.views = R"({"buffer":0,"byteLength":72,"byteStride":24})";
  gltf.accessors += R"(,{"bufferView":0,"byteOffset":12,"componentType":5126,"type":"VEC3","count":3})";
  gltf.mesh = R"("attributes":{"POSITION":0,"NORMAL":1})";
  const Scene scene = load(gltf);
  CHECK(world(scene, scene.meshes.at(0).vertices[2]) == glm::vec3(0, 1, 0));
  CHECK(scene.meshes[0].vertices[2].normal == glm::vec3(0, 0, 1));
}

TEST_CASE("A mirrored node keeps the outside outside") {
  Gltf gltf = cube(kCube);
  gltf.node += R"(,"scale":[-1,1,2])";
  const Scene scene = load(gltf);
  const Mesh& mesh = scene.meshes.at(0);
  CHECK(mesh.closedness == 1.0f);
  for (std::size_t t = 0; t < 12; ++t) {
    const glm::vec3 corner = mesh.vertices[mesh.indices[3 * t]].position;
    CHECK(glm::dot(facing(mesh, t), corner) > 0);
  }
  CHECK_FALSE(has_note(scene, "turned"));
}

TEST_CASE("A glass cube that is inside out, or winds at random, is turned to face outwards") {
  std::vector<std::uint8_t> inverted = kCube, random = kCube;
  for (std::size_t i = 0; i < kCube.size(); i += 3) std::swap(inverted[i], inverted[i + 1]);
  for (const std::size_t t : {1u, 4u, 5u, 9u}) std::swap(random[3 * t], random[3 * t + 1]);
  for (const auto& indices : {inverted, random}) {
    const Scene scene = load(cube(indices));
    const Mesh& mesh = scene.meshes.at(0);
    CHECK(mesh.closed());
    CHECK(has_note(scene, "turned"));
    for (std::size_t t = 0; t < 12; ++t) {
      const glm::vec3 corner = mesh.vertices[mesh.indices[3 * t]].position;
      CHECK(glm::dot(facing(mesh, t), corner) > 0);
    }
  }
}

TEST_CASE("An opaque room that is seen from inside keeps its winding, and is known to be inside out") {
  std::vector<std::uint8_t> inverted = kCube;
  for (std::size_t i = 0; i < kCube.size(); i += 3) std::swap(inverted[i], inverted[i + 1]);
  Gltf gltf = cube(inverted);
  gltf.rest = R"(,"materials":[{}])";
  const Scene scene = load(gltf);
  CHECK(glm::dot(facing(scene.meshes.at(0), 0), scene.meshes[0].vertices[0].position) < 0);
  CHECK(scene.meshes[0].inside_out);
  Gltf body = cube(kCube);
  body.rest = gltf.rest;
  CHECK_FALSE(load(body).meshes.at(0).inside_out);
}

TEST_CASE("Glass that is split over two primitives is closed when both together are") {
  Gltf gltf;
  gltf.add(cube_corners(), 5126, "VEC3", 8);
  gltf.add(std::vector<std::uint8_t>(kCube.begin(), kCube.begin() + 18), 5121, "SCALAR", 18);
  gltf.add(std::vector<std::uint8_t>(kCube.begin() + 18, kCube.end()), 5121, "SCALAR", 18);
  gltf.mesh = R"("attributes":{"POSITION":0},"indices":1,"material":0},
                 {"attributes":{"POSITION":0},"indices":2,"material":0)";
  gltf.rest = kGlass;
  const Scene scene = load(gltf);
  REQUIRE(scene.meshes.size() == 2);
  CHECK(scene.meshes[0].closedness == 1.0f);
  CHECK(scene.meshes[1].closedness == 1.0f);
  CHECK(scene.meshes[0].object == scene.meshes[1].object);
}

TEST_CASE("Seams that differ by rounding are welded, but an open box is open") {
  std::vector<float> corners = cube_corners();
  const std::vector<float> copy = corners;
  corners.insert(corners.end(), copy.begin(), copy.end());
  corners[24] += 1e-7f;
  std::vector<std::uint8_t> indices = kCube;
  indices[0] = indices[12] = 8;  // two of the corners that use vertex 0
  Gltf gltf = cube(indices);
  Gltf seam;
  seam.add(corners, 5126, "VEC3", 16);
  seam.add(indices, 5121, "SCALAR", 36);
  seam.mesh = gltf.mesh;
  seam.rest = gltf.rest;
  CHECK(load(seam).meshes.at(0).closedness == 1.0f);
  const Scene open = load(cube({kCube.begin() + 6, kCube.end()}));
  CHECK(open.meshes.at(0).closedness < 0.98f);
}

TEST_CASE("Zero and non-finite normals give way to the surface's own") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Gltf gltf = triangle();
  gltf.add<float>({0, 0, 0, nan, 0, 1, 0, 0, 5}, 5126, "VEC3", 3);
  gltf.mesh = R"("attributes":{"POSITION":0,"NORMAL":1})";
  const Scene scene = load(gltf);
  for (const Vertex& vertex : scene.meshes.at(0).vertices) {
    CHECK(vertex.normal == glm::vec3(0, 0, 1));
  }
  CHECK(has_note(scene, "2 normals are zero or not finite"));
}

TEST_CASE("Triangles without area are dropped and counted once") {
  Gltf gltf = triangle();
  gltf.add<std::uint8_t>({0, 1, 2, 0, 0, 1, 2, 2, 2}, 5121, "SCALAR", 9);
  gltf.mesh = R"("attributes":{"POSITION":0},"indices":1)";
  const Scene scene = load(gltf);
  CHECK(scene.meshes.at(0).indices.size() == 3);
  CHECK(has_note(scene, "2 triangles without area were dropped."));
}

TEST_CASE("Transforms compose from the root down") {
  Gltf gltf = triangle();
  // A quarter turn about z, then a shift: (1, 0, 0) -> (0, 2, 0) -> (10, 2, 0).
  gltf.node = R"("translation":[10,0,0],"children":[1]},{"mesh":0,"scale":[2,2,2],
      "rotation":[0,0,0.70710678118654752,0.70710678118654752])";
  const Scene scene = load(gltf);
  const glm::vec3 p = world(scene, scene.meshes.at(0).vertices[1]);
  CHECK(p.x == Approx(10));
  CHECK(p.y == Approx(2));
  CHECK(p.z == Approx(0).margin(1e-6));
}

TEST_CASE("A node's matrix is read column by column") {
  // A quarter turn about z, then a shift along x: (1, 0, 0) -> (10, 1, 0).
  Gltf gltf = triangle();
  gltf.node += R"(,"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 10,0,0,1])";
  const Scene scene = load(gltf);
  CHECK(world(scene, scene.meshes.at(0).vertices[1]) == glm::vec3(10, 1, 0));
}

TEST_CASE("A scene a thousand kilometres away keeps its detail") {
  Gltf gltf = triangle();
  gltf.node += R"(,"translation":[1e6,0,-1e6])";
  const Scene scene = load(gltf);
  CHECK(scene.origin == glm::dvec3(1e6 + 0.5, 0.5, -1e6));
  CHECK(scene.meshes.at(0).lower == glm::vec3(-0.5, -0.5, 0));
}

TEST_CASE("EXT_mesh_gpu_instancing places the mesh once for each instance") {
  Gltf gltf = triangle();
  gltf.add<float>({0, 0, 0, 5, 0, 0}, 5126, "VEC3", 2);
  gltf.node += R"(,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":1}}})";
  const Scene scene = load(gltf);
  REQUIRE(scene.meshes.size() == 2);
  CHECK(scene.meshes[0].object != scene.meshes[1].object);
  CHECK(scene.meshes[1].lower.x - scene.meshes[0].lower.x == 5.0f);
  // The node turns its instances: 5 m along x become 5 m along y.
  gltf.node += R"(,"rotation":[0,0,0.70710678118654752,0.70710678118654752])";
  const Scene turned = load(gltf);
  CHECK(turned.meshes.at(1).lower.y - turned.meshes.at(0).lower.y == Approx(5));
  CHECK(turned.meshes[1].lower.x == Approx(turned.meshes[0].lower.x));
}

TEST_CASE("Hidden nodes and their children are left out") {
  Gltf gltf = triangle();
  gltf.node += R"(,"extensions":{"KHR_node_visibility":{"visible":false}})";
  CHECK(load(gltf).meshes.empty());
  // Two nodes, of which the second stands in the first.
  const auto shown = [](const std::string& of_parent, const std::string& of_child) {
    Gltf family = triangle();
    family.node =
        R"("name":"parent","mesh":0,"children":[1])" + of_parent + R"(},{"name":"child","mesh":0)" + of_child;
    std::string names;
    for (const Mesh& mesh : load(family).meshes) names += mesh.name + " ";
    return names;
  };
  const std::string hidden = R"(,"extensions":{"KHR_node_visibility":{"visible":false}})";
  CHECK(shown("", "") == "parent child ");
  CHECK(shown(hidden, "").empty());
  CHECK(shown("", hidden) == "parent ");
  CHECK(shown(hidden, R"(,"extensions":{"KHR_node_visibility":{"visible":true}})").empty());
}

TEST_CASE("Loading twice gives the same bits") {
  const Scene a = load(cube(kCube)), b = load(cube(kCube));
  REQUIRE(a.meshes.at(0).vertices.size() == b.meshes.at(0).vertices.size());
  CHECK(std::memcmp(a.meshes[0].vertices.data(), b.meshes[0].vertices.data(),
                    a.meshes[0].vertices.size() * sizeof(Vertex)) == 0);
}

TEST_CASE("Vertex colours of three or four components are read, clamped, and go with their vertices") {
  Gltf gltf = triangle();
  const int shares = gltf.add<std::uint8_t>({255, 0, 51, 0, 0, 255, 0, 0, 255, 255, 255, 0}, 5121, "VEC3", 3,
                                            R"(,"normalized":true)");
  gltf.mesh = R"("attributes":{"POSITION":0,"COLOR_0":)" + std::to_string(shares) + R"(},"material":0)";
  gltf.rest = R"(,"materials":[{}])";
  gltf.views.replace(gltf.views.rfind("}"), 1, R"(,"byteStride":4})");
  const Mesh mesh = load(gltf).meshes.at(0);
  REQUIRE(mesh.colors.size() == mesh.vertices.size());
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3& at = mesh.vertices[i].position;
    const glm::vec4 expected = at.x > 0   ? glm::vec4(0, 1, 0, 1)
                               : at.y > 0 ? glm::vec4(1, 1, 1, 1)
                                          : glm::vec4(1, 0, 51.0f / 255.0f, 1);
    CHECK(mesh.colors[i] == expected);
  }
  Gltf floats = triangle();
  floats.add<float>({2, -1, 0.5f, 0.25f, 0, 0, 0, 1, 0, 0, 0, 1}, 5126, "VEC4", 3);
  floats.mesh = R"("attributes":{"POSITION":0,"COLOR_0":1},"material":0)";
  floats.rest = gltf.rest;
  CHECK(load(floats).meshes.at(0).colors.at(0) == glm::vec4(1, 0, 0.5f, 0.25f));
}

TEST_CASE(
    "Vertex colours that are white, of another type or on glass are left out, the last two with notes") {
  const auto scene_with = [](const std::vector<float>& colors, const std::string& material,
                             const std::string& type = "VEC4") {
    Gltf gltf = triangle();
    gltf.add<float>(colors, 5126, type, 3);
    gltf.mesh = R"("attributes":{"POSITION":0,"COLOR_0":1},"material":0)";
    gltf.rest = R"(,"materials":[{)" + material + "}]";
    return load(gltf);
  };
  const std::vector<float> white(12, 1.0f), grey(12, 0.5f);
  const char* kGlass = R"("extensions":{"KHR_materials_transmission":{"transmissionFactor":1}})";
  CHECK(scene_with(white, "").meshes.at(0).colors.empty());
  CHECK_FALSE(has_note(scene_with(white, kGlass), "vertex colours"));
  const Scene pane = scene_with(grey, kGlass);
  CHECK(pane.meshes.at(0).colors.empty());
  CHECK(has_note(pane, ": vertex colours are ignored on glass and mirrors."));
  const Scene wrong = scene_with(std::vector<float>(6, 0.5f), "", "VEC2");
  CHECK(wrong.meshes.at(0).colors.empty());
  CHECK(has_note(wrong, "accessors[1]: vertex colours are neither floats nor shares of 1"));
}

TEST_CASE("A vertex without a normal takes the first of its faces' where these cancel, and is counted") {
  // Two triangles in the plane z = 0 that face +z and -z, and share the last vertex.
  Gltf gltf;
  gltf.add<float>({1, 0, 0, 0, 1, 0, 0, -1, 0, 1, 0, 0, 0, 0, 0}, 5126, "VEC3", 5);
  gltf.add<float>({0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, -1, 0, 0, 0}, 5126, "VEC3", 5);
  gltf.add<std::uint16_t>({0, 1, 4, 4, 3, 2}, 5123, "SCALAR", 6);
  gltf.mesh = R"("attributes":{"POSITION":0,"NORMAL":1},"indices":2)";
  const Scene scene = load(gltf);
  for (const Vertex& vertex : scene.meshes.at(0).vertices)
    if (world(scene, vertex) == glm::vec3(0.0f)) CHECK(vertex.normal == glm::vec3(0, 0, 1));
  CHECK(has_note(scene, ": 1 normals are zero or not finite"));
  CHECK_FALSE(has_note(scene, "were turned"));
}

TEST_CASE("A triangle is dropped where it is flatter than 1e-10 of its side, or shorter than a picometre") {
  // With sides `length` and `height` at a right angle, the corner of which lies at `corner`.
  const auto is_kept = [](double length, double height, const glm::dvec3& corner) {
    gltf::Shape shape;
    shape.positions = {corner, corner + glm::dvec3(length, 0, 0), corner + glm::dvec3(0, height, 0)};
    shape.triangles = {{0, 1, 2}};
    return gltf::drop_degenerate(shape) == 0;
  };
  for (const glm::dvec3& corner : {glm::dvec3(0.0), glm::dvec3(0.3, -0.2, 0.5)})
    for (const double length : {0.01, 1.0, 100.0}) {
      INFO(length << " m from " << corner.x);
      CHECK(is_kept(length, 1.1e-10 * length, corner));
      CHECK_FALSE(is_kept(length, 0.9e-10 * length, corner));
    }
  CHECK(is_kept(1.1e-12, 1e-13, glm::dvec3(0.0)));
  CHECK_FALSE(is_kept(0.9e-12, 1e-13, glm::dvec3(0.0)));
}
