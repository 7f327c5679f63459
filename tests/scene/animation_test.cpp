// What moves in a file: nodes, joints and morph weights, and what hangs on them.
#include <algorithm>
#include <cmath>

#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

AnimatedScene load_moving(const Gltf& gltf, const std::string& animation = "") {
  const Folder folder;
  LoadOptions options;
  options.animation = animation;
  return load_animated(folder.write("scene.gltf", gltf.json()), options);
}

// A channel of a single animation; the accessors are added to the file.
void animate(Gltf& gltf, int node, const std::string& path, const std::vector<float>& times,
             const std::vector<float>& values, const std::string& type,
             const std::string& interpolation = "LINEAR") {
  const int input = gltf.add(times, 5126, "SCALAR", times.size());
  const std::size_t width = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
  const int output = gltf.add(values, 5126, type, values.size() / width);
  gltf.rest += R"(,"animations":[{"name":"walk","samplers":[{"input":)" + std::to_string(input) +
               R"(,"output":)" + std::to_string(output) + R"(,"interpolation":")" + interpolation +
               R"("}],"channels":[{"sampler":0,"target":{"node":)" + std::to_string(node) + R"(,"path":")" +
               path + R"("}}]}])";
}

Gltf sliding_triangle() {
  Gltf gltf = triangle();
  animate(gltf, 0, "translation", {0, 2}, {0, 0, 0, 4, 0, 0}, "VEC3");
  return gltf;
}

// In the world, as the file's triangle (0 0 0, 1 0 0, 0 1 0) numbers them.
glm::dvec3 world(const Scene& scene, std::size_t vertex) {
  return glm::dvec3(scene.meshes[0].vertices[vertex].position) + scene.origin;
}

bool equal_bits(const Scene& a, const Scene& b) {
  if (a.meshes.size() != b.meshes.size()) return false;
  for (std::size_t m = 0; m < a.meshes.size(); ++m) {
    if (a.meshes[m].indices != b.meshes[m].indices) return false;
    if (a.meshes[m].lower != b.meshes[m].lower || a.meshes[m].upper != b.meshes[m].upper) return false;
    for (std::size_t v = 0; v < a.meshes[m].vertices.size(); ++v)
      if (std::memcmp(&a.meshes[m].vertices[v], &b.meshes[m].vertices[v], sizeof(Vertex)) != 0) return false;
  }
  return true;
}

// A triangle with one morph target that moves corner 1 by 2 along x and turns its normal's x by 1.
Gltf morphing_triangle(const std::string& more = "") {
  Gltf gltf = triangle();
  const int position = gltf.add<float>({0, 0, 0, 2, 0, 0, 0, 0, 0}, 5126, "VEC3", 3);
  const int base = gltf.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3", 3);
  const int normal = gltf.add<float>({0, 0, 0, 1, 0, 0, 0, 0, 0}, 5126, "VEC3", 3);
  gltf.mesh = R"("attributes":{"POSITION":0,"NORMAL":)" + std::to_string(base) +
              R"(},"targets":[{"POSITION":)" + std::to_string(position) + R"(,"NORMAL":)" +
              std::to_string(normal) + "}]";
  gltf.node = R"("mesh":0)" + more;
  return gltf;
}

// A triangle that hangs on two joints: corner 0 on the first, corner 1 on the second, corner 2 on both.
Gltf skinned_triangle(const std::string& joints = "[2,3]") {
  Gltf gltf = triangle();
  const int which = gltf.add<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 5121, "VEC4", 3);
  const int how_much = gltf.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, 5126, "VEC4", 3);
  // The second joint stood at (0 3 0) when the skin was bound.
  const int binds = gltf.add<float>(
      {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -3, 0, 1}, 5126,
      "MAT4", 2);
  gltf.mesh = R"("attributes":{"POSITION":0,"JOINTS_0":)" + std::to_string(which) + R"(,"WEIGHTS_0":)" +
              std::to_string(how_much) + "}";
  gltf.node = R"("children":[1,2]},{"mesh":0,"skin":0,"translation":[100,0,0]},)"
              R"({"name":"hip","children":[3]},{"name":"knee","translation":[0,3,0])";
  gltf.rest =
      R"(,"skins":[{"joints":)" + joints + R"(,"inverseBindMatrices":)" + std::to_string(binds) + "}]";
  return gltf;
}

}  // namespace

