// One property of a glTF file after the other is changed: the loaded scene changes in the stated way and in
// no other.
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

#include "tests/scene/file_of_all.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

using Description = std::map<std::string, std::string>;  // what each thing of a scene is, by its name

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", std::abs(value) < 1e-12 ? 0.0 : value);  // rotations round
  return text;
}
std::string shown(const glm::dvec3& v) { return shown(v.x) + " " + shown(v.y) + " " + shown(v.z); }
std::string shown(const Image& image) {
  double sum = 0.0;  // of texels, each with a weight of its own
  for (std::size_t i = 0; i < image.values.size(); ++i)
    sum += static_cast<double>(image.values[i]) * static_cast<double>(i + 1);
  return std::to_string(image.width()) + "x" + std::to_string(image.height()) + " " + shown(sum);
}

void describe(Description& all, const std::string& name, const TextureUse& use, const Scene& scene) {
  all[name] = use.present() ? shown(scene.images.at(static_cast<std::size_t>(use.image))) : "none";
  if (!use.present()) return;
  const glm::vec3 corner = use.uv_transform * glm::vec3(0, 0, 1), far = use.uv_transform * glm::vec3(1, 2, 1);
  all[name + ".at"] = shown(corner) + ", " + shown(far);
  all[name + ".wrap"] =
      std::to_string(static_cast<int>(use.wrap_u)) + std::to_string(static_cast<int>(use.wrap_v));
  all[name + ".nearest"] = std::to_string(use.nearest);
}

void describe(Description& all, const std::string& name, const Material& m, const Scene& scene) {
  all[name + ".base_color"] = shown(glm::dvec3(m.base_color)) + " " + shown(m.base_color.a);
  all[name + ".emissive"] = shown(glm::dvec3(m.emissive));
  all[name + ".attenuation_color"] = shown(glm::dvec3(m.attenuation_color));
  all[name + ".alpha_mode"] = std::to_string(static_cast<int>(m.alpha_mode));
  all[name + ".double_sided"] = std::to_string(m.double_sided);
  all[name + ".unlit"] = std::to_string(m.unlit);
  for (const auto& [key, value] : {std::pair{".least_alpha", m.least_alpha},
                                   {".most_alpha", m.most_alpha},
                                   {".normal_scale", m.normal_scale},
                                   {".alpha_cutoff", m.alpha_cutoff},
                                   {".metallic", m.metallic},
                                   {".roughness", m.roughness},
                                   {".metallic_factor", m.metallic_factor},
                                   {".roughness_factor", m.roughness_factor},
                                   {".occlusion_strength", m.occlusion_strength},
                                   {".transmission", m.transmission},
                                   {".ior", m.ior},
                                   {".thickness", m.thickness},
                                   {".attenuation_distance", m.attenuation_distance},
                                   {".dispersion", m.dispersion}})
    all[name + key] = shown(static_cast<double>(value));
  describe(all, name + ".base_color_texture", m.base_color_texture, scene);
  describe(all, name + ".normal_texture", m.normal_texture, scene);
  describe(all, name + ".emissive_texture", m.emissive_texture, scene);
  describe(all, name + ".metallic_roughness_texture", m.metallic_roughness_texture, scene);
  describe(all, name + ".occlusion_texture", m.occlusion_texture, scene);
  describe(all, name + ".transmission_texture", m.transmission_texture, scene);
}

void describe(Description& all, const std::string& name, const Light& light, const Scene& scene) {
  all[name + ".type"] = std::to_string(static_cast<int>(light.type));
  all[name + ".color"] = shown(glm::dvec3(light.color));
  all[name + ".position"] = shown(light.position + scene.origin);
  all[name + ".direction"] = shown(light.direction);
  all[name + ".shape"] = std::to_string(static_cast<int>(light.shape)) + std::to_string(light.lambertian);
  all[name + ".size"] = shown(light.radius) + " " + shown(light.angular_radius) + ", " + shown(light.width) +
                        ", " + shown(light.height);
  all[name + ".cones"] = shown(light.inner_cone) + " " + shown(light.outer_cone);
  all[name + ".intensity"] = shown(light.intensity);
  all[name + ".range"] = shown(light.range);
}

