// What the shown scene does not use can be no reason to refuse a file; the same fault where it is used still
// is one.
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A triangle whose arrays can be added to: `more` stands after the last element of `array`, and begins with a
// comma.
std::string with(const std::string& array, const std::string& more) {
  Gltf gltf = triangle();
  gltf.mesh += R"(,"material":0)";
  gltf.rest = R"(,"materials":[{"name":"used"}],"textures":[{"source":0}],"images":[{"uri":")" + array +
              R"("}],"skins":[{"joints":[0]}],"cameras":[{"type":"perspective"}],"animations":[])";
  std::string json = gltf.json();
  const std::size_t begin = json.rfind("\"" + array + "\":[");
  REQUIRE(begin != std::string::npos);
  // Its end: the bracket that closes it.
  int depth = 0;
  std::size_t at = json.find('[', begin);
  for (;; ++at) {
    depth += json[at] == '[' ? 1 : json[at] == ']' ? -1 : 0;
    if (depth == 0) break;
  }
  const bool empty = json[at - 1] == '[';
  return json.insert(at, empty ? more.substr(1) : more);
}

}  // namespace

TEST_CASE("Broken things that nothing uses refuse no file") {
  const std::pair<const char*, const char*> kBroken[] = {
      {"accessors", R"(,{"bufferView":7,"componentType":5126,"count":3,"type":"VEC3"})"},
      {"accessors", R"(,{"bufferView":0,"componentType":5126,"count":4000,"type":"VEC3"})"},
      {"accessors", ",7"},
      {"bufferViews", R"(,{"buffer":0,"byteLength":100000})"},
      {"bufferViews", R"(,{"buffer":9,"byteLength":1})"},
      {"buffers", R"(,{"byteLength":8,"uri":"is_not_there.bin"})"},
      {"buffers", R"(,{"byteLength":8})"},
      {"meshes", R"(,{"primitives":[{"attributes":{"POSITION":99}}]})"},
      {"meshes", R"(,{"primitives":[{"attributes":{"POSITION":0},"mode":77}]})"},
      {"nodes", R"(,{"mesh":5,"matrix":[1]})"},
      {"scenes", R"(,{"nodes":[55]})"},
      {"materials", R"(,{"extensions":{"KHR_materials_ior":{"ior":-3}}})"},
      {"materials", R"(,{"pbrMetallicRoughness":{"baseColorTexture":{"index":44}}})"},
      {"textures", R"(,{"source":12,"sampler":9})"},
      {"images", R"(,{"bufferView":31,"mimeType":"image/png"})"},
      {"images", R"(,{"uri":"is_not_there.png"})"},
      {"skins", R"(,{"joints":[],"inverseBindMatrices":99})"},
      {"cameras", R"(,{"type":"fisheye"})"},
      // The first animation is shown.
      {"animations",
       R"(,{"channels":[],"samplers":[]},{"channels":[{"sampler":0,"target":{"node":0,"path":"scale"}}],)"
       R"("samplers":[{"input":9,"output":0}]})"}};
  for (const auto& [array, broken] : kBroken) {
    INFO(array << " " << broken);
    const Scene scene = load_text(with(array, broken));
    CHECK(scene.meshes.size() == 1);
    for (const std::string& note : scene.notes) CHECK(note.find("is_not_there") == std::string::npos);
  }
}

TEST_CASE("The same things refuse a file whose scene uses them, with their path") {
  const auto fails = [](const std::string& from, const std::string& to, const char* array,
                        const char* broken) {
    std::string json = with(array, broken);
    const std::size_t at = json.find(from);
    REQUIRE(at != std::string::npos);
    return refusal(json.replace(at, from.size(), to));
  };
  CHECK(contains(fails(R"("POSITION":0)", R"("POSITION":1)", "accessors",
                       R"(,{"bufferView":0,"componentType":5126,"count":4000,"type":"VEC3"})"),
                 "accessors[1]: its 4000 elements"));
  CHECK(contains(
      fails(R"("mesh":0)", R"("mesh":1)", "meshes", R"(,{"primitives":[{"attributes":{"POSITION":99}}]})"),
      "meshes[1].primitives[0].attributes.POSITION: refers to accessors[99]"));
  CHECK(contains(fails(R"("material":0)", R"("material":1)", "materials",
                       R"(,{"extensions":{"KHR_materials_ior":{"ior":-3}}})"),
                 "materials[1].extensions.KHR_materials_ior.ior: is -3"));
  CHECK(contains(fails(R"("material":0)", R"("material":1)", "materials",
                       R"(,{"pbrMetallicRoughness":{"baseColorTexture":{"index":44}}})"),
                 "materials[1].pbrMetallicRoughness.baseColorTexture.index: refers to textures[44]"));
  CHECK(contains(
      fails(R"({"name":"used"})", R"({"normalTexture":{"index":1}})", "textures", R"(,{"source":12})"),
      "textures[1].source: refers to images[12]"));
  CHECK(contains(fails(R"("nodes":[0])", R"("nodes":[0,1])", "nodes", R"(,{"matrix":[1]})"),
                 "nodes[1].matrix: must have 16 numbers"));
  CHECK(contains(fails(R"("scene":0)", R"("scene":1)", "scenes", R"(,{"nodes":[55]})"),
                 "scenes[1].nodes[0]: "));
}

TEST_CASE("An image in a view that its buffer lacks is refused where a material shows it") {
  Gltf gltf = triangle();
  gltf.mesh += R"(,"material":0)";
  gltf.rest = R"(,"materials":[{"normalTexture":{"index":0}}],"textures":[{"source":0}],)"
              R"("images":[{"bufferView":31,"mimeType":"image/png"}])";
  CHECK(contains(refusal(gltf), "images[0].bufferView: refers to bufferViews[31]"));
}

TEST_CASE("A scene's file says which files it refers to, used or not") {
  const Folder folder;
  Gltf gltf = triangle();
  gltf.uri = "points%20of%20it.bin";
  folder.write("points of it.bin", gltf.data);
  gltf.rest = R"(,"images":[{"uri":"unused.png"},{"uri":"data:image/png;base64,AAAA"}])";
  const auto path = folder.write("scene.gltf", gltf.json());
  CHECK(load_animated(path).files() ==
        std::vector<std::filesystem::path>{folder.path() / "points of it.bin", folder.path() / "unused.png"});
}
