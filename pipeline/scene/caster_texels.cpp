#include "pipeline/scene/caster_texels.hpp"

#include <algorithm>
#include <utility>

namespace caustics {

namespace {

using PictureAt = CasterTexels::Place;
using Pictures = std::map<int, const Image*>;  // by index into Scene::images

Image halved(const Image& image) {
  Image half(image.shape.format, std::max(1, image.width() / 2), std::max(1, image.height() / 2));
  for (int y = 0; y < half.height(); ++y)
    for (int x = 0; x < half.width(); ++x)
      for (int c = 0; c < image.channels(); ++c) {
        const int right = std::min(2 * x + 1, image.width() - 1),
                  above = std::min(2 * y + 1, image.height() - 1);
        half.at(x, y, c) = 0.25f * ((image.at(2 * x, 2 * y, c) + image.at(right, 2 * y, c)) +
                                    (image.at(2 * x, above, c) + image.at(right, above, c)));
      }
  return half;
}

// In rows from the bottom, the highest pictures first; `width`: of all. Their height.
int put_in_rows(const Pictures& images, int width, std::map<int, PictureAt>& places) {
  std::vector<int> order;
  for (const auto& [index, image] : images) order.push_back(index);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return images.at(a)->height() > images.at(b)->height(); });
  int x = 0, y = 0, row = 0;
  for (const int index : order) {
    const Image& image = *images.at(index);
    if (x + image.width() > width) {
      x = 0;
      y += row;
      row = 0;
    }
    places[index] = {x, y, image.width(), image.height()};
    x += image.width();
    row = std::max(row, image.height());
  }
  return y + row;
}

std::int64_t texels_of(const Image& image) { return std::int64_t{image.width()} * image.height(); }

// A power of two that holds the widest, and about as wide as all are high.
int width_for(const Pictures& images) {
  std::int64_t sum = 0, widest = 1;
  for (const auto& [index, image] : images) {
    sum += texels_of(*image);
    widest = std::max<std::int64_t>(widest, image->width());
  }
  std::int64_t width = 1;
  while (width < widest || width * width < sum) width *= 2;
  return static_cast<int>(width);
}

void copy_into(Image& all, const Image& image, const PictureAt& place) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 4; ++c)
        all.at(place.x + x, place.y + y, c) = stored_value(all.shape.format, image.at(x, y, c));
}

}  // namespace

CasterTexels caster_texels(const Scene& scene, const std::vector<int>& images, const std::vector<int>& coarse,
                           std::int64_t most) {
  Pictures pictures;
  std::map<int, Image> smaller;
  for (const int index : images) pictures.emplace(index, &scene.images[static_cast<std::size_t>(index)]);
  for (const int index : coarse) {
    const Image* picture = &scene.images[static_cast<std::size_t>(index)];
    if (!pictures.emplace(index, picture).second) continue;
    while (std::max(picture->width(), picture->height()) > kMostCoarseTexels) {
      Image half = halved(*picture);
      picture = pictures[index] = &(smaller[index] = std::move(half));
    }
  }
  CasterTexels texels;
  int width = width_for(pictures), height = put_in_rows(pictures, width, texels.places);
  while (std::int64_t{width} * height > most) {
    const auto largest = std::max_element(pictures.begin(), pictures.end(), [](const auto& a, const auto& b) {
      return texels_of(*a.second) < texels_of(*b.second);
    });
    if (texels_of(*largest->second) == 1) break;
    Image half = halved(*largest->second);
    largest->second = &(smaller[largest->first] = std::move(half));
    width = width_for(pictures);
    height = put_in_rows(pictures, width, texels.places);
  }
  texels.image = Image(Format::RGBA16F, width, std::max(1, height));
  for (const auto& [index, picture] : pictures) copy_into(texels.image, *picture, texels.places.at(index));
  return texels;
}

}  // namespace caustics