void describe(Description& all, const std::string& name, const Camera& camera, const Scene& scene) {
  all[name + ".kind"] = camera.orthographic ? "orthographic" : "perspective";
  all[name + ".position"] = shown(camera.position + scene.origin);
  all[name + ".axes"] = shown(camera.right) + ", " + shown(camera.up) + ", " + shown(camera.forward);
  if (camera.orthographic) all[name + ".half_width"] = shown(camera.half_width);
  if (camera.orthographic) all[name + ".half_height"] = shown(camera.half_height);
  if (!camera.orthographic) all[name + ".fov"] = shown(camera.vertical_fov);
  all[name + ".near"] = shown(camera.near);
  all[name + ".far"] = shown(camera.far);
}

Description described(const std::string& text) {
  const Scene scene = load_text(text);
  Description all;
  const auto list = [&all, &scene](const std::string& name, const auto& things) {
    all[name] = std::to_string(things.size());
    for (const auto& thing : things) {
      all[name + " " + thing.name];
      describe(all, thing.name, thing, scene);
    }
  };
  list("materials", scene.materials);
  list("lights", scene.lights);
  list("cameras", scene.cameras);
  all["images"] = std::to_string(scene.images.size());
  for (const Mesh& mesh : scene.meshes) {
    std::string& corners = all["mesh " + mesh.name];
    for (const std::uint32_t i : mesh.indices) {
      const Vertex& vertex = mesh.vertices.at(i);
      corners += shown(glm::dvec3(world(scene, vertex))) + " uv " + shown(vertex.uv.x) + " " +
                 shown(vertex.uv.y) + "; ";
    }
    all["material of " + mesh.name] = scene.materials.at(static_cast<std::size_t>(mesh.material)).name;
  }
  all["medium.scattering"] = shown(glm::dvec3(scene.medium.scattering));
  all["medium.absorption"] = shown(glm::dvec3(scene.medium.absorption));
  all["medium.anisotropy"] = shown(scene.medium.anisotropy);
  return all;
}

struct Change {
  std::string from, to;
  Description changed;  // all that is then otherwise
};

