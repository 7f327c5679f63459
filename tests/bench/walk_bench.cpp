// Times the bounding-volume hierarchy: its making, and the walk through it of light that glass bends and
// mirrors totally, surface after surface. Seconds of processor time, the median of
// several.
//   walk_bench [rays=512] [surfaces=16] [finer=0] [repeats=3] [threads=1] [gl=0] [FILE.glb ...]
// rays: a side, of parallel light over the file's closed meshes, all of them glass of index 1.5; light ends
// on others. finer: so often each triangle is cut into four. gl: on the first OpenGL device. Without files: a
// ball. CAUSTICS_LANES chooses lanes.
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>
#include <new>
#include <string>
#include <vector>

#include "gl_backend/gl_device.hpp"
#include "pipeline/gpu/owned.hpp"
#include "pipeline/scene/gltf/load_gltf.hpp"
#include "pipeline/scene/triangle_tree.hpp"
#include "tests/support/light_path_bench.hpp"
#include "tests/support/shapes.hpp"

namespace caustics {
extern const Shader bench_walk_hit_shader;
}

namespace {

std::atomic<std::size_t> live{0}, most_live{0};

void* counted(void* memory) {
  if (!memory) throw std::bad_alloc();
  const std::size_t now = live += malloc_usable_size(memory);
  std::size_t most = most_live;
  while (now > most && !most_live.compare_exchange_weak(most, now)) {
  }
  return memory;
}

}  // namespace

// Not to be inlined: GCC would warn of memory that one function made and another freed.
[[gnu::noinline]] void* operator new(std::size_t size) { return counted(std::malloc(size)); }
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  live -= malloc_usable_size(memory);
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

namespace {

using namespace caustics;
using namespace caustics::test;

std::map<std::string, int> options{{"rays", 512},  {"surfaces", 16}, {"finer", 0},
                                   {"repeats", 3}, {"threads", 1},   {"gl", 0}};

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_seconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void cut_finer(Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, fresh] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
    if (fresh) {
      const Vertex &v = mesh.vertices[a], &w = mesh.vertices[b];
      const glm::vec3 sum = v.normal + w.normal;
      mesh.vertices.push_back({.position = 0.5f * (v.position + w.position),
                               .normal = glm::length(sum) > 0.0f ? glm::normalize(sum) : v.normal});
    }
    return found->second;
  };
  std::vector<std::uint32_t> finer;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const std::uint32_t v : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) finer.push_back(v);
  }
  mesh.indices = std::move(finer);
}

HierarchyBench bench_of(Scene scene) {
  HierarchyBench bench;
  for (Mesh& mesh : scene.meshes) {
    for (int i = 0; i < options["finer"]; ++i) cut_finer(mesh);
    bench.caster(std::move(mesh));
  }
  const Bounds bounds = bounds_of(bench.scene);
  bench.touch = static_cast<float>(4e-6 * bounds.radius());
  return bench;
}

std::size_t bytes_of(const HierarchyTables& tables) {
  return 4 * (tables.nodes.values.size() + tables.triangles.values.size() + tables.normals.values.size());
}

HierarchyTables time_making(const HierarchyBench& bench) {
  HierarchyTables tables;
  std::vector<double> processor, wall;
  std::size_t peak = 0;
  for (int i = 0; i < options["repeats"]; ++i) {
    tables = {};
    const std::size_t before = live;
    most_live = before;
    const double processor_before = processor_seconds(), wall_before = wall_seconds();
    tables = bench.tables(options["threads"]);
    processor.push_back(processor_seconds() - processor_before);
    wall.push_back(wall_seconds() - wall_before);
    peak = most_live - before;
  }
  const auto triangles = static_cast<double>(bench.first_receiver());
  std::printf(
      "  making:  %.3f s, %.3f s by the clock (%.2f us a triangle); %.0f bytes a triangle, %.0f while made\n",
      median(processor), median(wall), 1e6 * median(wall) / triangles,
      static_cast<double>(bytes_of(tables)) / triangles, static_cast<double>(peak) / triangles);
  return tables;
}

// Parallel light onto the closed meshes, slanted, on a grid around them.
std::vector<AimedRay> light_onto(const Scene& scene) {
  const glm::dvec3 along = glm::normalize(glm::dvec3(-0.55, -0.8, -0.25));
  const auto axes = axes_across(along);
  glm::dvec3 lower(1e30), upper(-1e30);
  for (const Mesh& mesh : scene.meshes) {
    if (!mesh.closed()) continue;
    for (const Vertex& vertex : mesh.vertices) {
      const glm::dvec3 p(vertex.position),
          seen(glm::dot(p, axes[0]), glm::dot(p, axes[1]), glm::dot(p, along));
      lower = glm::min(lower, seen);
      upper = glm::max(upper, seen);
    }
  }
  const double back = lower.z - 0.1 * (upper.z - lower.z);
  const int side = options["rays"];
  std::vector<AimedRay> rays;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double x = lower.x + (upper.x - lower.x) * (i + 0.5) / side,
                   y = lower.y + (upper.y - lower.y) * (j + 0.5) / side;
      rays.push_back(
          {.start = glm::vec3(axes[0] * x + axes[1] * y + along * back), .direction = glm::vec3(along)});
    }
  return rays;
}