TEST_CASE("A node moves what it places, and the animation begins again at its end") {
  const AnimatedScene scene = load_moving(sliding_triangle());
  REQUIRE(scene.moves());
  CHECK(scene.duration() == 2.0);
  CHECK(scene.moving_meshes() == std::vector<int>{0});
  CHECK(world(scene.at(0.0), 1) == glm::dvec3(1, 0, 0));
  CHECK(world(scene.at(0.5), 1) == glm::dvec3(2, 0, 0));
  CHECK(world(scene.at(1.5), 1) == glm::dvec3(4, 0, 0));
  CHECK(equal_bits(scene.at(2.0), scene.at(0.0)));
  CHECK(equal_bits(scene.at(7.5), scene.at(1.5)));
  CHECK(scene.swept_bounds(0).upper.x - scene.swept_bounds(0).lower.x == 5.0);
  // From (0 0 0) and (0 1 0) at the start to (5 0 0) at the end, about the middle (2.5, 0.5, 0).
  const std::vector<glm::vec3> outline = scene.outline(0);
  const auto in_outline = [&](const glm::vec3& p) {
    return std::find(outline.begin(), outline.end(), p) != outline.end();
  };
  CHECK(in_outline({-2.5f, -0.5f, 0.0f}));
  CHECK(in_outline({-2.5f, 0.5f, 0.0f}));
  CHECK(in_outline({2.5f, -0.5f, 0.0f}));
  CHECK_FALSE(in_outline({2.5f, 0.5f, 0.0f}));
  // The middle of all that it touches.
  CHECK(scene.at(0.0).origin == glm::dvec3(2.5, 0.5, 0));
}

TEST_CASE("A moment has the same bits whatever moments came before") {
  AnimatedScene scene = load_moving(sliding_triangle());
  const Scene alone = scene.at(1.3);
  Scene kept = scene.take();
  for (const double seconds : {0.0, 0.1, 1.9, 1.3}) scene.move_to(seconds, kept);
  CHECK(equal_bits(alone, kept));
}

TEST_CASE("A file without an animation stands still") {
  const AnimatedScene scene = load_moving(triangle());
  CHECK_FALSE(scene.moves());
  CHECK(scene.duration() == 0.0);
  CHECK(equal_bits(scene.at(0.0), scene.at(3.0)));
}

TEST_CASE("The animation is chosen by name or number, or left out") {
  CHECK(load_moving(sliding_triangle(), "walk").moves());
  CHECK(load_moving(sliding_triangle(), "0").moves());
  CHECK_FALSE(load_moving(sliding_triangle(), "none").moves());
  for (const char* wrong : {"run", "1", "-1"}) {
    try {
      load_moving(sliding_triangle(), wrong);
      FAIL("loaded");
    } catch (const Error& error) {
      CHECK(error.code() == ExitCode::WrongUsage);
      CHECK(contains(error.what(), "0 'walk'"));
    }
  }
}

TEST_CASE("Children, cameras and lights move with the nodes that they hang on") {
  Gltf gltf = triangle();
  gltf.node = R"("children":[1,2,3]},{"mesh":0},{"camera":0,"translation":[0,0,5]},)"
              R"({"extensions":{"KHR_lights_punctual":{"light":0}})";
  gltf.rest = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}],)"
              R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional"}]}})";
  // A quarter turn about y in one second.
  const float half = std::sqrt(0.5f);
  animate(gltf, 0, "rotation", {0, 1}, {0, 0, 0, 1, 0, half, 0, half}, "VEC4");
  const AnimatedScene scene = load_moving(gltf);
  const auto near = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-6; };
  const Scene start = scene.at(0.0), later = scene.at(1.0 - 1e-9);
  CHECK(near(start.cameras[0].position + start.origin, {0, 0, 5}));
  CHECK(near(start.lights[0].direction, {0, 0, -1}));
  CHECK(near(later.cameras[0].position + later.origin, {5, 0, 0}));
  CHECK(near(later.cameras[0].forward, {-1, 0, 0}));
  CHECK(near(later.lights[0].direction, {-1, 0, 0}));
  CHECK(near(world(later, 1), {0, 0, -1}));
  CHECK(near(glm::dvec3(later.meshes[0].vertices[0].normal), {1, 0, 0}));
}

