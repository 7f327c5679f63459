// Memory that runs out while a scene is loaded: one line about the file, nothing leaks, and the next load is
// right.
#include <optional>

#include "tests/scene/gltf_builder.hpp"
#include "tests/support/failing_new.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A caster, a light, a camera and an animation: most of the loader's rooms.
Gltf lively() {
  Gltf gltf = triangle();
  gltf.add<float>({0, 2}, 5126, "SCALAR", 2);
  gltf.add<float>({0, 0, 0, 4, 0, 0}, 5126, "VEC3", 2);
  gltf.mesh += R"(,"material":0)";
  gltf.node = R"("mesh":0,"camera":0,"children":[1]},{"extensions":{"KHR_lights_punctual":{"light":0}})";
  gltf.rest = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}],)"
              R"("materials":[{"name":"glass",)"
              R"("extensions":{"KHR_materials_transmission":{"transmissionFactor":1}}}],)"
              R"("animations":[{"samplers":[{"input":1,"output":2}],)"
              R"("channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}],)"
              R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional","intensity":3}]}})";
  return gltf;
}

}  // namespace

TEST_CASE("Memory that runs out at any allocation of a load is one line about the file") {
  const Folder folder;
  const auto path = folder.write("scene.gltf", lively().json());
  std::int64_t refused = 0, survived = 0, n = 0;
  for (;; n += n < 200 ? 1 : 7) {
    INFO("allocation " << n);
    std::optional<Scene> scene;
    std::string message;
    const FailingNew memory(n);
    try {
      scene = load_gltf(path, {});
    } catch (const Error& error) {
      message = error.what();
    }
    if (!memory.failed()) break;
    if (scene) {
      ++survived;  // a library did without
      CHECK(scene->meshes.size() == 1);
      continue;
    }
    ++refused;
    CHECK(contains(message, "scene.gltf: needs more memory than there is"));
  }
  CHECK(n > 500);
  CHECK(refused > 10 * survived);
  CHECK(load_gltf(path, {}).meshes.size() == 1);
}
