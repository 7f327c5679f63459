#include "tests/fuzz/fuzzed_scene.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace caustics::fuzz {

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, ByteSpan bytes) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!out.flush()) {
    std::fprintf(stderr, "cannot write %s\n", file.c_str());
    std::exit(4);
  }
}

// A grey PNG of one texel.
constexpr std::uint8_t kPng[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
    0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3a, 0x7e, 0x9b, 0x55, 0x00,
    0x00, 0x00, 0x0a, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x68, 0x00, 0x00, 0x00, 0x82, 0x00, 0x81,
    0xda, 0x45, 0x08, 0x3b, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

// The folder that the bytes are written to, with the files that they may refer to; removed at the end.
class Scratch {
 public:
  Scratch() : folder_(fs::temp_directory_path() / ("caustics_fuzz_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_ / "folder");
    const std::vector<std::uint8_t> zeros(256);
    write(folder_ / "side.bin", zeros);
    write(folder_ / "folder" / "side.bin", zeros);
    write(folder_ / "side.png", kPng);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  fs::path put(ByteSpan bytes) const {
    write(folder_ / "scene.gltf", bytes);
    return folder_ / "scene.gltf";
  }

 private:
  fs::path folder_;
};

bool finite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }
bool is_unit(const glm::dvec3& v) { return std::fabs(glm::length(v) - 1.0) <= 1e-5; }

void check_mesh(const Scene& scene, const Mesh& mesh) {
  if (mesh.material < 0 || static_cast<std::size_t>(mesh.material) >= scene.materials.size())
    finding("a mesh has no material");
  for (const Vertex& v : mesh.vertices) {
    if (!finite(v.position) || !std::isfinite(v.uv.x + v.uv.y)) finding("a vertex is not finite");
    if (!is_unit(v.normal)) finding("a normal is not of length 1");
    if (!is_unit(glm::dvec3(v.tangent))) finding("a tangent is not of length 1");
  }
  if (mesh.indices.size() % 3 != 0) finding("indices are not three a triangle");
  for (const std::uint32_t index : mesh.indices)
    if (index >= mesh.vertices.size()) finding("an index is beyond the vertices");
}

void check_texture(const Scene& scene, const TextureUse& use) {
  if (use.image >= static_cast<int>(scene.images.size())) finding("a texture has no image");
}

void check_material(const Scene& scene, const Material& m) {
  for (const TextureUse* use : {&m.base_color_texture, &m.normal_texture, &m.emissive_texture,
                                &m.transmission_texture, &m.metallic_roughness_texture, &m.occlusion_texture})
    check_texture(scene, *use);
  const float sum = m.base_color.x + m.base_color.y + m.base_color.z + m.base_color.w + m.normal_scale +
                    m.alpha_cutoff + m.metallic + m.roughness + m.occlusion_strength + m.transmission +
                    m.ior + m.thickness + m.dispersion;
  if (!std::isfinite(sum) || !finite(m.emissive) || !finite(m.attenuation_color) ||
      std::isnan(m.attenuation_distance))
    finding("a material is not finite");
}

}  // namespace

void finding(const std::string& what) {
  std::fprintf(stderr, "\nFINDING: %s\n", what.c_str());
  std::abort();
}

void check_refusal(const Error& error) {
  const std::string line = error.what();
  if (error.code() != ExitCode::BadInput)
    finding("refused with exit code " + std::to_string(static_cast<int>(error.code())) + ": " + line);
  for (const char c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      finding("the refusal is not one printable line: " + line);
}

LoadOptions small_limits() {
  LoadOptions limits;
  limits.max_bytes = 256 << 10;
  limits.max_json_values = 20'000;
  limits.max_json_depth = 64;
  limits.max_node_depth = 32;
  limits.max_nodes = 200;
  limits.max_lights = 16;
  limits.max_lit_meshes = 100;
  limits.max_vertices = 4000;
  limits.max_triangles = 4000;
  limits.max_animation_values = 4000;
  limits.max_image_side = 256;
  limits.max_image_pixels = 1 << 16;
  limits.max_water_cells = 1024;
  limits.max_water_updates = 1e5;
  return limits;
}

std::optional<AnimatedScene> load_path(const fs::path& path, const LoadOptions& limits, std::string* why) {
  try {
    return load_animated(path, limits);
  } catch (const Error& error) {
    check_refusal(error);
    if (why) *why = error.what();
  }
  return std::nullopt;
}

std::optional<AnimatedScene> load_bytes(ByteSpan bytes, const LoadOptions& limits) {
  static const Scratch scratch;
  return load_path(scratch.put(bytes), limits);
}

std::optional<Scene> scene_at(const AnimatedScene& animated, double seconds) {
  try {
    return animated.at(seconds);
  } catch (const Error& error) {
    check_refusal(error);
  }
  return std::nullopt;
}

void check_sound(const Scene& scene) {
  if (!finite(scene.origin)) finding("the origin is not finite");
  for (const Mesh& mesh : scene.meshes) check_mesh(scene, mesh);
  for (const Material& material : scene.materials) check_material(scene, material);
  for (const Image& image : scene.images)
    if (count_non_finite(image) > 0) finding("a texture is not finite");
  for (const Light& light : scene.lights) {
    if (!finite(light.position) || !std::isfinite(light.intensity) || !(light.intensity >= 0.0f))
      finding("a light is not finite, or negative");
    if (!is_unit(light.direction)) finding("a light's direction is not of length 1");
  }
  for (const Camera& camera : scene.cameras) {
    if (!finite(camera.position)) finding("a camera is not finite");
    if (!is_unit(camera.right) || !is_unit(camera.up) || !is_unit(camera.forward))
      finding("a camera's axes are not of length 1");
  }
  for (const Water& water : scene.waters)
    if (!(water.step > 0.0 && water.dx > 0.0 && water.dz > 0.0)) finding("a water has no step or no cells");
}

}  // namespace caustics::fuzz