TEST_CASE("A mirrored moment keeps the outer side outside") {
  Gltf gltf = triangle();
  animate(gltf, 0, "scale", {0, 1}, {1, 1, 1, -1, 1, 1}, "VEC3", "STEP");
  const AnimatedScene scene = load_moving(gltf);
  for (const double seconds : {0.0, 1.0}) CHECK(facing(scene.at(seconds).meshes[0], 0).z == 1.0f);
}

TEST_CASE("Morph weights of the file shape a mesh at rest, the node's before the mesh's") {
  Gltf gltf = morphing_triangle(R"(,"weights":[0.25])");
  CHECK(world(load(gltf), 1) == glm::dvec3(1.5, 0, 0));
  CHECK(world(load(morphing_triangle()), 1) == glm::dvec3(1, 0, 0));
}

TEST_CASE("Animated morph weights move positions and normals") {
  Gltf gltf = morphing_triangle();
  animate(gltf, 0, "weights", {0, 1, 2}, {0, 1, 1}, "SCALAR");
  const AnimatedScene scene = load_moving(gltf);
  CHECK(world(scene.at(0.5), 1) == glm::dvec3(2, 0, 0));
  CHECK(world(scene.at(0.5), 0) == glm::dvec3(0, 0, 0));
  CHECK(world(scene.at(1.0), 1) == glm::dvec3(3, 0, 0));
  // (0 0 1) + 1 * (1 0 0), made a unit vector.
  const glm::vec3 normal = scene.at(1.5).meshes[0].vertices[1].normal;
  CHECK(normal.x == Approx(std::sqrt(0.5)));
  CHECK(normal.z == Approx(std::sqrt(0.5)));
}

TEST_CASE("A skinned mesh follows its joints and not its own node") {
  const Scene rest = load(skinned_triangle());
  CHECK(world(rest, 0) == glm::dvec3(0, 0, 0));
  CHECK(world(rest, 1) == glm::dvec3(1, 0, 0));
  CHECK(world(rest, 2) == glm::dvec3(0, 1, 0));
  Gltf gltf = skinned_triangle();
  // The knee goes from (0 3 0) to (0 3 2) in a second, and stays there for one.
  animate(gltf, 3, "translation", {0, 1, 2}, {0, 3, 0, 0, 3, 2, 0, 3, 2}, "VEC3");
  const AnimatedScene scene = load_moving(gltf);
  const Scene later = scene.at(1.5);
  CHECK(world(later, 0) == glm::dvec3(0, 0, 0));
  CHECK(world(later, 1) == glm::dvec3(1, 0, 2));
  CHECK(world(later, 2) == glm::dvec3(0, 1, 1));
  // The knee turns by a quarter about z around itself, 3 m above.
  gltf = skinned_triangle();
  const float half = std::sqrt(0.5f);
  animate(gltf, 3, "rotation", {0, 1}, {0, 0, half, half, 0, 0, half, half}, "VEC4");
  CHECK(glm::length(world(load_moving(gltf).at(0.0), 1) - glm::dvec3(3, 4, 0)) < 1e-6);
}

TEST_CASE("Weights of joints need not add up to one") {
  Gltf gltf = skinned_triangle();
  const int doubled = gltf.add<float>({2, 0, 0, 0, 0, 0, 0, 0, 4, 4, 0, 0}, 5126, "VEC4", 3);
  gltf.mesh.replace(gltf.mesh.find("\"WEIGHTS_0\":2"), 13, "\"WEIGHTS_0\":" + std::to_string(doubled));
  const Scene scene = load(gltf);
  CHECK(world(scene, 2) == glm::dvec3(0, 1, 0));
  CHECK(world(scene, 1) == glm::dvec3(1, 0, 0));
}

