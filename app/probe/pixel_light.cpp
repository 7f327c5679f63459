#include "app/probe/pixel_light.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "app/probe/before_pass.hpp"
#include "passes/registry.hpp"

namespace caustics::app {

namespace {

// Which texture of the plan a pass reads under this name; none where it has nothing there.
int read_as(const PlannedPass& pass, const std::string& name) {
  const std::vector<TextureRead>& reads = pass.definition->reads;
  for (std::size_t i = 0; i < reads.size(); ++i)
    if (reads[i].name == name) return pass.reads[i];
  return PlannedPass::kNothing;
}

double sum_of(const TexelValue& value, int channels) {
  return std::accumulate(value.begin(), value.begin() + std::min(channels, 3), 0.0);
}

// What a fragment on a texel is of a pixel's light.
struct PartOfLight {
  std::uint32_t primitive;
  int x, y;
  double light;
};

// What the primitives of the passes that draw into maps put on the texels of one light's pixel.
class Gatherer {
 public:
  Gatherer(const RenderedFrame& frame, LightOnPixel& light) : frame_(frame), light_(light) {}

  void look(const PlannedPass& pass) {
    if (pass.light != light_.light) return;
    for (std::size_t w = 0; w < pass.writes.size(); ++w) {
      TexelRectangle around{};
      if (pass.writes[w] >= 0 && find_texels(pass.writes[w], around)) take(pass, w, around);
    }
  }

  void finish() {
    double sum = 0.0, expected = 0.0, irradiance = 0.0;
    for (const Contribution& each : light_.contributions) sum += each.share;
    const auto number = static_cast<std::size_t>(light_.light);
    const glm::dvec3 intensity(
        caustic_intensity(frame_.scene().lights[number], frame_.effects().lights[number]));
    for (const auto& [texture, flux] : flux_)
      for (int c = 0; c < 3; ++c) {
        if (c < channels_) expected += flux[static_cast<std::size_t>(c)];
        irradiance += flux[static_cast<std::size_t>(c)] * intensity[c];
      }
    const double shaded = static_cast<double>(light_.caustic[0]) + static_cast<double>(light_.caustic[1]) +
                          static_cast<double>(light_.caustic[2]);
    light_.explained = shaded > 0.0 ? irradiance / shaded : 1.0;
    for (Contribution& each : light_.contributions) each.share = sum > 0.0 ? each.share / sum : 0.0;
    light_.accounted = expected > 0.0 ? sum / expected : 1.0;
    std::stable_sort(light_.contributions.begin(), light_.contributions.end(),
                     [](const Contribution& a, const Contribution& b) { return a.share > b.share; });
  }

 private:
  bool find_texels(int texture, TexelRectangle& around) const {
    int left = 1 << 30, right = -1, below = 1 << 30, top = -1;
    for (const MapTexel& texel : light_.texels) {
      if (texel.texture != texture) continue;
      left = std::min(left, texel.x);
      right = std::max(right, texel.x);
      below = std::min(below, texel.y);
      top = std::max(top, texel.y);
    }
    around = {left, below, right - left + 1, top - below + 1};
    return right >= 0;
  }

  double weight_at(int texture, int x, int y) const {
    for (const MapTexel& texel : light_.texels)
      if (texel.texture == texture && texel.x == x && texel.y == y) return texel.weight;
    return 0.0;
  }

  // A primitive's light is summed up row by row, so that the sum is that of the page of `inspect`.
  static std::map<std::uint32_t, double> sums_of(std::vector<PartOfLight>& parts) {
    std::stable_sort(parts.begin(), parts.end(), [](const PartOfLight& a, const PartOfLight& b) {
      return std::tie(a.primitive, a.y, a.x) < std::tie(b.primitive, b.y, b.x);
    });
    std::map<std::uint32_t, double> sums;
    for (const PartOfLight& part : parts) sums[part.primitive] += part.light;
    return sums;
  }

  void take(const PlannedPass& pass, std::size_t write, const TexelRectangle& around) {
    const int texture = pass.writes[write];
    const Format format = pass.definition->writes[write].format;
    const bool cells = pass_registry()[static_cast<std::size_t>(pass.pass)].draws == DrawSet::GridCells;
    const auto columns = static_cast<std::uint32_t>(frame_.grid_of(pass.light) - (cells ? 1 : 0));
    std::vector<PartOfLight> parts;
    replay_fragments(frame_.device(), frame_.prepare(pass), {}, around, [&](const FragmentOnTexel& fragment) {
      if (fragment.outcome != FragmentOutcome::Passed) return;
      const double light =
          weight_at(texture, fragment.x, fragment.y) * sum_of(fragment.given[write], channel_count(format));
      if (light != 0.0) parts.push_back({fragment.primitive, fragment.x, fragment.y, light});
    });
    for (const auto& [primitive, light] : sums_of(parts))
      light_.contributions.push_back({pass.label, cells ? "cell" : "vertex",
                                      static_cast<int>(primitive % columns),
                                      static_cast<int>(primitive / columns), light});
    // As the last pass that draws there leaves it.
    const Image map = frame_.read(texture);
    std::array<double, 3>& flux = flux_[texture] = {};
    for (const MapTexel& texel : light_.texels)
      for (int c = 0; texel.texture == texture && c < 3; ++c)
        flux[static_cast<std::size_t>(c)] +=
            texel.weight * static_cast<double>(map.at(texel.x, texel.y, std::min(c, map.channels() - 1)));
    channels_ = std::min(map.channels(), 3);
  }

