#include "raster/target.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <numeric>

namespace caustics::raster {

namespace {

using Texel = std::array<float, 4>;

Texel cleared(const ColorWrite& write) {
  Texel texel;
  for (std::size_t c = 0; c < 4; ++c) texel[c] = stored_value(write.format, write.clear[c]);
  return texel;
}

void fill_texels(float* out, int count, int channels, const Texel& texel) {
  if (channels == 1) {
    std::fill_n(out, count, texel[0]);
  } else if (channels == 4) {
    for (int i = 0; i < count; ++i, out += 4) std::memcpy(out, texel.data(), sizeof texel);
  } else {
    for (int i = 0; i < count; ++i, out += channels) std::copy_n(texel.data(), channels, out);
  }
}

// From now on tiles are known to hold this texel, or not.
void begin_clear(Texture& texture, const Texel& texel, std::size_t tiles) {
  if (!same_bits(texture.clear_texel, texel) || texture.clear_tiles.size() != tiles)
    texture.clear_tiles.assign(tiles, 0);
  texture.clear_texel = texel;
}

std::size_t tiles_of(const ImageShape& shape) {
  return static_cast<std::size_t>((shape.width + kTile - 1) / kTile) *
         static_cast<std::size_t>((shape.height + kTile - 1) / kTile);
}

// Unless it is known to hold the texel.
void clear_tile(Texture& texture, int index, const Texel& texel) {
  if (texture.is_clear(static_cast<std::size_t>(index), texel)) return;
  const TileGrid grid(texture.shape.width, texture.shape.height);
  const int x = index % grid.columns * kTile, y = index / grid.columns * kTile;
  const int width = std::min(kTile, grid.width - x), above = std::min(y + kTile, grid.height);
  for (int row = y; row < above; ++row) fill_texels(texture.texel(x, row), width, texture.channels(), texel);
  if (!texture.clear_tiles.empty()) texture.clear_tiles[static_cast<std::size_t>(index)] = 1;
}

// Does a texel's one channel take what is drawn as it is, or add it?
bool is_single(const ColorWrite& write) {
  return write.format == Format::R32F && write.mask[0] &&
         (!write.blend.enabled || write.blend == kAccumulate);
}

// A tile's attachments while it is drawn: compact, so that they stay in the cache.
struct TileStorage {
  alignas(64) float color[kMaxColors][kTile * kTile][4];
  alignas(64) float depth[kTile * kTile];
};

// Are most texels drawn once? Then a tile's copy would cost more than it saves.
bool is_drawn_in_place(const RenderTarget& target, const PassDefinition& definition) {
  return !target.depth && definition.topology == Topology::Triangles &&
         std::all_of(target.colors.begin(), target.colors.end(), [](const RenderTarget::Color& color) {
           return !color.texture || color.texture->channels() == 4 || is_single(*color.write);
         });
}

class Tile {
 public:
  Tile(const TileGrid& grid, int index, const RenderTarget& target, bool in_place, TileStorage& storage)
      : target_(target), in_place_(in_place), storage_(storage) {
    index_ = static_cast<std::size_t>(index);
    x_ = index % grid.columns * kTile;
    y_ = index / grid.columns * kTile;
    width_ = std::min(kTile, grid.width - x_);
    height_ = std::min(kTile, grid.height - y_);
  }

  void load_colors() {
    if (in_place_) return clear_colors();
    for (std::size_t i = 0; i < target_.colors.size(); ++i)
      if (target_.colors[i].texture) load_color(i);
  }

  void load_depth() {
    if (!target_.depth) return;
    for (int y = 0; y < height_; ++y) {
      float* const row = storage_.depth + static_cast<std::ptrdiff_t>(y) * kTile;
      if (target_.keep_depth)
        std::copy_n(target_.depth->texel(x_, y_ + y), width_, row);
      else
        std::fill_n(row, width_, target_.depth_clear);
    }
  }