TEST_CASE("A vertex hangs on the joints of all its sets, of which 16 are read") {
  // Corner 2 hangs on the hip by its first set and on the knee, which has gone 2 m along z, by its second.
  Gltf gltf = skinned_triangle();
  const int hip = gltf.add<std::uint8_t>(std::vector<std::uint8_t>(12, 0), 5121, "VEC4", 3);
  const int knee = gltf.add<std::uint8_t>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 5121, "VEC4", 3);
  const int all = gltf.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.25f, 0, 0, 0}, 5126, "VEC4", 3);
  const int some = gltf.add<float>({0, 0, 0, 0, 0, 0, 0, 0, 0.75f, 0, 0, 0}, 5126, "VEC4", 3);
  const auto set = [](int n, int joints, int weights) {
    const std::string number = std::to_string(n);
    return "\"JOINTS_" + number + "\":" + std::to_string(joints) + ",\"WEIGHTS_" + number +
           "\":" + std::to_string(weights);
  };
  animate(gltf, 3, "translation", {0, 1, 2}, {0, 3, 0, 0, 3, 2, 0, 3, 2}, "VEC3");
  gltf.mesh = R"("attributes":{"POSITION":0,)" + set(0, hip, all) + "," + set(1, knee, some) + "}";
  CHECK(world(load_moving(gltf).at(1.5), 2) == glm::dvec3(0, 1, 1.5));
  for (const int sets : {16, 17}) {
    gltf.mesh = R"("attributes":{"POSITION":0)";
    for (int n = 0; n < sets; ++n) gltf.mesh += "," + set(n, n == 15 ? knee : hip, n == 15 ? some : all);
    gltf.mesh += "}";
    if (sets == 16)
      CHECK(world(load_moving(gltf).at(1.5), 2).z == Approx(2.0 * 0.75 / (15 * 0.25 + 0.75)));
    else
      CHECK(contains(refusal(gltf), "JOINTS_16: is one set of joints too many"));
  }
}

TEST_CASE("An animator's meshes start from the file at every moment") {
  class Wave final : public MeshAnimator {
   public:
    std::vector<int> meshes() const override { return {0}; }
    void move(double seconds, Scene& scene) override {
      for (Vertex& vertex : scene.meshes[0].vertices) vertex.position.z += static_cast<float>(seconds);
    }
  };
  for (const bool moving : {false, true}) {
    AnimatedScene scene = load_moving(moving ? sliding_triangle() : triangle());
    scene.add(std::make_shared<Wave>());
    CHECK(scene.moves());
    CHECK(scene.moving_meshes() == std::vector<int>{0});
    scene.at(5.0);
    const Scene later = scene.at(3.0);
    CHECK(world(later, 0).z == 3.0);
    CHECK(later.meshes[0].upper.z == 3.0f);
    CHECK(world(later, 0).x == (moving ? 2.0 : 0.0));
  }
}

TEST_CASE("An animator of a mesh that the scene lacks is refused") {
  class Stray final : public MeshAnimator {
   public:
    std::vector<int> meshes() const override { return {7}; }
    void move(double, Scene&) override {}
  };
  AnimatedScene scene = load_moving(triangle());
  CHECK_THROWS_AS(scene.add(std::make_shared<Stray>()), Error);
}

// Twelve nodes, one in the other, whose scales are 1 at the file's moments and rise to 1e29 between them:
// 1e348 together.
TEST_CASE("A motion that overflows between its moments is refused there") {
  constexpr int kDepth = 12;
  Gltf gltf = triangle();
  std::vector<float> values;
  for (int moment = 0; moment < 2; ++moment)  // tangent in, value, tangent out
    for (const float part : {moment ? -9e29f : 0.0f, 1.0f, moment ? 0.0f : 9e29f})
      values.insert(values.end(), {part, 1.0f, 1.0f});
  gltf.add<float>({0, 2}, 5126, "SCALAR", 2);
  gltf.add(values, 5126, "VEC3", 6);
  std::string channels;
  gltf.node = R"("children":[1])";
  for (int node = 0; node < kDepth; ++node) {
    channels += std::string(node ? "," : "") + R"({"sampler":0,"target":{"node":)" + std::to_string(node) +
                R"(,"path":"scale"}})";
    if (node > 1) gltf.node += R"(},{"children":[)" + std::to_string(node) + "]";
  }
  gltf.node += R"(},{"mesh":0)";
  gltf.rest =
      R"(,"animations":[{"samplers":[{"input":1,"output":2,"interpolation":"CUBICSPLINE"}],"channels":[)" +
      channels + "]}]";
  std::string message;
  try {
    load_moving(gltf).at(1.0);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::BadInput);
    message = error.what();
  }
  CHECK(contains(message, "its transform is not finite"));
}

