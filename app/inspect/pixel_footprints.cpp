#include "app/inspect/pixel_footprints.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/probe/probe_texel.hpp"

namespace caustics::app {

namespace {

// Texels around all fetches that an irradiance above 0 came from.
class FootprintSink final : public TraceSink {
 public:
  FootprintSink(PixelFootprints& footprints, const std::array<ImageShape, 3>& maps)
      : footprints_(footprints), maps_(maps) {}

  void record(const char* label, const float* values, int) override {
    const std::string_view name = label;
    if (name == "pixel") {
      pixel_ = static_cast<std::size_t>(values[1]) * static_cast<std::size_t>(footprints_.width) +
               static_cast<std::size_t>(values[0]);
      fetched_ = 0;
    } else if (name == "irradiance") {
      if (values[0] != 0.0f || values[1] != 0.0f || values[2] != 0.0f) take();
      fetched_ = 0;
    } else if (name.ends_with("map_at")) {
      const auto map = static_cast<std::uint8_t>(name.starts_with("cascade") ? 1
                                                 : name.starts_with("far")   ? 2
                                                                             : 0);
      if (map != map_) fetched_ = 0;  // the cascade takes the whole map's place
      map_ = map;
      if (fetched_ < at_.size()) at_[fetched_++] = {values[0], values[1]};
    }
  }

 private:
  void take() {
    // Of a pixel that reads two maps the first one counts.
    std::uint8_t& map = footprints_.map[pixel_];
    float* const r = footprints_.rectangle.data() + 4 * pixel_;
    if (map != PixelFootprints::kNone && map != map_) return;
    const auto width = static_cast<float>(maps_[map_].width), height = static_cast<float>(maps_[map_].height);
    for (std::size_t i = 0; i < fetched_; ++i) {
      // A bilinear fetch: half a texel to all sides.
      const float x = at_[i][0] * width, y = at_[i][1] * height;
      const bool first = map == PixelFootprints::kNone;
      r[0] = first ? x - 0.5f : std::min(r[0], x - 0.5f);
      r[1] = first ? y - 0.5f : std::min(r[1], y - 0.5f);
      r[2] = first ? x + 0.5f : std::max(r[2], x + 0.5f);
      r[3] = first ? y + 0.5f : std::max(r[3], y + 0.5f);
      map = map_;
    }
  }

  PixelFootprints& footprints_;
  std::array<ImageShape, 3> maps_;
  std::size_t pixel_ = 0, fetched_ = 0;
  std::uint8_t map_ = 0;
  std::array<std::array<float, 2>, 4> at_{};
};

ImageShape shape_of(const RenderedFrame& frame, const PlannedPass& pass, const char* name) {
  for (std::size_t i = 0; i < pass.reads.size(); ++i) {
    if (pass.definition->reads[i].name != name || pass.reads[i] < 0) continue;
    const PlannedTexture& map = frame.plan().textures[static_cast<std::size_t>(pass.reads[i])];
    return {map.format, map.width, map.height};
  }
  return {};
}

}  // namespace

PixelFootprints pixel_footprints(const RenderedFrame& frame, const PlannedPass& light_shading) {
  PixelFootprints footprints{light_shading.width, light_shading.height, {}, {}};
  const auto pixels =
      static_cast<std::size_t>(footprints.width) * static_cast<std::size_t>(footprints.height);
  footprints.map.assign(pixels, PixelFootprints::kNone);
  footprints.rectangle.assign(4 * pixels, 0.0f);
  std::array<ImageShape, 3> maps;
  for (std::size_t i = 0; i < maps.size(); ++i) maps[i] = shape_of(frame, light_shading, kFootprintMaps[i]);
  const ProbedPass pass(frame, light_shading);
  FootprintSink sink(footprints, maps);
  std::array<std::int32_t, kBlock> discarded;
  std::vector<ProbedPass::Place> row;
  for (int y = 0; y < footprints.height; ++y)
    for (int x = 0; x < footprints.width; x += kBlock) {
      row.clear();
      for (int i = x; i < std::min(x + kBlock, footprints.width); ++i) row.push_back({i, y});
      pass.shade(row, sink, discarded);
    }
  return footprints;
}

}  // namespace caustics::app
