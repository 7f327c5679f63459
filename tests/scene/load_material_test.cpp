// Materials and textures.
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Scene with_material(const std::string& material, const std::string& more = "") {
  Gltf gltf = triangle();
  gltf.mesh += R"(,"material":0)";
  gltf.rest = R"(,"materials":[{)" + material + "}]" + more;
  return load(gltf);
}

std::string refused_material(const std::string& material) {
  Gltf gltf = triangle();
  gltf.mesh += R"(,"material":0)";
  gltf.rest = R"(,"materials":[{)" + material + "}]";
  return refusal(gltf);
}

std::string extension(const std::string& name, const std::string& members) {
  return R"("extensions":{")" + name + R"(":{)" + members + "}}";
}

// A PNG of 2x2 texels: red 255, 0 in the top row; 188, 188 in the bottom row; green and blue 0,
// alpha 128.
const char* kPng =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAFElEQVR42mP4z8DQwADCe4AECAMAKNEEeM/2"
    "UfoAAAAASUVORK5CYII=";

std::string textured(const std::string& material, const std::string& uri) {
  Gltf gltf = triangle();
  gltf.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC2", 3);
  gltf.mesh = R"("attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0)";
  gltf.rest =
      R"(,"materials":[{)" + material + R"(}],"textures":[{"source":0}],"images":[{"uri":")" + uri + R"("}])";
  return gltf.json();
}
const std::string kBase = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})";

}  // namespace

TEST_CASE("A material without members has the defaults of the specifications") {
  const Material m = with_material("").materials.at(0);
  CHECK(m.base_color == glm::vec4(1));
  CHECK(m.metallic == 1.0f);
  CHECK(m.roughness == 1.0f);
  CHECK(m.ior == 1.5f);
  CHECK(m.transmission == 0.0f);
  CHECK(m.thickness == 0.0f);
  CHECK(m.dispersion == 0.0f);
  CHECK(m.attenuation_distance == std::numeric_limits<float>::infinity());
  CHECK(m.alpha_mode == AlphaMode::Opaque);
  CHECK(m.alpha_cutoff == 0.5f);
  CHECK_FALSE(m.base_color_texture.present());
}

TEST_CASE("Glass is read from its four extensions") {
  const Material m = with_material(R"("name":"glass","extensions":{
      "KHR_materials_transmission":{"transmissionFactor":1},
      "KHR_materials_ior":{"ior":2},
      "KHR_materials_volume":{"thicknessFactor":0.5,"attenuationDistance":3,
                              "attenuationColor":[0.1,0.5,0.9]},
      "KHR_materials_dispersion":{"dispersion":0.36}})")
                         .materials.at(0);
  CHECK(m.name == "glass");
  CHECK(m.transmission == 1.0f);
  CHECK(m.ior == 2.0f);
  CHECK(m.thickness == 0.5f);
  CHECK(m.attenuation_distance == 3.0f);
  CHECK(m.attenuation_color == glm::vec3(0.1f, 0.5f, 0.9f));
  CHECK(m.dispersion == 0.36f);
}

TEST_CASE("Factors beyond their range are clamped, with a note that names them") {
  const Scene scene = with_material(R"("pbrMetallicRoughness":{"roughnessFactor":3})");
  CHECK(scene.materials.at(0).roughness == 1.0f);
  CHECK(has_note(scene, "materials[0].pbrMetallicRoughness.roughnessFactor is 3; 1 is used."));
}

TEST_CASE("An index of refraction is 0, above 0, or refused") {
  const auto ior = [](const std::string& value) {
    return extension("KHR_materials_ior", R"("ior":)" + value);
  };
  CHECK(with_material(ior("0")).materials.at(0).ior == 0.0f);
  const Scene bubble = with_material(ior("0.75"));
  CHECK(bubble.materials.at(0).ior == 0.75f);
  CHECK(has_note(bubble, "below 1"));
  const std::string path = "materials[0].extensions.KHR_materials_ior.ior: ";
  CHECK(contains(refused_material(ior("-1.5")), path));
  CHECK(contains(refused_material(ior("\"glass\"")), path));
  CHECK(contains(refused_material(ior("null")), path));
  CHECK(contains(refused_material(ior("1e999")), "is not a glTF file"));
  CHECK(contains(refused_material(R"("extensions":{"KHR_materials_ior":[]})"),
                 "materials[0].extensions.KHR_materials_ior: must be an object"));
}