  const RenderedFrame& frame_;
  LightOnPixel& light_;
  std::map<int, std::array<double, 3>> flux_;  // by texture: all its texels' flux times their weights
  int channels_ = 1;                           // of the maps
};

std::array<float, 3> color_of(const std::vector<NamedValues>& values, const std::string& name) {
  for (const NamedValues& each : values)
    if (each.name == name) return {each.values[0], each.values[1], each.values[2]};
  return {};
}

}  // namespace

bool shades_picture(const PlannedPass& pass) {
  return pass.definition->name == "light_shading" && pass.drawn_for->camera == CameraView::Picture;
}

void FetchReader::read(std::string_view label, const float* values) {
  if (label == "irradiance_of_flux") {
    per_flux_ = values[0];
  } else if (label == "irradiance") {
    if (values[0] != 0.0f || values[1] != 0.0f || values[2] != 0.0f)
      for (MapFetch& fetch : at_) {
        fetch.per_flux = per_flux_;
        found_.fetches.push_back(fetch);
      }
    if (map_ != 2) ++found_.samples;
    at_.clear();
    map_ = 0;
  } else if (label.ends_with("map_at")) {
    const std::string_view name = label.substr(0, label.size() - 3);
    const int map = static_cast<int>(std::find(std::begin(kCausticMaps), std::end(kCausticMaps), name) -
                                     std::begin(kCausticMaps));
    if (map != map_) at_.clear();  // the cascade takes the whole map's place
    map_ = map;
    at_.push_back({.map = map, .u = values[0], .v = values[1], .share = values[2]});
  }
}

PixelFetches FetchReader::take() {
  at_.clear();
  map_ = 0;
  return std::exchange(found_, {});
}

// As fetch_bilinear (pipeline/shader/functions.glsl): texels around a point, those beyond the edges clamped.
std::vector<MapTexel> map_texels(const RenderedFrame& frame, const PlannedPass& light_shading,
                                 const PixelFetches& pixel) {
  std::map<std::tuple<int, int, int>, double> by_texel;  // map, row, column
  std::array<int, std::size(kCausticMaps)> textures{};
  for (std::size_t i = 0; i < textures.size(); ++i) textures[i] = read_as(light_shading, kCausticMaps[i]);
  for (const MapFetch& fetch : pixel.fetches) {
    const int texture = textures[static_cast<std::size_t>(fetch.map)];
    if (texture < 0) continue;
    const PlannedTexture& map = frame.plan().textures[static_cast<std::size_t>(texture)];
    const double weight = static_cast<double>(fetch.share) * static_cast<double>(fetch.per_flux);
    const double x = static_cast<double>(fetch.u) * map.width - 0.5;
    const double y = static_cast<double>(fetch.v) * map.height - 0.5;
    const double left = std::floor(x), below = std::floor(y);
    for (int dy = 0; dy < 2; ++dy)
      for (int dx = 0; dx < 2; ++dx) {
        const double part =
            (dx ? x - left : 1.0 - (x - left)) * (dy ? y - below : 1.0 - (y - below)) * weight;
        if (part == 0.0) continue;
        const int column = std::clamp(static_cast<int>(left) + dx, 0, map.width - 1);
        const int row = std::clamp(static_cast<int>(below) + dy, 0, map.height - 1);
        by_texel[{fetch.map, row, column}] += part;
      }
  }
  const double samples = std::max(pixel.samples, 1);
  std::vector<MapTexel> texels;
  for (const auto& [place, weight] : by_texel) {
    const auto [map, row, column] = place;
    texels.push_back({map, textures[static_cast<std::size_t>(map)], column, row, weight / samples});
  }
  return texels;
}

std::vector<std::vector<LightOnPixel>> light_on_pixels(RenderedFrame& frame,
                                                       const std::vector<Pair>& pixels) {
  std::vector<std::vector<LightOnPixel>> lights(pixels.size());
  std::vector<Image> before;
  frame.run([&](const PlannedPass& pass, const PassResult&, std::size_t done, std::size_t total) {
    if (shades_picture(pass)) {
      const ProbedPass probe(frame, pass, std::move(before));
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const ProbedTexel pixel = probe.at(pixels[i].first, pixels[i].second);
        FetchReader reader;
        for (const NamedValues& traced : pixel.trace) reader.read(traced.name, traced.values.data());
        lights[i].push_back({.light = pass.light,
                             .direct = color_of(pixel.given, "direct"),
                             .caustic = color_of(pixel.given, "caustic"),
                             .texels = map_texels(frame, pass, reader.take()),
                             .agrees = pixel.agrees});
      }
    }
    before.clear();
    if (done < total && shades_picture(frame.plan().passes[done]))
      before = colors_before(frame, frame.plan().passes[done]);
    return true;
  });
  std::vector<Gatherer> gatherers;
  for (std::vector<LightOnPixel>& of_pixel : lights)
    for (LightOnPixel& light : of_pixel) gatherers.emplace_back(frame, light);
  frame.run([&](const PlannedPass& pass, const PassResult& result, std::size_t, std::size_t) {
    for (Gatherer& gatherer : gatherers)
      if (!result.left_out) gatherer.look(pass);
    return true;
  });
  for (Gatherer& gatherer : gatherers) gatherer.finish();
  return lights;
}

}  // namespace caustics::app
