#include "raster/tile.hpp"

#include <algorithm>
#include <cstring>

namespace caustics::raster {

namespace {

using Texel = std::array<float, 4>;

void fill_texels(float* out, int count, int channels, const Texel& texel) {
  if (channels == 1) {
    std::fill_n(out, count, texel[0]);
  } else if (channels == 4) {
    for (int i = 0; i < count; ++i, out += 4) std::memcpy(out, texel.data(), sizeof texel);
  } else {
    for (int i = 0; i < count; ++i, out += channels) std::copy_n(texel.data(), channels, out);
  }
}

// Does a texel's one channel take what is drawn as it is, or add it?
bool is_single(const ColorWrite& write) {
  return write.format == Format::R32F && write.mask[0] &&
         (!write.blend.enabled || write.blend == kAccumulate);
}

}  // namespace

std::array<float, 4> cleared(const ColorWrite& write) {
  Texel texel;
  for (std::size_t c = 0; c < 4; ++c) texel[c] = stored_value(write.format, write.clear[c]);
  return texel;
}

void clear_tile(Texture& texture, int index, const Texel& texel) {
  if (texture.is_clear(static_cast<std::size_t>(index), texel)) return;
  const TileGrid grid(texture.shape.width, texture.shape.height);
  const int x = index % grid.columns * kTile, y = index / grid.columns * kTile;
  const int width = std::min(kTile, grid.width - x), above = std::min(y + kTile, grid.height);
  for (int row = y; row < above; ++row) fill_texels(texture.texel(x, row), width, texture.channels(), texel);
  if (!texture.clear_tiles.empty()) texture.clear_tiles[static_cast<std::size_t>(index)] = 1;
}

bool is_drawn_in_place(const RenderTarget& target, const PassDefinition& definition) {
  return !target.depth && definition.topology == Topology::Triangles &&
         std::all_of(target.colors.begin(), target.colors.end(), [](const RenderTarget::Color& color) {
           return !color.texture || color.texture->channels() == 4 || is_single(*color.write);
         });
}

Tile::Tile(const TileGrid& grid, int index, const RenderTarget& target, bool in_place, TileStorage& storage)
    : target_(target), in_place_(in_place), storage_(storage) {
  index_ = static_cast<std::size_t>(index);
  x_ = index % grid.columns * kTile;
  y_ = index / grid.columns * kTile;
  width_ = std::min(kTile, grid.width - x_);
  height_ = std::min(kTile, grid.height - y_);
}

void Tile::load_depth() {
  if (!target_.depth) return;
  for (int y = 0; y < height_; ++y) {
    float* const row = storage_.depth + static_cast<std::ptrdiff_t>(y) * kTile;
    if (target_.keep_depth)
      std::copy_n(target_.depth->texel(x_, y_ + y), width_, row);
    else
      std::fill_n(row, width_, target_.depth_clear);
  }
}

TileJob Tile::job(const FragmentWork& work, const std::vector<PrimitiveChunk>& chunks) {
  TileJob job = job_of(work);
  job.x = x_;
  job.y = y_;
  job.width = width_;
  job.height = height_;
  job.color_count = static_cast<int>(target_.colors.size());
  for (std::size_t i = 0; i < target_.colors.size(); ++i) {
    const RenderTarget::Color& color = target_.colors[i];
    const ColorWrite& write = *color.write;
    float* const texels = !color.texture ? nullptr : in_place_ ? color.texture->texel(x_, y_) : values_of(i);
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

void Tile::store(bool drawn) {
  if (!drawn) clear_colors();
  for (std::size_t i = 0; i < target_.colors.size(); ++i) {
    Texture* const texture = target_.colors[i].texture;
    if (!texture || !drawn) continue;
    if (!texture->clear_tiles.empty()) texture->clear_tiles[index_] = 0;
    if (!in_place_) store_color(i);
  }
  if (!target_.depth) return;
  for (int y = 0; y < height_; ++y)
    std::copy_n(storage_.depth + static_cast<std::ptrdiff_t>(y) * kTile, width_,
                target_.depth->texel(x_, y_ + y));
}

void Tile::store_color(std::size_t i) {
  Texture& texture = *target_.colors[i].texture;
  const bool single = is_single(*target_.colors[i].write);
  const int channels = texture.channels();
  for (int y = 0; y < height_; ++y) {
    float* out = texture.texel(x_, y_ + y);
    const float(*row)[4] = storage_.color[i] + static_cast<std::ptrdiff_t>(y) * kTile;
    if (single) {
      std::copy_n(values_of(i) + static_cast<std::ptrdiff_t>(y) * kTile, width_, out);
    } else if (channels == 4) {
      std::memcpy(out, row, sizeof(Texel) * static_cast<std::size_t>(width_));
    } else if (channels == 1) {
      for (int x = 0; x < width_; ++x) out[x] = row[x][0];
    } else {
      for (int x = 0; x < width_; ++x)
        for (int c = 0; c < channels; ++c) *out++ = row[x][c];
    }
  }
}

void Tile::load_colors() {
  if (in_place_) return clear_colors();
  for (std::size_t i = 0; i < target_.colors.size(); ++i)
    if (target_.colors[i].texture) load_color(i);
}

void Tile::load_color(std::size_t i) {
  if (is_single(*target_.colors[i].write)) return load_values(i);
  const RenderTarget::Color& color = target_.colors[i];
  const int channels = color.texture->channels();
  Texel texel = cleared(*color.write);
  for (int c = channels; c < 4; ++c) texel[static_cast<std::size_t>(c)] = c == 3 ? 1.0f : 0.0f;
  for (int y = 0; y < height_; ++y) {
    float(*row)[4] = storage_.color[i] + static_cast<std::ptrdiff_t>(y) * kTile;
    if (!color.keep) {
      fill_texels(row[0], width_, 4, texel);
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

void Tile::load_values(std::size_t i) {
  const RenderTarget::Color& color = target_.colors[i];
  for (int y = 0; y < height_; ++y) {
    float* const row = values_of(i) + static_cast<std::ptrdiff_t>(y) * kTile;
    if (color.keep)
      std::copy_n(color.texture->texel(x_, y_ + y), width_, row);
    else
      std::fill_n(row, width_, cleared(*color.write)[0]);
  }
}

void Tile::clear_colors() {
  for (const RenderTarget::Color& color : target_.colors)
    if (color.texture && !color.keep)
      clear_tile(*color.texture, static_cast<int>(index_), cleared(*color.write));
}

}  // namespace caustics::raster