TEST_CASE("KHR_materials_specular scales what is mirrored, and colours it") {
  const Material m = with_material(extension("KHR_materials_specular",
                                             R"("specularFactor":0.25,"specularColorFactor":[2,1,0.5])"))
                         .materials.at(0);
  CHECK(m.fresnel_factor == 0.25f);
  CHECK(m.specular_color == glm::vec3(2.0f, 1.0f, 0.5f));
  const Material plain = with_material(R"("name":"plain")").materials.at(0);
  CHECK(plain.fresnel_factor == 1.0f);
  CHECK(plain.specular_color == glm::vec3(1.0f));
}

TEST_CASE("An attenuation distance of 0 absorbs nothing and is noted") {
  const Scene scene =
      with_material(extension("KHR_materials_volume", R"("thicknessFactor":1,"attenuationDistance":0)"));
  CHECK(scene.materials.at(0).attenuation_distance == std::numeric_limits<float>::infinity());
  CHECK(has_note(scene, "attenuationDistance is 0"));
}

TEST_CASE("Emission is the factor times its strength, unlit is kept") {
  const Material m = with_material(R"("emissiveFactor":[1,0.5,0],"extensions":{
      "KHR_materials_emissive_strength":{"emissiveStrength":100},"KHR_materials_unlit":{}})")
                         .materials.at(0);
  CHECK(m.emissive == glm::vec3(100, 50, 0));
  CHECK(m.unlit);
}

TEST_CASE("Specular-glossiness is read as metallic-roughness: no diffuse colour is metal") {
  const auto read = [](const std::string& members) {
    return with_material(R"("pbrMetallicRoughness":{"baseColorFactor":[0.1,0.1,0.1,1]},)" +
                         extension("KHR_materials_pbrSpecularGlossiness", members))
        .materials.at(0);
  };
  const Material cloth =
      read(R"("diffuseFactor":[0.2,0.4,0.6,0.5],"specularFactor":[0.3,0.3,0.3],"glossinessFactor":0.25)");
  CHECK(cloth.base_color == glm::vec4(0.2f, 0.4f, 0.6f, 0.5f));
  CHECK(cloth.metallic == 0.0f);
  CHECK(cloth.roughness == 0.75f);
  CHECK(cloth.roughness_factor == 0.75f);
  const Material gold = read(R"("diffuseFactor":[0,0,0,1],"specularFactor":[1,0.8,0.3])");
  CHECK(gold.base_color == glm::vec4(1.0f, 0.8f, 0.3f, 1.0f));
  CHECK(gold.metallic == 1.0f);
  CHECK(gold.roughness == 0.0f);
  const Material plastic = read(R"("diffuseFactor":[0,0,0,1],"specularFactor":[0.04,0.04,0.04])");
  CHECK(plastic.base_color == glm::vec4(0, 0, 0, 1));
  CHECK(plastic.metallic == 0.0f);
}

TEST_CASE("Extensions that we lack are refused when required, noted when used") {
  Gltf gltf = triangle();
  gltf.rest = R"(,"extensionsRequired":["EXT_texture_avif"])";
  CHECK(contains(refusal(gltf), "extensionsRequired[0]: the extension EXT_texture_avif is not supported"));
  CHECK(contains(refusal(gltf), "re-export with PNG or JPEG textures"));
  gltf.rest = R"(,"extensionsUsed":["MSFT_lod"])";
  CHECK(has_note(load(gltf), "The extension MSFT_lod is ignored."));
}

TEST_CASE("What of a material is not drawn as specified is said in one line each") {
  const std::pair<const char*, const char*> kLines[] = {
      {"clearcoat", "Clear coat is left out"},
      {"sheen", "Sheen is left out: cloth has no bright rim"},
      {"iridescence", "Iridescence is left out: thin films show no colours"},
      {"anisotropy", "Anisotropy is left out: highlights are round"},
      {"diffuse_transmission", "Diffuse transmission is left out: leaves and paper let no light through"},
      {"volume_scatter", "Scattering in volumes is left out: they are clear"},
      {"pbrSpecularGlossiness",
       "Specular-glossiness is shown as metal without diffuse colour, or as diffuse that mirrors by its "
       "ior"}};
  for (const auto& [name, line] : kLines) {
    const std::string extension = std::string("KHR_materials_") + name;
    Gltf gltf = triangle();
    gltf.mesh += R"(,"material":0)";
    gltf.rest = R"(,"materials":[{"extensions":{")" + extension + R"(":{}}}],"extensionsUsed":[")" +
                extension + R"("],"extensionsRequired":[")" + extension + R"("])";
    const Scene scene = load(gltf);
    const std::string sentence = std::string(line) + " (" + extension + ").";
    CHECK(std::count(scene.notes.begin(), scene.notes.end(), sentence) == 1);
  }
}

