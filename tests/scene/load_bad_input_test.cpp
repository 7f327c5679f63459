// Files that cannot be scenes: each must end in one line that says where the fault is.
#include "pipeline/scene/gltf/compressed.hpp"
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// The triangle's JSON with one piece of text replaced.
std::string replaced(const std::string& from, const std::string& to) {
  std::string json = triangle().json();
  const std::size_t at = json.find(from);
  REQUIRE(at != std::string::npos);
  return json.replace(at, from.size(), to);
}

Gltf indexed(const std::vector<std::uint16_t>& indices) {
  Gltf gltf = triangle();
  gltf.add(indices, 5123, "SCALAR", indices.size());
  gltf.mesh = R"("attributes":{"POSITION":0},"indices":1)";
  return gltf;
}

}  // namespace

TEST_CASE("A long name shows its beginning and its end, each with whole characters") {
  CHECK(gltf::printable("0123456789", 10) == "0123456789");
  CHECK(gltf::printable("0123456789a", 10) == "01234...6789a");
  // These letters have two bytes each: half of 9 would cut one.
  CHECK(gltf::printable("\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4", 9) == "\u00e4\u00e4...\u00e4\u00e4");
}

TEST_CASE("What is no JSON object is no glTF file") {
  CHECK(contains(refusal(""), "is empty"));
  CHECK(contains(refusal("hello"), "is not a glTF file"));
  CHECK(contains(refusal("[]"), "must be an object"));
  CHECK(contains(refusal("{\"asset\":"), "is not a glTF file"));
  CHECK(contains(refusal("{\"\xff\":1}"), "is not a glTF file"));
  CHECK(contains(refusal("{}"), "asset.version: is missing"));
}

TEST_CASE("Other versions than 2 are refused") {
  CHECK(contains(refusal(replaced("\"2.0\"", "\"1.0\"")), "asset.version: is \"1.0\""));
  CHECK(contains(refusal(replaced("\"2.0\"", "1")), "asset.version: is 1, only glTF 2.0 can be read"));
  CHECK(contains(refusal(replaced("\"2.0\"", "\"2.0\",\"minVersion\":\"2.1\"")),
                 "asset.minVersion: is \"2.1\""));
}

TEST_CASE("JSON nested too deep or with too many values is refused before it is parsed") {
  const std::string deep = "{\"extras\":" + std::string(100000, '[');
  CHECK(contains(refusal(deep), "nested deeper than 128"));
  LoadOptions options;
  options.max_json_values = 100;
  std::string wide = "{\"extras\":[0";
  for (int i = 0; i < 200; ++i) wide += ",0";
  CHECK(contains(refusal(wide + "]}", options), "more than 100 values"));
}

