// Lights and cameras.
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Gltf lit(const std::string& light, const std::string& node = "") {
  Gltf gltf = triangle();
  gltf.node = R"("mesh":0,"children":[1]},{"extensions":{"KHR_lights_punctual":{"light":0}})" + node;
  gltf.rest = R"(,"extensions":{"KHR_lights_punctual":{"lights":[{)" + light + "}]}}";
  return gltf;
}

Gltf seen(const std::string& camera, const std::string& node = "") {
  Gltf gltf = triangle();
  gltf.node = R"("mesh":0,"children":[1]},{"camera":0)" + node;
  gltf.rest = R"(,"cameras":[{)" + camera + "}]";
  return gltf;
}

const std::string kLight = "extensions.KHR_lights_punctual.lights[0]";

}  // namespace

TEST_CASE("A light without members is white, of intensity 1, and reaches everywhere") {
  const Scene scene = load(lit(R"("type":"point")", R"(,"translation":[1,2,3])"));
  REQUIRE(scene.lights.size() == 1);
  const Light& light = scene.lights[0];
  CHECK(light.type == LightType::Point);
  CHECK(light.color == glm::vec3(1));
  CHECK(light.intensity == 1.0f);
  CHECK(light.range == std::numeric_limits<float>::infinity());
  CHECK(light.position + scene.origin == glm::dvec3(1, 2, 3));
}

TEST_CASE("A directional light shines along its node's -z, whatever the scale") {
  const Scene scene = load(lit(R"("type":"directional","intensity":5)",
                               R"(,"scale":[3,3,3],"rotation":[-0.7071067811865475,0,0,
                                  0.7071067811865475])"));
  const Light& light = scene.lights.at(0);
  CHECK(light.intensity == 5.0f);
  CHECK(light.direction.y == Approx(-1));
  CHECK(light.direction.z == Approx(0).margin(1e-12));
}

TEST_CASE("Spot cones are put in order, with a note") {
  const Scene good = load(lit(R"("type":"spot","spot":{"innerConeAngle":0.2,"outerConeAngle":0.4})"));
  CHECK(good.lights.at(0).inner_cone == 0.2f);
  CHECK(good.lights[0].outer_cone == 0.4f);
  const Light plain = load(lit(R"("type":"spot","spot":{})")).lights.at(0);
  CHECK(plain.inner_cone == 0.0f);
  CHECK(plain.outer_cone == Approx(3.14159265358979 / 4));
  const Scene swapped = load(lit(R"("type":"spot","spot":{"innerConeAngle":0.9,"outerConeAngle":0.4})"));
  CHECK(swapped.lights.at(0).inner_cone == 0.4f);
  CHECK(has_note(swapped, "innerConeAngle"));
}

TEST_CASE("A negative intensity switches the light off, and unknown types are refused") {
  const Scene off = load(lit(R"("type":"point","intensity":-3)"));
  CHECK(off.lights.at(0).intensity == 0.0f);
  CHECK(has_note(off, kLight + ".intensity is negative"));
  CHECK(contains(refusal(lit(R"("type":"area")")), kLight + ".type: is \"area\""));
  CHECK(contains(refusal(lit(R"("type":"spot")")), kLight + ".spot: is missing"));
  CHECK(contains(refusal(lit(R"("intensity":1)")), kLight + ".type: is missing"));
  CHECK(contains(refusal(lit(R"("type":"point","color":[1,1])")), kLight + ".color: must have 3"));
}

TEST_CASE("Extras give a light its size") {
  const Scene ball = load(lit(R"("type":"point","extras":{"radius":0.25})"));
  CHECK(ball.lights.at(0).shape == LightShape::Sphere);
  CHECK(ball.lights[0].radius == 0.25);
  const Scene sun = load(lit(R"("type":"directional","extras":{"angular_diameter":0.53})"));
  CHECK(sun.lights.at(0).shape == LightShape::Disk);
  CHECK(sun.lights[0].angular_radius == Approx(0.53 * 3.14159265358979 / 360.0));
  // The node's own word counts more, and its scale does not.
  const Scene panel = load(lit(R"("type":"point","extras":{"rectangle":[9,9]})",
                               R"(,"scale":[3,3,3],"extras":{"rectangle":[2,0.5]})"));
  const Light& light = panel.lights.at(0);
  CHECK(light.shape == LightShape::Rectangle);
  CHECK(light.lambertian);
  CHECK(light.direction == glm::dvec3(0, 0, -1));
  CHECK(light.width == glm::dvec3(2, 0, 0));
  CHECK(light.height == glm::dvec3(0, 0.5, 0));
  const Scene spot = load(lit(R"("type":"spot","spot":{},"extras":{"rectangle":[2,0.5]})"));
  CHECK_FALSE(spot.lights.at(0).lambertian);
}