const Change kChanges[] = {
    {R"("baseColorFactor":[0.1,0.2,0.3,0.4])",
     R"("baseColorFactor":[0.5,0.6,0.7,0.8])",
     {{"coat.base_color", "0.5 0.6 0.7 0.8"}}},
    {R"("metallicFactor":0.125)",
     R"("metallicFactor":0.25)",
     {{"coat.metallic", "0.25"}, {"coat.metallic_factor", "0.25"}}},
    {R"("roughnessFactor":0.375)",
     R"("roughnessFactor":0.5)",
     {{"coat.roughness", "0.5"}, {"coat.roughness_factor", "0.5"}}},
    {R"("metallicFactor":0.0625)",
     R"("metallicFactor":0.5)",
     {{"glass.metallic", "0.5"}, {"glass.metallic_factor", "0.5"}}},
    {R"("doubleSided":true)", R"("doubleSided":false)", {{"coat.double_sided", "0"}}},
    {R"("alphaMode":"MASK")", R"("alphaMode":"OPAQUE")", {{"coat.alpha_mode", "0"}}},
    // Alpha 128 of 255, everywhere, as a half float.
    {R"("alphaMode":"MASK")",
     R"("alphaMode":"BLEND")",
     {{"coat.alpha_mode", "2"}, {"coat.least_alpha", "0.50195"}, {"coat.most_alpha", "0.50195"}}},
    {R"("alphaCutoff":0.25)", R"("alphaCutoff":0.75)", {{"coat.alpha_cutoff", "0.75"}}},
    {R"("emissiveFactor":[0.1,0.2,0.3])",
     R"("emissiveFactor":[0.4,0.5,0.6])",
     {{"coat.emissive", "2 2.5 3"}}},
    {R"("emissiveStrength":5)", R"("emissiveStrength":50)", {{"coat.emissive", "5 10 15"}}},
    {R"("scale":0.7)", R"("scale":-1.5)", {{"coat.normal_scale", "-1.5"}}},
    {R"("strength":0.6)", R"("strength":0.1)", {{"coat.occlusion_strength", "0.1"}}},
    {R"("transmissionFactor":0.75)", R"("transmissionFactor":0.25)", {{"glass.transmission", "0.25"}}},
    {R"("ior":1.25)", R"("ior":1.75)", {{"glass.ior", "1.75"}}},
    {R"("thicknessFactor":0.3)", R"("thicknessFactor":0.6)", {{"glass.thickness", "0.6"}}},
    {R"("attenuationDistance":0.9)", R"("attenuationDistance":0.4)", {{"glass.attenuation_distance", "0.4"}}},
    {R"("attenuationColor":[0.8,0.7,0.6])",
     R"("attenuationColor":[0.5,0.4,0.3])",
     {{"glass.attenuation_color", "0.5 0.4 0.3"}}},
    {R"("dispersion":0.45)", R"("dispersion":0.9)", {{"glass.dispersion", "0.9"}}},
    {R"("wrapS":33071)", R"("wrapS":10497)", {{"coat.base_color_texture.wrap", "02"}}},
    {R"("wrapT":33648)", R"("wrapT":33071)", {{"coat.base_color_texture.wrap", "11"}}},
    {R"("magFilter":9728)", R"("magFilter":9729)", {{"coat.base_color_texture.nearest", "0"}}},
    {R"("baseColorTexture":{"index":0})",
     R"("baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":)"
     R"({"offset":[0.25,0.5],"scale":[2,4]}}})",
     // v is turned over: 1 - (0.5 + 4 v), and u is 0.25 + 2 u.
     {{"coat.base_color_texture.at", "0.25 0.5 1, 2.25 -7.5 1"}}},
    {R"("material":0)", R"("material":1)", {{"material of first", "glass"}, {"material of second", "glass"}}},
    {R"("translation":[4,0,0])",
     R"("translation":[5,0,-1])",
     {{"mesh second", "5 0 -1 uv 0 0; 7 0 -1 uv 1 0; 5 3 -1 uv 0 1; "}}},
    {R"("scale":[2,3,1])",
     R"("scale":[1,2,5])",
     {{"mesh second", "4 0 0 uv 0 0; 5 0 0 uv 1 0; 4 2 0 uv 0 1; "}}},
    // A quarter turn about z: x becomes y.
    {R"("translation":[4,0,0],)",
     R"("translation":[4,0,0],"rotation":[0,0,0.7071067811865476,0.7071067811865476],)",
     {{"mesh second", "4 0 0 uv 0 0; 4 2 0 uv 1 0; 1 0 0 uv 0 1; "}}},
    {R"("intensity":7)", R"("intensity":8)", {{"sun.intensity", "8"}}},
    {R"("intensity":90)", R"("intensity":80)", {{"lamp.intensity", "80"}}},
    {R"("color":[0.9,0.8,0.7])", R"("color":[0.1,0.2,0.3])", {{"sun.color", "0.1 0.2 0.3"}}},
    {R"("color":[0.6,0.5,0.4])", R"("color":[0.4,0.5,0.6])", {{"lamp.color", "0.4 0.5 0.6"}}},
    {R"("range":30)", R"("range":20)", {{"lamp.range", "20"}}},
    {R"("innerConeAngle":0.2)", R"("innerConeAngle":0.3)", {{"lamp.cones", "0.3 0.4"}}},
    {R"("outerConeAngle":0.4)", R"("outerConeAngle":0.8)", {{"lamp.cones", "0.2 0.8"}}},
    {R"("translation":[1,5,2])", R"("translation":[2,6,3])", {{"lamp.position", "2 6 3"}}},
    {R"({"angular_diameter":0.5})", R"({"angular_diameter":2})", {{"sun.size", "0 0.017453, 0 0 0, 0 0 0"}}},
    {R"({"radius":0.02})", R"({"radius":0.05})", {{"lamp.size", "0.05 0, 0 0 0, 0 0 0"}}},
    {R"({"radius":0.02})",
     R"({"rectangle":[0.5,0.25]})",
     {{"lamp.size", "0 0, 0.5 0 0, 0 0.25 0"}, {"lamp.shape", "20"}}},
    {R"("yfov":0.5)", R"("yfov":0.9)", {{"near.fov", "0.9"}}},
    {R"("znear":0.1)", R"("znear":0.3)", {{"near.near", "0.3"}}},
    {R"("zfar":50)", R"("zfar":40)", {{"near.far", "40"}}},
    {R"("xmag":3)", R"("xmag":4)", {{"flat.half_width", "4"}}},
    {R"("ymag":2)", R"("ymag":5)", {{"flat.half_height", "5"}}},
    {R"("znear":0.2)", R"("znear":0.4)", {{"flat.near", "0.4"}}},
    {R"("zfar":60)", R"("zfar":70)", {{"flat.far", "70"}}},
    {R"("translation":[0,1,9])", R"("translation":[1,2,3])", {{"near.position", "1 2 3"}}},
    {R"("translation":[0,2,8])", R"("translation":[3,2,1])", {{"flat.position", "3 2 1"}}},
    // A quarter turn about y: what looked along -z looks along -x.
    {R"("translation":[0,1,9])",
     R"("translation":[0,1,9],"rotation":[0,0.7071067811865476,0,0.7071067811865476])",
     {{"near.axes", "0 0 -1, 0 1 0, -1 0 0"}}},
    {R"("scattering":0.5)", R"("scattering":[0.5,0.6,0.7])", {{"medium.scattering", "0.5 0.6 0.7"}}},
    {R"("absorption":[0.1,0.2,0.3])",
     R"("absorption":[0.3,0.1,0.2])",
     {{"medium.absorption", "0.3 0.1 0.2"}}},
    {R"("anisotropy":0.35)", R"("anisotropy":-0.6)", {{"medium.anisotropy", "-0.6"}}},
};

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = file_of_all();
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  REQUIRE(text.find(from, at + 1) == std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string text_of(const Description& all) {
  std::string text;
  for (const auto& [name, value] : all) text += name + " is " + value + "\n";
  return text;
}

// What of a description is otherwise, gone or new in another.
Description difference(const Description& from, const Description& to) {
  Description changed;
  for (const auto& [name, value] : to)
    if (const auto before = from.find(name); before == from.end() || before->second != value)
      changed[name] = value;
  for (const auto& [name, value] : from)
    if (to.find(name) == to.end()) changed[name] = "gone";
  return changed;
}

}  // namespace

