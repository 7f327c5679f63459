// Times the software rasterizer on the workloads that caustics mapping is made of: surfaces into float
// targets, point splats that focus, full-screen passes. Prints milliseconds: the median and the least.
//   raster_bench [threads ...]        default: 1 2
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "raster/software_device.hpp"

namespace caustics {
extern const Shader bench_surface_shader;
extern const Shader bench_splat_shader;
extern const Shader bench_full_screen_shader;
}  // namespace caustics

namespace {

using namespace caustics;

constexpr int kSize = 512;
constexpr int kRepeats = 15;

void report(const char* what, int threads, const std::function<PassResult()>& run) {
  std::vector<double> times;
  PassResult result;
  for (int i = 0; i < kRepeats; ++i) {
    result = run();
    times.push_back(result.milliseconds);
  }
  std::sort(times.begin(), times.end());
  std::printf("%-34s %d threads  median %8.2f ms  least %8.2f ms  %9llu fragments\n", what, threads,
              times[times.size() / 2], times[0], static_cast<unsigned long long>(result.fragments));
}

// A wavy sheet of 2 * cells^2 triangles over the whole target.
MeshData wavy_sheet(int cells) {
  MeshData mesh;
  mesh.layout = {{"position", 3}, {"normal", 3}};
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const float x = 2.0f * static_cast<float>(i) / static_cast<float>(cells) - 1.0f;
      const float y = 2.0f * static_cast<float>(j) / static_cast<float>(cells) - 1.0f;
      const float z = 0.5f + 0.2f * std::sin(9.0f * x) * std::cos(7.0f * y);
      mesh.vertices.insert(mesh.vertices.end(), {0.99f * x, 0.99f * y, z, x, y, 1.0f});
    }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (cells + 1) + i), b = a + 1;
      const std::uint32_t c = a + static_cast<std::uint32_t>(cells) + 1, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
  return mesh;
}

void time_surface(Device& device, int threads, int cells, const char* name) {
  const PassDefinition definition{
      .name = "surface",
      .purpose = "bench",
      .writes = {{.name = "position", .meaning = "m"}, {.name = "normal", .meaning = "m"}},
      .depth = DepthWrite{.name = "depth", .meaning = "m"},
      .depth_state = {Compare::Less, true},
      .shader = &bench_surface_shader};
  PassRun run{.definition = &definition};
  for (int i = 0; i < 2; ++i) run.colors.push_back(device.create_texture(Format::RGBA32F, kSize, kSize));
  run.depth = device.create_texture(Format::Depth32F, kSize, kSize);
  run.draws.push_back({.mesh = device.create_mesh(wavy_sheet(cells))});
  report(name, threads, [&] { return device.run(run); });
}

// Places of grid points after a lens: most of them crowd in a bright spot and on a few curves.
Image focused_places(int grid) {
  Image image(Format::RGBA32F, grid, grid);
  for (int j = 0; j < grid; ++j)
    for (int i = 0; i < grid; ++i) {
      const float x = 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(grid) - 1.0f;
      const float y = 2.0f * (static_cast<float>(j) + 0.5f) / static_cast<float>(grid) - 1.0f;
      const float r2 = x * x + y * y, pull = r2 < 0.5f ? 0.05f + 0.3f * r2 : 0.9f;
      image.at(i, j, 0) = 0.95f * x * pull + 0.02f * std::sin(17.0f * y);
      image.at(i, j, 1) = 0.95f * y * pull + 0.02f * std::sin(13.0f * x);
      image.at(i, j, 2) = 1.0f + 0.1f * x;
      image.at(i, j, 3) = 1.0f;
    }
  return image;
}

Draw splat_draw(TextureId places, int grid, float size) {
  const float block[4] = {size, -0.8f, static_cast<float>(grid), static_cast<float>(kSize)};
  Draw draw{.vertex_count = grid * grid, .textures = {places}};
  draw.uniforms.resize(sizeof block);
  std::memcpy(draw.uniforms.data(), block, sizeof block);
  return draw;
}

void time_splats(Device& device, int threads, int grid, float size) {
  const PassDefinition definition{.name = "splat",
                                  .purpose = "bench",
                                  .reads = {{.name = "places", .meaning = "m"}},
                                  .writes = {{.name = "map", .meaning = "m", .blend = kAccumulate}},
                                  .topology = Topology::Points,
                                  .shader = &bench_splat_shader};
  PassRun run{.definition = &definition};
  run.colors.push_back(device.create_texture(Format::RGBA32F, kSize, kSize));
  run.draws.push_back(splat_draw(device.upload(focused_places(grid)), grid, size));
  const std::string name =
      std::to_string(grid * grid) + " splats of size " + std::to_string(static_cast<int>(size));
  report(name.c_str(), threads, [&] { return device.run(run); });
}

void time_full_screen(Device& device, int threads) {
  const PassDefinition definition{.name = "full_screen",
                                  .purpose = "bench",
                                  .reads = {{.name = "places", .meaning = "m"}},
                                  .writes = {{.name = "color", .meaning = "m"}},
                                  .shader = &bench_full_screen_shader};
  PassRun run{.definition = &definition};
  run.colors.push_back(device.create_texture(Format::RGBA32F, kSize, kSize));
  run.draws.push_back({.vertex_count = 3, .textures = {device.upload(focused_places(kSize))}});
  report("full screen, one texture", threads, [&] { return device.run(run); });
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<int> threads;
  for (int i = 1; i < count; ++i) threads.push_back(std::atoi(arguments[i]));
  if (threads.empty()) threads = {1, 2};
  for (const int n : threads) {
    const auto device = make_software_device({.threads = n});
    std::printf("%s\n", device->description().c_str());
    time_surface(*device, n, 316, "199712 triangles, 2 targets, depth");
    time_surface(*device, n, 100, "20000 triangles, 2 targets, depth");
    for (const int grid : {512, 1024})
      for (const float size : {1.0f, 5.0f}) time_splats(*device, n, grid, size);
    time_full_screen(*device, n);
  }
}