TEST_CASE("JSON may have as many values as the limit says, and what a string holds counts once") {
  // An object, an array, a string and some numbers.
  std::string text = R"({"extras":["[,{\"[,")";
  for (std::uint64_t values = 3; values < 9; ++values, text += ",0") {
    LoadOptions options;
    options.max_json_values = values;
    CHECK(contains(refusal(text + "]}", options), "asset.version: is missing"));
    options.max_json_values = values - 1;
    CHECK(contains(refusal(text + "]}", options), "more than " + std::to_string(values - 1) + " values"));
  }
}

TEST_CASE("What a build cannot unpack names the library that it lacks, and the package to install") {
  const gltf::Context context("packed.glb", {});
  const gltf::Json json;
  const auto message = [&](const char* extension) -> std::string {
    try {
      gltf::fail_without_decoder({context, &json, "extensionsRequired[0]"}, extension);
    } catch (const Error& error) {
      return error.what();
    }
  };
  CHECK(contains(message(gltf::kDraco),
                 "extensionsRequired[0]: KHR_draco_mesh_compression needs the library draco, which"));
  CHECK(contains(message(gltf::kDraco), "install libdraco-dev and"));
  CHECK(contains(message(gltf::kMeshopt),
                 "extensionsRequired[0]: EXT_meshopt_compression needs the library meshoptimizer, which"));
  CHECK(contains(message(gltf::kMeshopt), "install libmeshoptimizer-dev and"));
}

TEST_CASE("References that lead nowhere are refused with their path") {
  CHECK(contains(refusal(replaced("\"POSITION\":0", "\"POSITION\":7")),
                 "meshes[0].primitives[0].attributes.POSITION: refers to accessors[7]"));
  CHECK(contains(refusal(replaced("\"mesh\":0", "\"mesh\":-1")), "nodes[0].mesh: refers to"));
  CHECK(contains(refusal(replaced("\"nodes\":[0]", "\"nodes\":[3]")), "scenes[0].nodes[0]: "));
  CHECK(contains(refusal(replaced("\"scene\":0", "\"scene\":1")), "scene: refers to scenes[1]"));
  CHECK(contains(refusal(replaced("\"buffer\":0", "\"buffer\":1")), "bufferViews[0].buffer: "));
  CHECK(contains(refusal(replaced("\"mesh\":0", "\"mesh\":0.5")), "nodes[0].mesh: must be an integer"));
}

TEST_CASE("Values of the wrong type are refused with their path") {
  CHECK(contains(refusal(replaced("\"count\":3", "\"count\":\"3\"")),
                 "accessors[0].count: must be an integer, is the string"));
  CHECK(contains(refusal(replaced("\"type\":\"VEC3\"", "\"type\":\"VEC9\"")), "accessors[0].type: "));
  CHECK(contains(refusal(replaced("5126", "5130")), "accessors[0].componentType: "));
  CHECK(contains(refusal(replaced("\"mesh\":0", "\"mesh\":0,\"matrix\":[1]")),
                 "nodes[0].matrix: must have 16 numbers, has 1"));
  CHECK(
      contains(refusal(replaced("[{\"primitives\"", "[7,{\"primitives\"")), "meshes[0]: must be an object"));
}

TEST_CASE("What stands beyond 32 bits, is null or stands twice is read as it is written") {
  CHECK(contains(refusal(replaced("\"mesh\":0", "\"mesh\":4294967296")),
                 "nodes[0].mesh: refers to meshes[4294967296], but there is 1"));
  CHECK(
      contains(refusal(replaced("\"mesh\":0", "\"mesh\":null")), "nodes[0].mesh: must be an index, is null"));
  CHECK(contains(refusal(replaced("\"mesh\":0", "\"mesh\":0,\"mesh\":7")),
                 "nodes[0].mesh: refers to meshes[7]"));
  CHECK(load_text(replaced("\"mesh\":0", "\"mesh\":7,\"mesh\":0")).meshes.size() == 1);
  // A whole number is an integer however it is written.
  CHECK(load_text(replaced("\"count\":3", "\"count\":3.0,\"byteOffset\":-0.0")).meshes.size() == 1);
  CHECK(contains(refusal(replaced("\"bufferView\":0", "\"bufferView\":1.0")),
                 "accessors[0].bufferView: refers to"));
}

TEST_CASE("Accessors must lie inside their view, views inside their buffer") {
  CHECK(contains(refusal(replaced("\"count\":3", "\"count\":4")), "accessors[0]: its 4 elements"));
  CHECK(contains(refusal(replaced("\"count\":3", "\"count\":2000000000")), "accessors[0].count: "));
  CHECK(contains(refusal(replaced("\"count\":3", "\"count\":0")), "accessors[0].count: "));
  CHECK(contains(refusal(replaced("\"byteOffset\":0", "\"byteOffset\":9007199254740990")),
                 "bufferViews[0]: ends at byte"));
  CHECK(contains(refusal(replaced("\"byteOffset\":0", "\"byteOffset\":-4")), "bufferViews[0].byteOffset: "));
  CHECK(contains(refusal(replaced("\"buffer\":0", "\"buffer\":0,\"byteStride\":4")),
                 "bufferViews[0].byteStride: is 4"));
  CHECK(contains(refusal(replaced("\"buffer\":0", "\"buffer\":0,\"byteStride\":13")),
                 "bufferViews[0].byteStride: must be a multiple of 4"));
  CHECK(contains(refusal(replaced("\"byteLength\":36,\"uri\"", "\"byteLength\":40,\"uri\"")),
                 "buffers[0].byteLength: is 40, but there are only 36"));
}

TEST_CASE("Indices beyond the vertices and the restart value are refused with accessor and index") {
  CHECK(contains(refusal(indexed({0, 1, 3})), "accessors[1]: index 2 is 3, but there are 3 vertices"));
  CHECK(contains(refusal(indexed({0, 65535, 2})), "accessors[1]: index 1 is 65535, the primitive restart"));
}

TEST_CASE("Positions that are not finite, or absurdly far away, are refused with accessor and index") {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
    Gltf gltf;
    gltf.add<float>({0, 0, 0, 1, bad, 0, 0, 1, 0}, 5126, "VEC3", 3);
    gltf.mesh = R"("attributes":{"POSITION":0})";
    CHECK(contains(refusal(gltf), "accessors[0]: position 1 "));
  }
}

TEST_CASE("Attributes of the wrong type or count are refused") {
  Gltf gltf = triangle();
  gltf.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC3", 2);
  gltf.mesh = R"("attributes":{"POSITION":0,"NORMAL":1})";
  CHECK(contains(refusal(gltf), "accessors[1]: NORMAL has 2 elements"));
  gltf.mesh = R"("attributes":{"POSITION":0,"TANGENT":1})";
  CHECK(contains(refusal(gltf), "accessors[1]: has the wrong type for TANGENT"));
}

