#include "pipeline/scene/mip_levels.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace caustics {

namespace {

constexpr std::array kSeenByCamera{&Material::base_color_texture, &Material::normal_texture,
                                   &Material::emissive_texture, &Material::metallic_roughness_texture,
                                   &Material::occlusion_texture};

int halved(int side, int level) { return std::max(1, side >> level); }

// The texels of a finer level that one of the coarser covers along an axis, and how much of each counts.
struct Cover {
  int first = 0, count = 1;
  double weights[3] = {1.0, 0.0, 0.0};
};

Cover cover_of(int texel, int finer, int coarser) {
  Cover cover;
  if (finer == coarser) return cover;
  cover.first = 2 * texel;
  if (finer == 2 * coarser) {
    cover.count = 2;
    cover.weights[0] = cover.weights[1] = 0.5;
    return cover;
  }
  // 2 n + 1 over n texels: the borders of the coarser ones cut the finer ones at multiples of 1 / n.
  cover.count = 3;
  cover.weights[0] = static_cast<double>(coarser - texel) / finer;
  cover.weights[1] = static_cast<double>(coarser) / finer;
  cover.weights[2] = static_cast<double>(texel + 1) / finer;
  return cover;
}

// A rectangle of texels within an image.
struct Area {
  int x = 0, y = 0, width = 0, height = 0;
};

const float* texel_at(const Image& image, int x, int y) {
  return &image.values[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width()) +
                            static_cast<std::size_t>(x))];
}

// All channels of the texels from (x, y) on that one coarser texel covers.
std::array<double, 4> mean_of(const Image& image, int x, int y, const Cover& columns, const Cover& rows) {
  std::array<double, 4> sum{};
  for (int j = 0; j < rows.count; ++j) {
    const float* texel = texel_at(image, x, y + j);
    for (int i = 0; i < columns.count; ++i) {
      const double weight = rows.weights[j] * columns.weights[i];
      for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * static_cast<double>(*texel++);
    }
  }
  return sum;
}

void fill_level(const Image& from, const Area& finer, Image& to, const Area& coarser) {
  std::vector<Cover> columns;
  columns.reserve(static_cast<std::size_t>(coarser.width));
  for (int x = 0; x < coarser.width; ++x) columns.push_back(cover_of(x, finer.width, coarser.width));
  for (int y = 0; y < coarser.height; ++y) {
    const Cover rows = cover_of(y, finer.height, coarser.height);
    for (int x = 0; x < coarser.width; ++x) {
      const Cover& column = columns[static_cast<std::size_t>(x)];
      const auto mean = mean_of(from, finer.x + column.first, finer.y + rows.first, column, rows);
      for (int c = 0; c < 4; ++c)
        to.at(coarser.x + x, coarser.y + y, c) =
            stored_value(to.shape.format, static_cast<float>(mean[static_cast<std::size_t>(c)]));
    }
  }
}

}  // namespace

int mip_level_count(int width, int height) {
  int count = 1;
  while ((std::max(width, height) >> count) > 0) ++count;
  return count;
}

Image coarser_levels(const Image& image) {
  const int count = mip_level_count(image.width(), image.height());
  int stacked = 0;
  for (int level = 2; level < count; ++level) stacked += halved(image.height(), level);
  const int beside = count > 2 ? halved(image.width(), 2) : 0;
  Image levels(image.shape.format, halved(image.width(), 1) + beside,
               std::max(halved(image.height(), 1), stacked));
  Area finer{0, 0, image.width(), image.height()};
  for (int level = 1; level < count; ++level) {
    Area coarser{0, 0, halved(image.width(), level), halved(image.height(), level)};
    if (level > 1) coarser.x = halved(image.width(), 1);
    if (level > 2) coarser.y = finer.y + finer.height;
    fill_level(level > 1 ? levels : image, finer, levels, coarser);
    finer = coarser;
  }
  return levels;
}

bool has_mip_map(const Material& material) {
  return std::any_of(kSeenByCamera.begin(), kSeenByCamera.end(),
                     [&](TextureUse Material::*use) { return (material.*use).levels > 1; });
}

void add_mip_levels(Scene& scene) {
  scene.coarser.resize(scene.images.size());
  for (Material& material : scene.materials) {
    if (material.transmission >= 0.99f) continue;
    for (TextureUse Material::*use : kSeenByCamera) {
      TextureUse& texture = material.*use;
      if (!texture.present()) continue;
      const auto index = static_cast<std::size_t>(texture.image);
      const Image& image = scene.images[index];
      texture.levels = mip_level_count(image.width(), image.height());
      if (texture.levels > 1 && scene.coarser[index].values.empty())
        scene.coarser[index] = coarser_levels(image);
    }
  }
}

}  // namespace caustics