TEST_CASE("Basis textures leave a scene without them, and one note that says so") {
  Gltf gltf = triangle();
  gltf.mesh += R"(,"material":0)";
  gltf.rest = R"(,"extensionsRequired":["KHR_texture_basisu"],"extensionsUsed":["KHR_texture_basisu"],
      "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
      "textures":[{"extensions":{"KHR_texture_basisu":{"source":0}}}],
      "images":[{"mimeType":"image/ktx2","uri":"missing.ktx2"}])";
  const Scene scene = load(gltf);
  CHECK(scene.images.empty());
  CHECK(has_note(scene, "Basis textures cannot be read"));
  CHECK(has_note(scene, "re-export with PNG or JPEG textures"));
}

TEST_CASE("A colour texture is decoded to linear half floats with its bottom row first") {
  const Scene scene = load_text(textured(kBase, std::string("data:image/png;base64,") + kPng));
  REQUIRE(scene.images.size() == 1);
  const Image& image = scene.images[0];
  CHECK(image.shape == ImageShape{Format::RGBA16F, 2, 2});
  CHECK(image.at(0, 1, 0) == 1.0f);
  CHECK(image.at(1, 1, 0) == 0.0f);
  // sRGB 188 is 0.502886 linear; the nearest half is 0.50293.
  CHECK(image.at(0, 0, 0) == Approx(0.502886).margin(2.5e-4));
  CHECK(image.at(0, 0, 0) == stored_value(Format::RGBA16F, image.at(0, 0, 0)));
  CHECK(image.at(0, 0, 3) == stored_value(Format::RGBA16F, 128.0f / 255.0f));
  CHECK(scene.meshes.at(0).has_uv);
  const glm::vec3 corner = scene.materials.at(0).base_color_texture.uv_transform * glm::vec3(0, 0, 1);
  CHECK(corner == glm::vec3(0, 1, 1));
  // Its mip map is averaged in linear light: of 1, 0 and twice 0.50293.
  CHECK(scene.materials[0].base_color_texture.levels == 2);
  CHECK(scene.coarser.at(0).at(0, 0, 0) == Approx((1.0 + 2 * 0.50293) / 4).margin(2.5e-4));
}

TEST_CASE("A sampler says how a texture goes on along each axis, and whether it is interpolated") {
  const auto use_of = [](const std::string& sampler) {
    std::string text = textured(kBase, std::string("data:image/png;base64,") + kPng);
    const std::string plain = R"("textures":[{"source":0}])";
    text.replace(text.find(plain), plain.size(),
                 R"("samplers":[{},{)" + sampler + R"(}],"textures":[{"source":0,"sampler":1}])");
    Scene scene = load_text(text);
    return std::pair(scene.materials.at(0).base_color_texture, scene.notes);
  };
  const auto [plain, none] = use_of("");
  CHECK(plain.wrap_u == Wrap::Repeat);
  CHECK(plain.wrap_v == Wrap::Repeat);
  CHECK_FALSE(plain.nearest);
  // CLAMP_TO_EDGE, MIRRORED_REPEAT, NEAREST (glTF 2.0, 5.26).
  const auto [use, notes] = use_of(R"("wrapS":33071,"wrapT":33648,"magFilter":9728)");
  CHECK(use.wrap_u == Wrap::Clamp);
  CHECK(use.wrap_v == Wrap::Mirror);
  CHECK(use.nearest);
  CHECK(notes == none);
  const auto [other, noted] = use_of(R"("wrapS":10496,"wrapT":10497)");
  CHECK(other.wrap_u == Wrap::Repeat);
  CHECK(contains(noted.at(0), "samplers[1].wrapS is no wrap mode of glTF: the texture repeats."));
}