TEST_CASE("Sparse indices out of order or out of range are refused") {
  for (const std::vector<std::uint16_t>& indices :
       {std::vector<std::uint16_t>{1, 1}, std::vector<std::uint16_t>{0, 3}}) {
    Gltf gltf = triangle();
    gltf.add(indices, 5123, "SCALAR", 2);
    gltf.add<float>({0, 0, 0, 0, 0, 0}, 5126, "VEC3", 2);
    gltf.accessors += R"(,{"componentType":5126,"type":"VEC3","count":3,"sparse":{"count":2,
        "indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":2}}})";
    gltf.mesh = R"("attributes":{"POSITION":3})";
    CHECK(contains(refusal(gltf), "accessors[3].sparse.indices: index 1 "));
  }
}

TEST_CASE("A buffer with neither a URI nor a binary chunk is refused") {
  std::string json = triangle().json();
  const std::size_t uri = json.find(",\"uri\":"), end = json.find('}', uri);
  CHECK(contains(refusal(json.erase(uri, end - uri)), "buffers[0].uri: is missing"));
}

TEST_CASE("A mesh that is only there in compressed form is refused where it cannot be unpacked") {
  Gltf gltf = triangle();
  gltf.accessors += R"(,{"componentType":5126,"type":"VEC3","count":3})";
  gltf.mesh = R"("attributes":{"POSITION":1},)"
              R"("extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{}}})";
  // By the decoder, which finds no header, or for lack of one.
  CHECK(contains(refusal(gltf), "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: "));
}

TEST_CASE("A camera whose node is flat is refused") {
  Gltf gltf = triangle();
  gltf.node = R"("mesh":0,"camera":0,"scale":[1,0,1])";
  gltf.rest = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}])";
  CHECK(contains(refusal(gltf), "nodes[0]: its transform is flat, so its camera has no direction"));
}

TEST_CASE("Instances of the wrong type or count are refused") {
  for (const bool wrong_type : {true, false}) {
    Gltf gltf = triangle();
    gltf.add<float>({0, 0, 0, 1, 0, 0}, 5126, "VEC3", 2);
    gltf.add<float>({1, 1, 1}, 5126, wrong_type ? "SCALAR" : "VEC3", wrong_type ? 3 : 1);
    gltf.node += R"(,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":1,"SCALE":2}}})";
    CHECK(contains(refusal(gltf),
                   "EXT_mesh_gpu_instancing.attributes.SCALE: has the wrong type, or another count"));
  }
}

TEST_CASE("Cycles, second parents and endless depth in the node tree are refused") {
  Gltf gltf = triangle();
  gltf.node = R"("children":[0])";
  CHECK(contains(refusal(gltf), "nodes[0]: is reached twice"));
  gltf.node = R"("children":[1,2]},{"children":[3]},{"children":[3]},{"mesh":0)";
  CHECK(contains(refusal(gltf), "nodes[3]: is reached twice"));
  gltf.node = R"("children":[1])";
  for (int i = 2; i < 300; ++i) gltf.node += R"(},{"children":[)" + std::to_string(i) + "]";
  gltf.node += R"(},{"mesh":0)";
  CHECK(contains(refusal(gltf), "nodes[129]: lies deeper than 128"));
}

TEST_CASE("Transforms that overflow are refused, flat ones leave no triangles") {
  Gltf gltf = triangle();
  gltf.node = R"("scale":[1e200,1,1],"children":[1]},{"scale":[1e200,1,1],"mesh":0)";
  CHECK(contains(refusal(gltf), "nodes[1]: its transform is not finite"));
  gltf.node = R"("scale":[0,0,0],"mesh":0)";
  const Scene scene = load(gltf);
  CHECK(scene.meshes.empty());
  CHECK(has_note(scene, "1 triangles without area"));
}

TEST_CASE("The limits on vertices, triangles and instances hold") {
  LoadOptions options;
  options.max_vertices = 2;
  CHECK(contains(refusal(triangle().json(), options), "more than 2 vertices"));
  options = {};
  options.max_triangles = 0;
  CHECK(contains(refusal(triangle().json(), options), "more than 0 triangles"));
  options = {};
  options.max_nodes = 1;
  CHECK(contains(refusal(triangle().json(), options), "more than 1 nodes"));
}

TEST_CASE("More lights than the limit are refused") {
  Gltf gltf = triangle();
  const std::string light = R"("extensions":{"KHR_lights_punctual":{"light":0}})";
  gltf.node += "," + light + R"(,"children":[1]},{)" + light;
  gltf.rest = R"(,"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}})";
  LoadOptions options;
  options.max_lights = 2;
  CHECK(load_text(gltf.json(), options).lights.size() == 2);
  options.max_lights = 1;
  CHECK(contains(refusal(gltf.json(), options),
                 "nodes[1].extensions.KHR_lights_punctual: the scene has more than 1 lights"));
  options = {};
  options.max_lit_meshes = 2;
  CHECK(load_text(gltf.json(), options).lights.size() == 2);
  options.max_lit_meshes = 1;
  CHECK(
      contains(refusal(gltf.json(), options), "nodes: the scene's lights times its meshes are more than 1"));
}