TEST_CASE("Extras that say nothing of this light's size leave it a point") {
  for (const char* extras :
       {"7", R"("radius")", "[1]", "{}", R"({"radius":0})", R"({"rectangle":[0,0]})", R"({"size":3})"}) {
    INFO(extras);
    const Scene scene = load(lit(R"("type":"point","extras":)" + std::string(extras)));
    CHECK(scene.lights.at(0).shape == LightShape::None);
  }
  const Scene sun = load(lit(R"("type":"directional","extras":{"radius":1})"));
  CHECK(sun.lights.at(0).shape == LightShape::None);
  CHECK(has_note(sun, kLight + ".extras.radius is not for directional lights"));
  const Scene lamp = load(lit(R"("type":"point","extras":{"angular_diameter":1})"));
  CHECK(lamp.lights.at(0).shape == LightShape::None);
  CHECK(has_note(lamp, kLight + ".extras.angular_diameter is for directional lights"));
}

TEST_CASE("Sizes that are none are refused") {
  const auto said = [](const char* type, const char* extras) {
    return refusal(lit(R"("type":")" + std::string(type) + R"(","extras":{)" + extras + "}"));
  };
  const std::string where = kLight + ".extras.";
  CHECK(contains(said("point", R"("radius":-1)"), where + "radius: must be a radius from 0"));
  CHECK(contains(said("point", R"("radius":2e9)"), where + "radius: must be a radius from 0"));
  CHECK(contains(said("point", R"("radius":"big")"), where + "radius: must be a number"));
  CHECK(contains(said("point", R"("radius":null)"), where + "radius: must be a number"));
  CHECK(contains(said("point", R"("rectangle":2)"), where + "rectangle: must be an array"));
  CHECK(contains(said("point", R"("rectangle":[1,2,3])"), where + "rectangle: must have 2"));
  CHECK(contains(said("point", R"("rectangle":[1,-2])"), where + "rectangle: must be two sides"));
  CHECK(contains(said("point", R"("radius":1,"rectangle":[1,2])"), "one of both"));
  CHECK(contains(said("directional", R"("angular_diameter":181)"), "from 0 to 180 degrees"));
  CHECK(contains(said("directional", R"("angular_diameter":-0.5)"), "from 0 to 180 degrees"));
  CHECK_FALSE(said("point", R"("radius":1e999)").empty());
}

TEST_CASE("A node cannot refer to a light that is not there, nor aim one without a direction") {
  Gltf gltf = lit(R"("type":"point")");
  gltf.rest.clear();
  CHECK(contains(refusal(gltf), "nodes[1].extensions.KHR_lights_punctual.light: refers to"));
  const std::string flat = R"(,"scale":[1,1,0])";
  CHECK(contains(refusal(lit(R"("type":"directional")", flat)), "nodes[1]: "));
}

TEST_CASE("A perspective camera keeps its angle, and without zfar it sees to infinity") {
  const Scene scene = load(seen(R"("name":"eye","type":"perspective","perspective":{"yfov":0.7,"znear":0.1})",
                                R"(,"translation":[0,0,5],"scale":[2,-2,2])"));
  const Camera& camera = scene.cameras.at(0);
  CHECK(camera.name == "eye");
  CHECK(camera.vertical_fov == 0.7);
  CHECK(camera.near == 0.1);
  CHECK(camera.far == std::numeric_limits<double>::infinity());
  CHECK(camera.forward == glm::dvec3(0, 0, -1));
  CHECK(glm::length(camera.up) == Approx(1));
  const glm::dvec3 back = glm::cross(camera.right, camera.up);
  CHECK(glm::dot(back, camera.forward) == Approx(-1));
}

TEST_CASE("An orthographic camera keeps its half sizes") {
  const Scene scene =
      load(seen(R"("type":"orthographic","orthographic":{"xmag":3,"ymag":2,"znear":0,"zfar":10})"));
  CHECK(scene.cameras.at(0).orthographic);
  CHECK(scene.cameras[0].half_width == 3.0);
  CHECK(scene.cameras[0].half_height == 2.0);
  CHECK(scene.cameras[0].far == 10.0);
}

TEST_CASE("Cameras that see nothing are refused") {
  CHECK(contains(refusal(seen(R"("type":"perspective","perspective":{"yfov":4,"znear":0.1})")),
                 "cameras[0].perspective.yfov: "));
  CHECK(contains(refusal(seen(R"("type":"perspective","perspective":{"yfov":1,"znear":0})")),
                 "cameras[0].perspective.znear: "));
  CHECK(contains(
      refusal(seen(R"("type":"orthographic","orthographic":{"xmag":0,"ymag":1,"znear":0,"zfar":1})")),
      "cameras[0].orthographic.xmag: "));
  CHECK(contains(refusal(seen(R"("type":"fisheye")")), "cameras[0].type: "));
}