TEST_CASE("What a blended material's texture covers at least and at most is known, of no other material") {
  // Alpha 204, 51 over 102, 153.
  const std::string png =
      "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAFklEQVR42mPg+iV3BoiNGYBEGhDPBAA6iwaHbzjEJAAA"
      "AABJRU5ErkJggg==";
  const auto material = [&](const std::string& mode) {
    return load_text(textured(kBase + R"(,"alphaMode":")" + mode + '"', "data:image/png;base64," + png))
        .materials.at(0);
  };
  const Material blended = material("BLEND");
  CHECK(blended.least_alpha == stored_value(Format::RGBA16F, 51.0f / 255.0f));
  CHECK(blended.most_alpha == stored_value(Format::RGBA16F, 204.0f / 255.0f));
  CHECK(material("OPAQUE").least_alpha == 1.0f);
  CHECK(material("MASK").most_alpha == 1.0f);
}

TEST_CASE("A normal texture of 16 bits a channel keeps its steps") {
  // One texel: 32769, 32768, 65535.
  const std::string png =
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABEAIAAADA54+dAAAA"
      "D0lEQVR42mNoYGxg+P8fAAgJAwB2DzdBAAAAAElFTkSuQmCC";
  const Scene scene = load_text(textured(R"("normalTexture":{"index":0})", "data:image/png;base64," + png));
  CHECK(scene.images.at(0).at(0, 0, 0) == 32769.0f / 65535.0f);
  CHECK(scene.images[0].at(0, 0, 1) == 32768.0f / 65535.0f);
}

TEST_CASE("A transmission texture is placed as data beside its mean, on what transmits alone") {
  const auto material = [](const std::string& factor) {
    return load_text(textured(R"("extensions":{"KHR_materials_transmission":{"transmissionFactor":)" +
                                  factor + R"(,"transmissionTexture":{"index":0}}})",
                              std::string("data:image/png;base64,") + kPng));
  };
  const Scene scene = material("1");
  REQUIRE(scene.materials.at(0).transmission_texture.present());
  CHECK(scene.images.at(0).at(0, 0, 0) == 188.0f / 255.0f);
  CHECK(scene.images[0].at(0, 1, 0) == 1.0f);
  CHECK_FALSE(material("0").materials.at(0).transmission_texture.present());
}

TEST_CASE("A normal texture stays as it is and brings tangents") {
  const Scene scene = load_text(
      textured(R"("normalTexture":{"index":0,"scale":0.5})", std::string("data:image/png;base64,") + kPng));
  CHECK(scene.images.at(0).shape.format == Format::RGBA32F);
  CHECK(scene.images[0].at(0, 0, 0) == 188.0f / 255.0f);
  CHECK(scene.materials.at(0).normal_scale == 0.5f);
  // u grows along +x; v points down in the picture and grows along +y: a mirrored frame.
  const Vertex& vertex = scene.meshes.at(0).vertices[0];
  CHECK(vertex.tangent == glm::vec4(1, 0, 0, -1));
}

TEST_CASE("A metallic-roughness texture counts with its mean") {
  const Scene scene = load_text(textured(R"("pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}})",
                                         std::string("data:image/png;base64,") + kPng));
  CHECK(scene.materials.at(0).roughness == 0.0f);
  CHECK(scene.materials.at(0).metallic == 0.0f);
  // And texel by texel, with the factors beside it.
  CHECK(scene.materials[0].roughness_factor == 1.0f);
  REQUIRE(scene.materials[0].metallic_roughness_texture.present());
  CHECK(scene.images.at(0).shape.format == Format::RGBA16F);
  CHECK(scene.images[0].at(0, 0, 0) == stored_value(Format::RGBA16F, 188.0f / 255.0f));
  const Scene glass = load_text(textured(
      extension("KHR_materials_transmission", R"("transmissionFactor":1,"transmissionTexture":{"index":0})"),
      std::string("data:image/png;base64,") + kPng));
  CHECK(glass.materials.at(0).transmission == Approx((255 + 0 + 188 + 188) / (4 * 255.0)));
}

TEST_CASE("An occlusion texture is data with a strength, one image with the metallic-roughness texture") {
  const Scene scene = load_text(textured(
      R"("occlusionTexture":{"index":0,"strength":0.25},
         "pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}})",
      std::string("data:image/png;base64,") + kPng));
  CHECK(scene.images.size() == 1);
  CHECK(scene.materials.at(0).occlusion_texture.image == 0);
  CHECK(scene.materials[0].occlusion_strength == 0.25f);
  CHECK(scene.images[0].at(0, 0, 0) == stored_value(Format::RGBA16F, 188.0f / 255.0f));
}