  // `drawn`: any fragment has passed. What holds its contents anyway is left alone.
  void store(bool drawn) {
    if (!drawn) clear_colors();
    for (std::size_t i = 0; i < target_.colors.size(); ++i) {
      const RenderTarget::Color& color = target_.colors[i];
      if (!color.texture || !drawn) continue;
      if (!color.texture->clear_tiles.empty()) color.texture->clear_tiles[index_] = 0;
      if (in_place_) continue;
      const int channels = color.texture->channels();
      for (int y = 0; y < height_; ++y) {
        float* out = color.texture->texel(x_, y_ + y);
        if (is_single(*color.write)) {
          std::copy_n(values_of(i) + static_cast<std::ptrdiff_t>(y) * kTile, width_, out);
          continue;
        }
        const float(*row)[4] = storage_.color[i] + static_cast<std::ptrdiff_t>(y) * kTile;
        if (channels == 4) {
          std::memcpy(out, row, sizeof(Texel) * static_cast<std::size_t>(width_));
        } else if (channels == 1) {
          for (int x = 0; x < width_; ++x) out[x] = row[x][0];
        } else {
          for (int x = 0; x < width_; ++x)
            for (int c = 0; c < channels; ++c) *out++ = row[x][c];
        }
      }
    }
    if (!target_.depth) return;
    for (int y = 0; y < height_; ++y)
      std::copy_n(storage_.depth + static_cast<std::ptrdiff_t>(y) * kTile, width_,
                  target_.depth->texel(x_, y_ + y));
  }

  TileJob job(const FragmentWork& work, const std::vector<PrimitiveChunk>& chunks) {
    TileJob job = job_of(work);
    job.x = x_;
    job.y = y_;
    job.width = width_;
    job.height = height_;
    job.color_count = static_cast<int>(target_.colors.size());
    for (std::size_t i = 0; i < target_.colors.size(); ++i) {
      const RenderTarget::Color& color = target_.colors[i];
      const ColorWrite& write = *color.write;
      float* const texels = !color.texture ? nullptr
                            : in_place_    ? color.texture->texel(x_, y_)
                                           : values_of(i);
      const bool single = is_single(write);
      job.colors[i] = {single ? nullptr : reinterpret_cast<float(*)[4]>(texels),
                       single ? texels : nullptr,
                       write.format,
                       write.blend,
                       {}};
      for (std::size_t c = 0; c < 4; ++c) job.colors[i].mask[c] = write.mask[c];
    }
    if (in_place_) job.row = target_.shape().width;
    job.depth = target_.depth ? storage_.depth : nullptr;
    job.chunks = chunks.data();
    job.chunk_count = static_cast<int>(chunks.size());
    job.load_colors = [](void* tile) { static_cast<Tile*>(tile)->load_colors(); };
    job.tile = this;
    job.discards_where_zero = {};
    for (const Texture* texture : work.idle_where_zero)
      if (texture->channels() == 4) job.discards_where_zero = {texture->values.get(), texture->shape.width};
    return job;
  }

 private:
  void clear_colors() {
    for (const RenderTarget::Color& color : target_.colors)
      if (color.texture && !color.keep)
        clear_tile(*color.texture, static_cast<int>(index_), cleared(*color.write));
  }

  float* values_of(std::size_t i) const { return storage_.color[i][0]; }

  void load_values(std::size_t i) {
    const RenderTarget::Color& color = target_.colors[i];
    for (int y = 0; y < height_; ++y) {
      float* const row = values_of(i) + static_cast<std::ptrdiff_t>(y) * kTile;
      if (color.keep)
        std::copy_n(color.texture->texel(x_, y_ + y), width_, row);
      else
        std::fill_n(row, width_, cleared(*color.write)[0]);
    }
  }

