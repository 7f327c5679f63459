// A sweep over a folder of files, good and bad: every one gives a scene of sound numbers or one
// line. Runs where CAUSTICS_ASSETS names a folder.
#include <cstdlib>

#include "pipeline/scene/defaults.hpp"
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

bool sound(const Mesh& mesh) {
  for (const Vertex& v : mesh.vertices) {
    const float sum = v.position.x + v.position.y + v.position.z + v.uv.x + v.uv.y;
    if (!std::isfinite(sum)) return false;
    if (std::abs(glm::length(v.normal) - 1.0f) > 1e-5f) return false;
    if (std::abs(glm::length(glm::vec3(v.tangent)) - 1.0f) > 1e-5f) return false;
  }
  for (const std::uint32_t index : mesh.indices) {
    if (index >= mesh.vertices.size()) return false;
  }
  return mesh.indices.size() % 3 == 0;
}

bool sound(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    if (!sound(mesh) || mesh.material < 0) return false;
    if (static_cast<std::size_t>(mesh.material) >= scene.materials.size()) return false;
  }
  for (const Image& image : scene.images) {
    if (count_non_finite(image) > 0) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("Every file of the assets folder gives a sound scene or one line about bad input") {
  const char* folder = std::getenv("CAUSTICS_ASSETS");
  if (!folder) return;
  int scenes = 0, errors = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    INFO(entry.path());
    try {
      Scene scene = load_gltf(entry.path());
      complete_scene(scene);
      CHECK(sound(scene));
      ++scenes;
    } catch (const Error& error) {
      CHECK(error.code() == ExitCode::BadInput);
      CHECK_FALSE(contains(error.what(), "\n"));
      ++errors;
    }
  }
  WARN(scenes << " scenes, " << errors << " refused");
}