TEST_CASE("KHR_texture_transform turns as its own example says") {
  // The lower left quadrant, turned clockwise by a quarter (the example of the extension's text).
  const Scene scene = load_text(textured(
      R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{
         "KHR_texture_transform":{"offset":[0,1],"rotation":1.57079632679489662,
                                  "scale":[0.5,0.5]}}}})",
      std::string("data:image/png;base64,") + kPng));
  const glm::mat3 m = scene.materials.at(0).base_color_texture.uv_transform;
  const glm::vec3 a = m * glm::vec3(0, 0, 1), b = m * glm::vec3(1, 1, 1);
  CHECK(a.x == Approx(0).margin(1e-6));
  CHECK(a.y == Approx(0).margin(1e-6));
  CHECK(b.x == Approx(0.5));
  CHECK(b.y == Approx(0.5));
}

TEST_CASE("KHR_texture_transform scales before it turns, and names its own coordinates") {
  // Turned by 30 degrees: u' = 0.5 cos u + 0.25 sin v, counted from the top v' = -0.5 sin u + 0.25 cos v.
  Gltf gltf = triangle();
  gltf.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC2", 3);
  gltf.add<float>({0.5f, 0, 1, 0, 0, 1}, 5126, "VEC2", 3);
  gltf.mesh = R"("attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":2},"material":0)";
  gltf.rest = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{
      "KHR_texture_transform":{"rotation":0.52359877559829882,"scale":[0.5,0.25],"texCoord":1}}}}}],
      "textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
              std::string(kPng) + R"("}])";
  const Scene scene = load(gltf);
  const glm::mat3 m = scene.materials.at(0).base_color_texture.uv_transform;
  const glm::vec3 across = m * glm::vec3(1, 0, 0), down = m * glm::vec3(0, 1, 0);
  CHECK(across.x == Approx(0.5 * 0.8660254));
  CHECK(across.y == Approx(0.5 * 0.5));
  CHECK(down.x == Approx(0.25 * 0.5));
  CHECK(down.y == Approx(-0.25 * 0.8660254));
  CHECK(scene.meshes.at(0).vertices[0].uv == glm::vec2(0.5f, 0.0f));
}

TEST_CASE("A grey picture spreads over the colours and keeps its alpha") {
  // One texel: grey 188, alpha 128.
  const std::string png =
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR4nGPY"
      "0wAAAfsBPZk8qocAAAAASUVORK5CYII=";
  const Image image = load_text(textured(kBase, "data:image/png;base64," + png)).images.at(0);
  for (int c = 0; c < 3; ++c) CHECK(image.at(0, 0, c) == Approx(0.502886).margin(2.5e-4));
  CHECK(image.at(0, 0, 3) == stored_value(Format::RGBA16F, 128.0f / 255.0f));
}

TEST_CASE("WebP textures are read, in place of the copy beside them") {
  // The texels of kPng, by libwebp 1.5: lossless; lossy without alpha, whose red is 9 levels off; both, in
  // the extended format.
  const std::pair<const char*, float> kPictures[] = {
      {"UklGRiIAAABXRUJQVlA4TBYAAAAvAUAAEBcQAoEkf6fZjgEMF6xCRP9D", 128.0f / 255.0f},
      {"UklGRlwAAABXRUJQVlA4IFAAAADQAgCdASoCAAIAAAAAJaACdLoB+AH6AA/jp04GmjSAAP7//2yflX/Dz/2nybem9vjPBqXfpT//"
       "/wBY//QBjm4I//QCP/9CEsq+CPP/oLQAAA==",
       1.0f},
      {"UklGRnwAAABXRUJQVlA4WAoAAAAQAAAAAQAAAQAAQUxQSAUAAAAAgICAgABWUDggUAAAANACAJ0BKgIAAgAAAAAloAJ0ugH4AfoAD"
       "+On"
       "TgaaNIAA/v//bJ+Vf8PP/afJt6b2+M8Gpd+lP///AFj/9AGObgj/9AI//0ISyr4I8/+gtAAA",
       128.0f / 255.0f}};
  for (const auto& [picture, alpha] : kPictures) {
    Gltf gltf = triangle();
    gltf.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC2", 3);
    gltf.mesh = R"("attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0)";
    gltf.rest = R"(,"extensionsRequired":["EXT_texture_webp"],"materials":[{)" + kBase +
                R"(}],"textures":[{"source":1,"extensions":{"EXT_texture_webp":{"source":0}}}],"images":[)" +
                R"({"uri":"data:image/webp;base64,)" + picture + R"("},{"uri":"other.png"}])";
    const Scene scene = load(gltf);
    CHECK_FALSE(has_note(scene, "left out"));
    REQUIRE(scene.images.size() == 1);
    const Image& image = scene.images[0];
    REQUIRE(image.width() == 2);
    REQUIRE(image.height() == 2);
    CHECK(image.at(0, 0, 3) == stored_value(Format::RGBA16F, alpha));
    if (picture != kPictures[0].first) continue;
    CHECK(image.at(0, 1, 0) == 1.0f);
    CHECK(image.at(1, 1, 0) == 0.0f);
    // Of 8 bits times an alpha of a half, 7 are left.
    CHECK(image.at(0, 0, 0) == Approx(0.502886).margin(7e-3));
    CHECK(image.at(1, 0, 2) == 0.0f);
  }
}