  void load_color(std::size_t i) {
    if (is_single(*target_.colors[i].write)) return load_values(i);
    const RenderTarget::Color& color = target_.colors[i];
    const int channels = color.texture->channels();
    Texel texel = cleared(*color.write);
    for (int c = channels; c < 4; ++c) texel[static_cast<std::size_t>(c)] = c == 3 ? 1.0f : 0.0f;
    for (int y = 0; y < height_; ++y) {
      float(*row)[4] = storage_.color[i] + static_cast<std::ptrdiff_t>(y) * kTile;
      if (!color.keep) {
        for (int x = 0; x < width_; ++x) std::memcpy(row[x], texel.data(), sizeof texel);
      } else if (channels == 4) {
        std::memcpy(row, color.texture->texel(x_, y_ + y), sizeof(Texel) * static_cast<std::size_t>(width_));
      } else {
        const float* in = color.texture->texel(x_, y_ + y);
        for (int x = 0; x < width_; ++x) {
          for (int c = 0; c < channels; ++c) texel[static_cast<std::size_t>(c)] = *in++;
          std::memcpy(row[x], texel.data(), sizeof texel);
        }
      }
    }
  }

  const RenderTarget& target_;
  bool in_place_;
  TileStorage& storage_;
  std::size_t index_ = 0;
  int x_ = 0, y_ = 0, width_ = 0, height_ = 0;
};

std::vector<PrimitiveChunk> chunks_of_tile(const std::vector<BinnedChunk>& chunks, std::size_t tile) {
  std::vector<PrimitiveChunk> result;
  for (const BinnedChunk& chunk : chunks) {
    const std::uint32_t first = chunk.first[tile], last = chunk.first[tile + 1];
    if (first == last) continue;
    result.push_back(
        {chunk.triangles.data(), chunk.points.data(), chunk.touching.data() + first, last - first});
  }
  return result;
}

// Tile numbers, the fullest first; equal ones by number.
std::vector<int> fullest_first(const std::vector<BinnedChunk>& chunks, const TileGrid& grid) {
  std::vector<std::uint64_t> load(static_cast<std::size_t>(grid.count()));
  for (std::size_t t = 0; t < load.size(); ++t)
    for (const BinnedChunk& chunk : chunks) load[t] += chunk.first[t + 1] - chunk.first[t];
  std::vector<int> order(load.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return load[static_cast<std::size_t>(a)] > load[static_cast<std::size_t>(b)];
  });
  return order;
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
    const Texel texel = cleared(*color.write);
    const std::size_t tiles = tiles_of(color.texture->shape);
    begin_clear(*color.texture, texel, tiles);
    if (color.texture->is_fresh() && same_bits(texel, Texel{})) {
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

TileCounters fill_tiles(const FragmentWork& work, const std::vector<BinnedChunk>& chunks,
                        const TileGrid& grid, RenderTarget& target, const Workers& workers) {
  const bool all_kept = (!target.depth || target.keep_depth) &&
                        std::all_of(target.colors.begin(), target.colors.end(),
                                    [](const RenderTarget::Color& c) { return c.keep; });
  for (RenderTarget::Color& color : target.colors)
    if (color.texture && !color.keep)
      begin_clear(*color.texture, cleared(*color.write), static_cast<std::size_t>(grid.count()));
  const bool in_place = is_drawn_in_place(target, *work.definition);
  const std::vector<int> order = fullest_first(chunks, grid);
  std::vector<TileCounters> counters(order.size());
  workers.run(static_cast<int>(order.size()), [&](int i) {
    thread_local const std::unique_ptr<TileStorage> storage = std::make_unique<TileStorage>();
    const int index = order[static_cast<std::size_t>(i)];
    const std::vector<PrimitiveChunk> touching = chunks_of_tile(chunks, static_cast<std::size_t>(index));
    if (touching.empty() && all_kept) return;
    Tile tile(grid, index, target, in_place, *storage);
    TileCounters& counted = counters[static_cast<std::size_t>(i)];
    const bool idle = std::any_of(
        work.idle_where_zero.begin(), work.idle_where_zero.end(),
        [&](const Texture* read) { return read->is_clear(static_cast<std::size_t>(index), Texel{}); });
    tile.load_depth();
    const std::uint64_t before = operations_of_thread;
    if (!idle) work.kernel(tile.job(work, touching), counted);
    counted.operations = operations_of_thread - before;
    tile.store(counted.samples_passed > 0);
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