// What a ray becomes at the triangle that it meets: it is bent, or where it cannot be, mirrored. A mark of 0
// ends it.
AimedRay bent(const HierarchyBench& bench, const std::vector<TriangleId>& numbers, const AimedRay& ray,
              const glm::vec4& hit) {
  AimedRay next{.mark = 0.0f};
  if (!(hit.w > 0.0f)) return next;
  const TriangleId id = numbers[static_cast<std::size_t>(hit.w) - 1];
  const Mesh& mesh = bench.scene.meshes[static_cast<std::size_t>(id.mesh)];
  if (!mesh.closed()) return next;
  glm::vec3 position(0.0f), normal(0.0f);
  glm::vec3 corners[3];
  const float weights[3] = {1.0f - hit.x - hit.y, hit.x, hit.y};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex& vertex = mesh.vertices[mesh.indices[3 * static_cast<std::size_t>(id.triangle) + k]];
    corners[k] = vertex.position;
    position += weights[k] * vertex.position;
    normal += weights[k] * vertex.normal;
  }
  const float side =
      glm::dot(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), ray.direction) < 0.0f ? 1.0f
                                                                                                   : -1.0f;
  normal = side * glm::normalize(normal);
  const float eta = side > 0.0f ? 1.0f / 1.5f : 1.5f, along = glm::dot(normal, ray.direction);
  const float squared = 1.0f - eta * eta * (1.0f - along * along);
  const glm::vec3 way = squared > 0.0f && along < 0.0f
                            ? eta * ray.direction - (eta * along + std::sqrt(squared)) * normal
                            : ray.direction - 2.0f * along * normal;
  return {.start = position, .direction = glm::normalize(way), .mark = hit.w};
}

class Walker {
 public:
  Walker(Device& device, const HierarchyTables& tables)
      : device_(device),
        definition_(hit_definition(bench_walk_hit_shader)),
        nodes_(device, device.upload(tables.nodes)),
        triangles_(device, device.upload(tables.triangles)),
        normals_(device, device.upload(tables.normals)),
        target_(device, device.create_texture(Format::RGBA32F, options["rays"], options["rays"])) {}

  // What each ray meets; adds the median seconds.
  Image walk(const std::vector<AimedRay>& rays, double& seconds) {
    const int side = options["rays"];
    Image starts(Format::RGBA32F, side, side), directions(Format::RGBA32F, side, side);
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (std::size_t c = 0; c < 4; ++c) {
        const int k = static_cast<int>(c);
        starts.values[4 * i + c] = c < 3 ? rays[i].start[k] : rays[i].mark;
        directions.values[4 * i + c] = c < 3 ? rays[i].direction[k] : 0.0f;
      }
    const OwnedTexture start(device_, device_.upload(starts)), direction(device_, device_.upload(directions));
    PassRun run{.definition = &definition_, .colors = {target_.id()}};
    run.draws.push_back({.vertex_count = 3,
                         .uniforms = uniform_bytes(kAllCasters),
                         .textures = {start.id(), direction.id(), TextureId::None, nodes_.id(),
                                      triangles_.id(), normals_.id()}});
    std::vector<double> times;
    for (int i = 0; i < options["repeats"]; ++i) {
      device_.finish();
      const double before = processor_seconds();
      device_.run(run);
      device_.finish();
      times.push_back(processor_seconds() - before);
    }
    seconds += median(times);
    return device_.read_back(target_.id());
  }

 private:
  Device& device_;
  PassDefinition definition_;
  OwnedTexture nodes_, triangles_, normals_, target_;
};

void time_walk(const HierarchyBench& bench, const HierarchyTables& tables) {
  const auto device =
      options["gl"] != 0 ? make_gl_device() : make_software_device({.threads = options["threads"]});
  std::vector<TriangleId> numbers;
  for (std::size_t m = 0; m < bench.scene.meshes.size(); ++m)
    for (std::size_t t = 0; 3 * t < bench.scene.meshes[m].indices.size(); ++t)
      numbers.push_back({static_cast<int>(m), static_cast<int>(t)});
  Walker walker(*device, tables);
  std::vector<AimedRay> rays = light_onto(bench.scene);
  double first = 0.0, seconds = 0.0;
  std::size_t walks = 0, surfaces = 0, given_up = 0;
  for (int surface = 0; surface <= options["surfaces"]; ++surface) {
    const Image hits = walker.walk(rays, surface == 0 ? first : seconds);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const bool under_way = rays[i].mark > 0.0f;
      const glm::vec4 hit = under_way ? texel(hits, static_cast<int>(i) % options["rays"],
                                              static_cast<int>(i) / options["rays"])
                                      : glm::vec4(0.0f);
      walks += surface > 0 && under_way;
      surfaces += hit.w > 0.0f;
      given_up += hit.w < 0.0f;
      rays[i] = bent(bench, numbers, rays[i], hit);
    }
  }
  std::printf(
      "  walking: first %.3f s, then %zu walks %.3f s (%.0f ns each); %zu surfaces, %zu given up; %s\n",
      first, walks, seconds, 1e9 * seconds / static_cast<double>(std::max<std::size_t>(walks, 1)), surfaces,
      given_up, device->description().c_str());
}

void time_scene(const std::string& name, Scene scene) {
  const HierarchyBench bench = bench_of(std::move(scene));
  std::printf("%s, %d triangles\n", name.c_str(), bench.first_receiver());
  const HierarchyTables tables = time_making(bench);
  if (options["surfaces"] > 0) time_walk(bench, tables);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::string> files;
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    const std::size_t is = argument.find('=');
    if (const auto option = options.find(argument.substr(0, is));
        is != std::string::npos && option != options.end())
      option->second = std::atoi(argument.c_str() + is + 1);
    else
      files.push_back(argument);
  }
  for (const std::string& file : files)
    time_scene(std::filesystem::path(file).stem().string(), load_gltf(file));
  if (files.empty()) {
    Scene scene;
    scene.materials.resize(1);
    scene.meshes.push_back(sphere({0.0, 0.0, 0.0}, 0.5, 5, 0));
    time_scene("ball", std::move(scene));
  }
}