TEST_CASE("Channels without a node and of other properties are left out with a note") {
  Gltf gltf = sliding_triangle();
  const std::string node = R"("node":0,)";
  gltf.rest.erase(gltf.rest.find(node), node.size());
  const AnimatedScene scene = load_moving(gltf);
  CHECK_FALSE(scene.moves());
  CHECK(has_note(scene.start(), "no node"));
  Gltf other = sliding_triangle();
  other.rest.replace(other.rest.find("\"translation\""), 13, "\"pointer\"");
  CHECK(has_note(load_moving(other).start(), "'pointer'"));
}

TEST_CASE("Bad animations are refused in one line") {
  const auto sampled = [](const std::vector<float>& times, const std::vector<float>& values,
                          const std::string& path = "translation", const std::string& type = "VEC3",
                          const std::string& interpolation = "LINEAR") {
    Gltf gltf = triangle();
    animate(gltf, 0, path, times, values, type, interpolation);
    return gltf;
  };
  const float nan = std::nanf("");
  CHECK(contains(refusal(sampled({1, 1}, {0, 0, 0, 1, 1, 1})), "time 1 is not later"));
  CHECK(contains(refusal(sampled({2, 1}, {0, 0, 0, 1, 1, 1})), "time 1 is not later"));
  CHECK(contains(refusal(sampled({nan, 1}, {0, 0, 0, 1, 1, 1})), "time 0"));
  CHECK(contains(refusal(sampled({-1, 1}, {0, 0, 0, 1, 1, 1})), "time 0"));
  CHECK(contains(refusal(sampled({0, 1}, {0, 0, nan, 1, 1, 1})), "value 0 is not finite"));
  CHECK(contains(refusal(sampled({0, 1}, {0, 0, 0})), "1 values for 2 moments"));
  CHECK(contains(refusal(sampled({0, 1}, {0, 0, 0, 1, 1, 1}, "translation", "VEC3", "CUBICSPLINE")),
                 "2 values for 2 moments of 3"));
  CHECK(contains(refusal(sampled({0, 1}, {0, 0, 0, 1, 1, 1, 1, 1}, "translation", "VEC4")), "wrong type"));
  CHECK(contains(refusal(sampled({0, 1}, {0, 0, 0, 1, 1, 1}, "rotation")), "wrong type"));
  CHECK(contains(refusal(sampled({0, 1}, {0, 1}, "weights", "SCALAR")), "no morph targets"));
  CHECK(contains(refusal(sampled({0, 1}, {0, 0, 0, 1, 1, 1}, "translation", "VEC3", "LOOSE")),
                 "use STEP, LINEAR or CUBICSPLINE"));
  CHECK(contains(refusal(sampled({0, 1}, {0, 0, 0, 1e29f, 1, 1})), "1e12 m"));
}

TEST_CASE("Bad references of animations are refused in one line") {
  const auto changed = [](const std::string& from, const std::string& to) {
    Gltf gltf = sliding_triangle();
    gltf.rest.replace(gltf.rest.find(from), from.size(), to);
    return refusal(gltf);
  };
  CHECK(contains(changed(R"("sampler":0)", R"("sampler":7)"), "samplers[7]"));
  CHECK(contains(changed(R"("node":0)", R"("node":9)"), "nodes[9]"));
  CHECK(contains(changed(R"("input":1)", R"("input":55)"), "accessors[55]"));
  CHECK(contains(changed(R"("output":2)", R"("output":-1)"), "accessors[-1]"));
  CHECK(contains(changed(R"("samplers":[)", R"("samplers":[7,)"), "must be an object"));
  Gltf matrix = sliding_triangle();
  matrix.node += R"(,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])";
  CHECK(contains(refusal(matrix), "matrix"));
}

TEST_CASE("Animations beyond the limit on values are refused") {
  LoadOptions options;
  options.max_animation_values = 7;  // there are two moments of three
  CHECK(contains(refusal(sliding_triangle().json(), options), "more than 7 values"));
  options.max_animation_values = 8;
  CHECK_NOTHROW(load_text(sliding_triangle().json(), options));
}

