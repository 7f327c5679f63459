// Times the software rasterizer's kernels, one thread, for every lane width of this build and processor:
// what a primitive or a fragment costs, or which share of the memory's bandwidth is used.
//   raster_bench [--benchmark_filter=cells.*avx2] [--benchmark_repetitions=9] [...]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/machine_limits.hpp"
#include "passes/caustic_cells/caustic_cells.hpp"
#include "raster/software_device.hpp"

namespace caustics {
extern const Shader bench_surface_shader;
extern const Shader bench_splat_shader;
extern const Shader bench_full_screen_shader;
extern const Shader bench_cells_shader;
}  // namespace caustics

namespace {

using namespace caustics;

constexpr int kSide = 512;  // of a target, in texels

// What a case draws. Without vertices and mesh its targets are cleared.
struct Drawing {
  PassDefinition definition{};
  int side = kSide;
  bool keeps = false;  // what the targets held
  MeshData mesh{};
  int vertex_count = 0;
  std::vector<Image> textures{};
  UniformBytes uniforms{};
};

TextureRead read(const char* name) { return {.name = name, .meaning = "bench"}; }

ColorWrite write(const char* name, Format format = Format::RGBA32F, const BlendState& blend = kReplace) {
  return {.name = name, .format = format, .meaning = "bench", .blend = blend};
}

// ---- triangles: into two float targets and depth, as receiver and caster maps are drawn

Drawing surface(MeshData mesh) {
  return {.definition = {.name = "surface",
                         .purpose = "bench",
                         .writes = {write("position_out"), write("normal_out")},
                         .depth = DepthWrite{.name = "depth", .meaning = "bench"},
                         .depth_state = {Compare::Less, true},
                         .shader = &bench_surface_shader},
          .mesh = std::move(mesh)};
}

MeshData surface_mesh() { return {.layout = {{"position", 3}, {"normal", 3}}, .vertices = {}}; }

void add_vertex(MeshData& mesh, float x, float y, float z) {
  mesh.vertices.insert(mesh.vertices.end(), {x, y, z, x, y, 1.0f});
}

// A wavy sheet over the whole target: 362 cells a side make triangles of one pixel.
Drawing small_triangles() {
  constexpr std::uint32_t kCells = 362;
  MeshData mesh = surface_mesh();
  for (std::uint32_t j = 0; j <= kCells; ++j)
    for (std::uint32_t i = 0; i <= kCells; ++i) {
      const float x = 2.0f * static_cast<float>(i) / kCells - 1.0f;
      const float y = 2.0f * static_cast<float>(j) / kCells - 1.0f;
      add_vertex(mesh, 0.99f * x, 0.99f * y, 0.5f + 0.2f * std::sin(9.0f * x) * std::cos(7.0f * y));
    }
  for (std::uint32_t j = 0; j < kCells; ++j)
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t a = j * (kCells + 1) + i, b = a + 1, c = a + kCells + 1, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
  return surface(std::move(mesh));
}

// Each before the one behind it, so that all fragments pass the depth test.
float depth_of_layer(int layer, int layers) {
  return 0.9f - 0.8f * static_cast<float>(layer) / static_cast<float>(layers);
}

Drawing large_triangles() {
  constexpr int kLayers = 4;
  MeshData mesh = surface_mesh();
  for (int i = 0; i < kLayers; ++i) {
    const float z = depth_of_layer(i, kLayers);
    for (const float sign : {-1.0f, 1.0f}) {
      add_vertex(mesh, -1.0f, -1.0f, z);
      add_vertex(mesh, 1.0f, 1.0f, z);
      add_vertex(mesh, sign, -sign, z);
    }
  }
  return surface(std::move(mesh));
}

// From a point of the left edge to a pixel of the right one, all through the target's middle.
Drawing slivers() {
  constexpr int kSlivers = 512;
  MeshData mesh = surface_mesh();
  for (int i = 0; i < kSlivers; ++i) {
    const float z = depth_of_layer(i, kSlivers), y = 2.0f * (static_cast<float>(i) + 0.25f) / kSlivers - 1.0f;
    add_vertex(mesh, -1.0f, y, z);
    add_vertex(mesh, 1.0f, -y, z);
    add_vertex(mesh, 1.0f, -y + 2.0f / static_cast<float>(kSide), z);
  }
  return surface(std::move(mesh));
}

// ---- rectangles around cells that are added up, with the shader of pass caustic_cells

// Corners a and b, c and d of cell (column, row) in texels, four floats each.
using Corners = std::array<std::array<float, 4>, 2>;

Drawing cells(int a_side, const std::function<Corners(int, int)>& corners) {
  std::vector<Image> textures(3, Image(Format::RGBA32F, a_side, a_side));
  for (int row = 0; row < a_side; ++row)
    for (int column = 0; column < a_side; ++column)
      for (int c = 0; c < 4; ++c) {
        const Corners laid = corners(column, row);
        for (std::size_t i = 0; i < 2; ++i)
          textures[i].at(column, row, c) = laid[i][static_cast<std::size_t>(c)];
        textures[2].at(column, row, c) = 1.0f;
      }
  return {
      .definition = {.name = "cells",
                     .purpose = "bench",
                     .reads = {read("cell_near"), read("cell_far"), read("cell_flux")},
                     .writes = {write("caustic_map", Format::RGBA32F, kAccumulate)},
                     .topology = Topology::Rectangles,
                     .zero_outside_quad = 0,
                     .shader = &bench_cells_shader},
      .vertex_count = a_side * a_side,
      .textures = std::move(textures),
      .uniforms = uniform_bytes(std140::CausticCells{
          .scale = glm::vec2(1.0f), .offset = glm::vec2(0.0f), .cells_a_side = a_side, .map_side = kSide})};
}

// Squares of 1.5 texels, slightly turned.
Drawing small_cells() {
  return cells(kSide / 2, [](int column, int row) {
    const float x = 2.0f * static_cast<float>(column) + 0.3f, y = 2.0f * static_cast<float>(row) + 0.2f;
    return Corners{{{x, y, x + 1.5f, y + 0.1f}, {x - 0.1f, y + 1.5f, x + 1.4f, y + 1.6f}}};
  });
}

// Two texels wide, slanted from the target's lower edge to its upper one: the rectangle around each is more
// than half of it.
Drawing elongated_cells() {
  constexpr int kCells = 8;
  return cells(kCells, [](int column, int row) {
    const float x = 8.3f + 2.5f * static_cast<float>(row * kCells + column), y = 480.4f;
    return Corners{{{x, 16.2f, x + 2.0f, 16.2f}, {x + 320.0f, y, x + 322.0f, y}}};
  });
}

// ---- points at places after a lens: most of them crowd in a bright spot and on a few curves

Drawing points(int grid, float size) {
  Image places(Format::RGBA32F, grid, grid);
  for (int j = 0; j < grid; ++j)
    for (int i = 0; i < grid; ++i) {
      const float x = 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(grid) - 1.0f;
      const float y = 2.0f * (static_cast<float>(j) + 0.5f) / static_cast<float>(grid) - 1.0f;
      const float r2 = x * x + y * y, pull = r2 < 0.5f ? 0.05f + 0.3f * r2 : 0.9f;
      places.at(i, j, 0) = 0.95f * x * pull + 0.02f * std::sin(17.0f * y);
      places.at(i, j, 1) = 0.95f * y * pull + 0.02f * std::sin(13.0f * x);
      places.at(i, j, 2) = 1.0f + 0.1f * x;
      places.at(i, j, 3) = 1.0f;
    }
  return {
      .definition = {.name = "splat",
                     .purpose = "bench",
                     .reads = {read("places")},
                     .writes = {write("map", Format::RGBA32F, kAccumulate)},
                     .topology = Topology::Points,
                     .shader = &bench_splat_shader},
      .vertex_count = grid * grid,
      .textures = {std::move(places)},
      .uniforms = uniform_bytes(glm::vec4(size, -0.8f, static_cast<float>(grid), static_cast<float>(kSide)))};
}

// ---- what moves texels: a texture of the target's size copied into it, and clears

// 64 MiB a texture, which is beyond the processor's caches.
Drawing clear(Format format, const BlendState& blend = kReplace) {
  return {.definition = {.name = "full_screen",
                         .purpose = "bench",
                         .reads = {read("source")},
                         .writes = {write("color", format, blend)},
                         .shader = &bench_full_screen_shader},
          .side = channel_count(format) == 1 ? 4096 : 2048,
          .keeps = blend.enabled};
}

Drawing copy(Format format, const BlendState& blend) {
  Drawing drawing = clear(format, blend);
  Image source(format, drawing.side, drawing.side);
  std::fill(source.values.begin(), source.values.end(), 0.25f);
  drawing.textures.push_back(std::move(source));
  drawing.vertex_count = 3;
  return drawing;
}

// ---- the table

enum class Bound { Primitives, Fragments, Memory };

struct Case {
  const char* name;
  Bound bound;
  std::function<Drawing()> make;
};

const Case kCases[] = {
    {"cells/elongated", Bound::Fragments, elongated_cells},
    {"cells/small", Bound::Fragments, small_cells},
    {"triangles/slivers", Bound::Fragments, slivers},
    {"triangles/small", Bound::Primitives, small_triangles},
    {"triangles/large", Bound::Fragments, large_triangles},
    {"points/1x1", Bound::Primitives, [] { return points(512, 1.0f); }},
    {"points/8x8", Bound::Fragments, [] { return points(128, 8.0f); }},
    {"replace/RGBA32F", Bound::Memory, [] { return copy(Format::RGBA32F, kReplace); }},
    {"replace/R32F", Bound::Memory, [] { return copy(Format::R32F, kReplace); }},
    {"replace/RGBA8", Bound::Memory, [] { return copy(Format::RGBA8, kReplace); }},
    {"add/RGBA32F", Bound::Memory, [] { return copy(Format::RGBA32F, kAccumulate); }},
    {"add/R32F", Bound::Memory, [] { return copy(Format::R32F, kAccumulate); }},
    {"add/RGBA8", Bound::Memory, [] { return copy(Format::RGBA8, kAccumulate); }},
    {"clear/RGBA32F", Bound::Memory, [] { return clear(Format::RGBA32F); }},
    {"clear/R32F", Bound::Memory, [] { return clear(Format::R32F); }},
    {"clear/RGBA8", Bound::Memory, [] { return clear(Format::RGBA8); }},
};

// ---- running it

// A drawing on a device, ready to be run.
class Runs {
 public:
  Runs(const Drawing& drawing, Lanes lanes) : device_(make_software_device({.threads = 1, .lanes = lanes})) {
    PassRun run;
    for (const ColorWrite& write : drawing.definition.writes)
      run.colors.push_back(target(write.format, drawing));
    if (drawing.definition.depth) run.depth = target(Format::Depth32F, drawing);
    run.keep.assign(run.colors.size() + (drawing.definition.depth ? 1 : 0), drawing.keeps);
    const bool has_mesh = !drawing.mesh.vertices.empty();
    if (has_mesh || drawing.vertex_count > 0) {
      Draw draw{.vertex_count = drawing.vertex_count, .uniforms = drawing.uniforms};
      if (has_mesh) draw.mesh = device_->create_mesh(drawing.mesh);
      for (const Image& image : drawing.textures) {
        draw.textures.push_back(device_->upload(image));
        bytes_ += sizeof(float) * static_cast<double>(image.values.size());
      }
      run.draws.push_back(std::move(draw));
    }
    runs_.fill(run);
    definitions_.fill(drawing.definition);
    // In turn, as a device need not clear again what holds its colour already.
    for (ColorWrite& write : definitions_[1].writes) write.clear.fill(1.0f);
    for (std::size_t i = 0; i < 2; ++i) runs_[i].definition = &definitions_[i];
    if (drawing.keeps) clear_targets();
  }
  Runs(const Runs&) = delete;  // runs point to definitions