TEST_CASE("one change: each property of a file changes the scene in its own way and in no other") {
  const Description before = described(file_of_all());
  for (const Change& change : kChanges) {
    INFO(change.from << " becomes " << change.to);
    CHECK(text_of(difference(before, described(replaced(change.from, change.to)))) ==
          text_of(change.changed));
  }
}

TEST_CASE("one change: what refers to another texture, image or set of coordinates gets that one's") {
  const Description before = described(file_of_all());
  // Beside alpha, the two pictures differ: each texture of the first material shows its own.
  const std::string first = before.at("coat.base_color_texture"), second = before.at("coat.emissive_texture");
  REQUIRE(first != second);
  const Description base = difference(
      before, described(replaced(R"("baseColorTexture":{"index":0})", R"("baseColorTexture":{"index":2})")));
  CHECK(base.at("coat.base_color_texture") == second);
  CHECK(base.count("coat.emissive_texture") == 0);
  const Description emissive = difference(
      before, described(replaced(R"("emissiveTexture":{"index":2})", R"("emissiveTexture":{"index":0})")));
  CHECK(emissive.at("coat.emissive_texture") == first);
  CHECK(emissive.count("coat.base_color_texture") == 0);
  const Description source =
      difference(before, described(replaced(R"({"source":0,"sampler":0})", R"({"source":1,"sampler":0})")));
  CHECK(text_of(source) == text_of({{"coat.base_color_texture", second}, {"images", source.at("images")}}));
}

TEST_CASE("one change: another light in a node's place stands there") {
  const Description after = described(replaced(R"({"light":1})", R"({"light":0})"));
  CHECK(after.at("lights") == "2");
  CHECK(after.at("lamp.intensity") == "7");
  CHECK(after.at("lamp.type") == after.at("sun.type"));
  CHECK(after.at("lamp.position") == "1 5 2");
}
