#include "raster/target.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

#include "raster/tile.hpp"

namespace caustics::raster {

namespace {

// From now on tiles are known to hold this texel, or not.
void begin_clear(Texture& texture, const std::array<float, 4>& texel, std::size_t tiles) {
  if (!same_bits(texture.clear_texel, texel) || texture.clear_tiles.size() != tiles)
    texture.clear_tiles.assign(tiles, 0);
  texture.clear_texel = texel;
}

std::size_t tiles_of(const ImageShape& shape) {
  return static_cast<std::size_t>((shape.width + kTile - 1) / kTile) *
         static_cast<std::size_t>((shape.height + kTile - 1) / kTile);
}

// Into memory of before.
void find_chunks(const BinnedDraw& draw, std::size_t tile, std::vector<PrimitiveChunk>& found) {
  found.clear();
  for (const BinnedChunk& chunk : *draw.chunks) {
    const std::uint32_t first = chunk.first[tile], last = chunk.first[tile + 1];
    if (first == last) continue;
    found.push_back(
        {chunk.triangles.data(), chunk.points.data(), chunk.touching.data() + first, last - first});
  }
}

// How many primitives touch a tile.
std::vector<std::uint64_t> load_of_tiles(std::span<const BinnedDraw> draws, const TileGrid& grid) {
  std::vector<std::uint64_t> load(static_cast<std::size_t>(grid.count()));
  for (const BinnedDraw& draw : draws)
    for (const BinnedChunk& chunk : *draw.chunks)
      for (std::size_t t = 0; t < load.size(); ++t) load[t] += chunk.first[t + 1] - chunk.first[t];
  return load;
}

// Tile numbers, the fullest first; equal ones by number.
std::vector<int> fullest_first(const std::vector<std::uint64_t>& load) {
  std::vector<int> order(load.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return load[static_cast<std::size_t>(a)] > load[static_cast<std::size_t>(b)];
  });
  return order;
}

bool is_idle(const FragmentWork& work, int tile) {
  return std::any_of(work.idle_where_zero.begin(), work.idle_where_zero.end(), [&](const Texture* read) {
    return read->is_clear(static_cast<std::size_t>(tile), std::array<float, 4>{});
  });
}

TileCounters fill_tile(std::span<const BinnedDraw> draws, int index, Tile& tile) {
  thread_local std::vector<PrimitiveChunk> touching;
  TileCounters counted;
  const std::uint64_t before = operations_of_thread;
  tile.load_depth();
  for (const BinnedDraw& draw : draws) {
    find_chunks(draw, static_cast<std::size_t>(index), touching);
    if (!touching.empty() && !is_idle(*draw.work, index))
      draw.work->kernel(tile.job(*draw.work, touching), counted);
  }
  counted.operations = operations_of_thread - before;
  tile.store(counted.samples_passed > 0);
  return counted;
}

}  // namespace

ImageShape RenderTarget::shape() const {
  if (depth) return depth->shape;
  return std::find_if(colors.begin(), colors.end(), [](const Color& color) { return color.texture; })
      ->texture->shape;
}

void RenderTarget::clear(const Workers& workers) {
  for (const Color& color : colors) {
    if (color.keep || !color.texture) continue;
    const std::array<float, 4> texel = cleared(*color.write);
    const std::size_t tiles = tiles_of(color.texture->shape);
    begin_clear(*color.texture, texel, tiles);
    if (color.texture->is_fresh() && same_bits(texel, std::array<float, 4>{})) {
      color.texture->clear_tiles.assign(tiles, 1);
      continue;
    }
    color.texture->bring_in(workers);
    for (int tile = 0; tile < static_cast<int>(tiles); ++tile) clear_tile(*color.texture, tile, texel);
  }
  if (!depth || keep_depth) return;
  depth->bring_in(workers);
  std::fill_n(depth->values.get(), depth->value_count(), depth_clear);
}

void RenderTarget::keep_all() {
  for (Color& color : colors) color.keep = true;
  keep_depth = true;
}

TileJob job_of(const FragmentWork& work) {
  TileJob job{};
  job.depth_state = work.definition->depth_state;
  job.test_depth_late = work.may_discard;
  job.is_points = work.definition->topology != Topology::Triangles;
  job.zero_outside_quad = work.definition->zero_outside_quad.value_or(-1);
  job.fragment = work.fragment;
  job.uniforms = work.uniforms;
  job.textures = work.textures;
  job.varying_count = work.varying_count;
  job.varying_flat = work.varying_flat;
  job.row = kTile;
  return job;
}

TileCounters fill_tiles(std::span<const BinnedDraw> draws, const TileGrid& grid, RenderTarget& target,
                        const Workers& workers) {
  const bool all_kept = (!target.depth || target.keep_depth) &&
                        std::all_of(target.colors.begin(), target.colors.end(),
                                    [](const RenderTarget::Color& c) { return c.keep; });
  for (RenderTarget::Color& color : target.colors)
    if (color.texture && !color.keep)
      begin_clear(*color.texture, cleared(*color.write), static_cast<std::size_t>(grid.count()));
  const bool in_place = is_drawn_in_place(target, *draws.front().work->definition);
  const std::vector<std::uint64_t> load = load_of_tiles(draws, grid);
  const std::vector<int> order = fullest_first(load);
  std::vector<TileCounters> counters(order.size());
  workers.run(static_cast<int>(order.size()), [&](int i) {
    thread_local const std::unique_ptr<TileStorage> storage = std::make_unique<TileStorage>();
    const int index = order[static_cast<std::size_t>(i)];
    if (load[static_cast<std::size_t>(index)] == 0 && all_kept) return;
    Tile tile(grid, index, target, in_place, *storage);
    counters[static_cast<std::size_t>(i)] = fill_tile(draws, index, tile);
  });
  TileCounters sum;
  for (const TileCounters& c : counters) {
    sum.fragments += c.fragments;
    sum.samples_passed += c.samples_passed;
    sum.operations += c.operations;
  }
  return sum;
}

}  // namespace caustics::raster