TEST_CASE("A texture that cannot be read is left out with a note") {
  const auto note_of = [](const std::string& uri) {
    const Scene scene = load_text(textured(kBase, uri));
    CHECK(scene.meshes.size() == 1);
    CHECK(scene.images.empty());
    CHECK_FALSE(scene.materials.at(0).base_color_texture.present());
    return scene.notes.empty() ? "" : scene.notes[0];
  };
  CHECK(contains(note_of("missing.png"), "images[0].uri: file not found"));
  CHECK(contains(note_of("../up.png"), "images[0].uri: leaves the glTF file's folder"));
  CHECK(contains(note_of("http://example.org/a.png"), "images[0].uri: only data: URIs"));
  CHECK(contains(note_of("data:image/gif;base64," + base64("GIF89a......")), "is a GIF"));
  const std::string moving = "RIFF\x16" + std::string("\0\0\0WEBPVP8X\x0a\0\0\0\x02\0\0\0\0\0\0\0\0\0", 25);
  CHECK(contains(note_of("data:image/webp;base64," + base64(moving)), "is a WebP that moves"));
  CHECK(contains(note_of("data:image/webp;base64," + base64(moving.substr(0, 20))), "was cut short"));
  const std::string truncated = "data:image/png;base64," + std::string(kPng).substr(0, 60);
  CHECK(contains(note_of(truncated), "images[0] is a PNG that was cut short"));
  // A header that promises 65535 x 65535 texels.
  std::string bomb = "\x89PNG\r\n\x1a\n" + std::string("\0\0\0\rIHDR\0\0\xff\xff\0\0\xff\xff", 16);
  bomb += std::string("\x08\x06\0\0\0\0\0\0\0\0\0\0\0IEND\xae\x42\x60\x82", 21);
  CHECK(contains(note_of("data:image/png;base64," + base64(bomb)), "larger than 16384"));
}

TEST_CASE("Images of too many texels together are halved, to means of light") {
  const std::string text =
      textured(kBase + R"(,"normalTexture":{"index":0})", std::string("data:image/png;base64,") + kPng);
  const Scene whole = load_text(text);
  LoadOptions options;
  options.max_image_pixels = 4;  // the image is 2 x 2, and read in two ways
  const Scene halved = load_text(text, options);
  CHECK(has_note(halved, "images[0] is used at 1x1 instead of 2x2"));
  REQUIRE(halved.images.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const Image& four = whole.images.at(i);
    REQUIRE(halved.images[i].values.size() == 4);
    for (int c = 0; c < 4; ++c) {
      const float sum = four.at(0, 0, c) + four.at(1, 0, c) + four.at(0, 1, c) + four.at(1, 1, c);
      CHECK(halved.images[i].at(0, 0, c) == Approx(sum / 4).margin(5e-4));
    }
  }
  options.max_image_pixels = 8;
  CHECK(load_text(text, options).images.at(0).width() == 2);
}

TEST_CASE("What needs more memory than is left is wrong usage, not a bad file") {
  LoadOptions options;
  options.memory = MemoryBudget{1, "of --memory"};
  try {
    load_text(textured(kBase, std::string("data:image/png;base64,") + kPng), options);
    FAIL("nothing is refused");
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::WrongUsage);
    CHECK(contains(error.what(), "scene.gltf: its bytes need"));
    CHECK(contains(error.what(), "of --memory; make them smaller, or raise --memory"));
  }
}
