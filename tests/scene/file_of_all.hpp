// A glTF file in which all that light depends on is said, and nothing at its default.
#pragma once
#include <string>

#include "tests/scene/gltf_builder.hpp"

namespace caustics::test {

// Two of everything.
inline std::string file_of_all() {
  // 2x2 texels: red 255, 0 over 188, 188, alpha 128; and alpha 204, 51 over 102, 153.
  const std::string red =
      "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAFElEQVR42mP4z8DQwADCe4AECAMAKNEEeM/"
      "2UfoAAAAASUVORK5CYII=";
  const std::string veil =
      "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAFklEQVR42mPg+"
      "iV3BoiNGYBEGhDPBAA6iwaHbzjEJAAAAABJRU5ErkJggg==";
  Gltf gltf = triangle();
  gltf.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC2", 3);
  gltf.add<float>({0.5f, 0.5f, 0.25f, 0.5f, 0.5f, 0.75f}, 5126, "VEC2", 3);
  // Two more meshes, so that both materials are used whatever the first one has.
  gltf.mesh = R"("attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":2},"material":0}]},
    {"primitives":[{"attributes":{"POSITION":0},"material": 1}]},
    {"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material": 0)";
  gltf.node = R"("mesh":0,"name":"first","children":[1,2,3,4,5,6,7]},
    {"mesh":0,"name":"second","translation":[4,0,0],"scale":[2,3,1]},
    {"name":"sun","extensions":{"KHR_lights_punctual":{"light":0}}},
    {"name":"lamp","translation":[1,5,2],"extensions":{"KHR_lights_punctual":{"light":1}}},
    {"name":"near","camera":0,"translation":[0,1,9]},
    {"name":"flat","camera":1,"translation":[0,2,8]},
    {"name":"third","mesh":1},{"name":"fourth","mesh":2)";
  gltf.rest = R"(,"materials":[
    {"name":"coat","doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.25,"emissiveFactor":[0.1,0.2,0.3],
     "pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],"metallicFactor":0.125,
       "roughnessFactor":0.375,
       "baseColorTexture":{"index":0}},
     "normalTexture":{"index":1,"scale":0.7},"emissiveTexture":{"index":2},
     "occlusionTexture":{"index":1,"strength":0.6},
     "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":5}}},
    {"name":"glass","pbrMetallicRoughness":{"metallicFactor":0.0625},"extensions":{
      "KHR_materials_transmission":{"transmissionFactor":0.75},"KHR_materials_ior":{"ior":1.25},
      "KHR_materials_volume":{"thicknessFactor":0.3,"attenuationDistance":0.9,
        "attenuationColor":[0.8,0.7,0.6]},
      "KHR_materials_dispersion":{"dispersion":0.45}}}],
    "textures":[{"source":0,"sampler":0},{"source":1,"sampler":1},{"source":1}],
    "samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728},{"wrapS":33648}],
    "images":[{"uri":"data:image/png;base64,)" +
              red + R"("},{"uri":"data:image/png;base64,)" + veil + R"("}],
    "cameras":[{"name":"its own near","type":"perspective","perspective":{"yfov":0.5,"znear":0.1,"zfar":50}},
      {"name":"its own flat","type":"orthographic","orthographic":{"xmag":3,"ymag":2,"znear":0.2,"zfar":60}}],
    "extensions":{"KHR_lights_punctual":{"lights":[
      {"name":"its own sun","type":"directional","intensity":7,"color":[0.9,0.8,0.7],
       "extras":{"angular_diameter":0.5}},
      {"name":"its own lamp","type":"spot","intensity":90,"color":[0.6,0.5,0.4],"range":30,
       "extras":{"radius":0.02},
       "spot":{"innerConeAngle":0.2,"outerConeAngle":0.4}}]}})";
  std::string json = gltf.json();
  const std::string scene = R"("scenes":[{"nodes":[0])";
  return json.insert(
      json.find(scene) + scene.size(),
      R"(,"extras":{"medium":{"scattering":0.5,"absorption":[0.1,0.2,0.3],"anisotropy":0.35}})");
}

}  // namespace caustics::test