TEST_CASE("Bad skins are refused in one line") {
  CHECK(contains(refusal(skinned_triangle("[2,77]")), "nodes[77]"));
  CHECK(contains(refusal(skinned_triangle("[2,2]")), "a joint twice"));
  CHECK(contains(refusal(skinned_triangle("[]")), "no joints"));
  CHECK(contains(refusal(skinned_triangle("[2]")), "hangs on joint 1, but the skin has 1"));
  CHECK(contains(refusal(skinned_triangle("[0,2,3]")), "2 matrices for 3 joints"));
  Gltf outside = skinned_triangle();
  outside.node.replace(outside.node.find("[1,2]"), 5, "[1]");
  CHECK(contains(refusal(outside), "is not in the scene"));
  Gltf cycle = skinned_triangle();
  cycle.node += R"(,"children":[2])";
  CHECK(contains(refusal(cycle), "reached twice"));
  Gltf lonely = skinned_triangle();
  lonely.mesh.erase(lonely.mesh.find(",\"WEIGHTS_0\""), 14);
  CHECK(contains(refusal(lonely), "no WEIGHTS"));
  Gltf few = skinned_triangle();
  const int two = few.add<float>({1, 0, 0, 0, 1, 0, 0, 0}, 5126, "VEC4", 2);
  few.mesh.replace(few.mesh.find("\"WEIGHTS_0\":2"), 13, "\"WEIGHTS_0\":" + std::to_string(two));
  CHECK(contains(refusal(few), "2 elements, POSITION 3"));
  Gltf floats = skinned_triangle();
  floats.mesh.replace(floats.mesh.find("\"JOINTS_0\":1"), 12, "\"JOINTS_0\":2");
  CHECK(contains(refusal(floats), "JOINTS_0: must be unsigned bytes or shorts"));
  Gltf flat = skinned_triangle();
  flat.add<float>(std::vector<float>(18, 1.0f), 5126, "MAT3", 2);
  flat.rest.replace(flat.rest.find("\"inverseBindMatrices\":3"), 23, "\"inverseBindMatrices\":4");
  CHECK(contains(refusal(flat), "must be matrices of 4x4 floats"));
  Gltf negative = skinned_triangle();
  negative.add<float>({-1, 0, 0, 0, 0.5f, 0, 0, 0, 0.5f, 0.5f, 0, 0}, 5126, "VEC4", 3);
  negative.mesh.replace(negative.mesh.find("\"WEIGHTS_0\":2"), 13, "\"WEIGHTS_0\":4");
  CHECK(contains(refusal(negative), "vertex 0 has a weight below 0 or not finite"));
}

TEST_CASE("Bad morph targets are refused in one line") {
  CHECK(contains(refusal(morphing_triangle(R"(,"weights":[0,1])")), "must have 1 numbers, has 2"));
  Gltf gltf = morphing_triangle();
  gltf.mesh.replace(gltf.mesh.find("[{\"POSITION\":1"), 14, "[{\"POSITION\":99");
  CHECK(contains(refusal(gltf), "accessors[99]"));
  Gltf few = morphing_triangle();
  const int two = few.add<float>({0, 0, 0, 2, 0, 0}, 5126, "VEC3", 2);
  few.mesh.replace(few.mesh.find("[{\"POSITION\":1"), 14, "[{\"POSITION\":" + std::to_string(two));
  CHECK(contains(refusal(few), "2 elements, POSITION 3"));
  Gltf plane = morphing_triangle();
  plane.add<float>({0, 0, 2, 0, 0, 0}, 5126, "VEC2", 3);
  plane.mesh.replace(plane.mesh.find("[{\"POSITION\":1"), 14, "[{\"POSITION\":4");
  CHECK(contains(refusal(plane), "wrong type for a morph target"));
  Gltf wild = morphing_triangle();
  const int bad = wild.add<float>({0, 0, 0, std::nanf(""), 0, 0, 0, 0, 0}, 5126, "VEC3", 3);
  wild.mesh.replace(wild.mesh.find("[{\"POSITION\":1"), 14, "[{\"POSITION\":" + std::to_string(bad));
  CHECK(contains(refusal(wild), "not finite"));
}