  PassResult next() { return device_->run(runs_[++count_ % 2]); }

  // Of targets written, and read where they are kept, and of textures read: each once, a float a channel, as
  // the device holds them.
  double bytes() const { return bytes_; }

 private:
  TextureId target(Format format, const Drawing& drawing) {
    bytes_ += static_cast<double>(sizeof(float)) * channel_count(format) * drawing.side * drawing.side *
              (drawing.keeps ? 2.0 : 1.0);
    return device_->create_texture(format, drawing.side, drawing.side);
  }

  // A new texture holds anything.
  void clear_targets() {
    PassRun clear = runs_[0];
    clear.keep.clear();
    clear.draws.clear();
    device_->run(clear);
  }

  std::unique_ptr<Device> device_;
  std::array<PassDefinition, 2> definitions_;
  std::array<PassRun, 2> runs_;
  std::size_t count_ = 0;
  double bytes_ = 0.0;
};

// Bytes a second; a triad's, which reads twice what it writes. Clears only write: they may get beyond it.
double bandwidth() {
  static const double measured = app::memory_bandwidth(1);
  return measured;
}

void time(benchmark::State& state, const Case& timed, Lanes lanes) {
  using benchmark::Counter;
  Runs runs(timed.make(), lanes);
  PassResult result = runs.next();
  for (auto _ : state) result = runs.next();
  const auto rate = [&](const char* name, double each, bool inverse = false) {
    const int kind = Counter::kIsIterationInvariantRate | (inverse ? Counter::kInvert : 0);
    if (each > 0.0) state.counters[name] = Counter(each, static_cast<Counter::Flags>(kind));
  };
  const auto primitives = static_cast<double>(result.primitives);
  const auto fragments = static_cast<double>(result.fragments);
  rate("primitives/s", primitives);
  rate("fragments/s", fragments);
  rate("bytes/s", runs.bytes());
  if (timed.bound == Bound::Memory) rate("of_bandwidth", runs.bytes() / bandwidth());
  if (timed.bound == Bound::Primitives) rate("s/primitive", primitives, true);
  if (timed.bound == Bound::Fragments) rate("s/fragment", fragments, true);
}

}  // namespace

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  for (const Case& timed : kCases)
    for (const Lanes lanes : supported_lanes())
      benchmark::RegisterBenchmark((timed.name + ("/" + std::string(lanes_name(lanes)))).c_str(),
                                   [&timed, lanes](benchmark::State& state) { time(state, timed, lanes); })
          ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
}
