#include "raster/texel_replay.hpp"

#include <algorithm>
#include <bitset>

#include "raster/software_device.hpp"

namespace caustics::raster {

constexpr std::size_t kTilePixels = std::size_t{kTile} * kTile;

struct ReplayTile {
  alignas(64) float color[kMaxColors][kTilePixels + kBlock][4] = {};
  alignas(64) float depth[kTilePixels + kBlock] = {};
};

// Of one primitive on one tile, what the shader gives: its fragments by pixel of the tile.
struct ShadedFragments {
  FragmentKernel shader = nullptr;
  int x = 0, y = 0;  // of the tile
  std::size_t colors = 0;
  std::bitset<kTilePixels> covered{}, discarded{};
  std::vector<std::size_t> pixels{};  // those that are covered, in the order shaded
  TexelValue given[kMaxColors][kTilePixels];

  void take(const FragmentBlock& block) {
    for (std::size_t lane = 0; lane < std::size_t{kBlock}; ++lane) {
      const std::size_t pixel = static_cast<std::size_t>(static_cast<int>(block.frag_y[lane]) - y) * kTile +
                                static_cast<std::size_t>(static_cast<int>(block.frag_x[lane]) - x);
      if (covered[pixel]) continue;  // lanes without a fragment repeat another
      covered[pixel] = true;
      discarded[pixel] = block.discarded[lane] != 0;
      pixels.push_back(pixel);
      for (std::size_t i = 0; i < colors; ++i)
        for (std::size_t c = 0; c < 4; ++c) given[i][pixel][c] = block.outputs[4 * i + c][lane];
    }
  }
};

namespace {

// A kernel is a function without a state.
thread_local ShadedFragments* taken_into = nullptr;
void shade_and_take(const FragmentBlock& block) {
  taken_into->shader(block);
  taken_into->take(block);
}

TileJob replay_job(const FragmentWork& work, const TexelRectangle& where, const PrimitiveChunk& chunk,
                   ReplayTile& storage) {
  const PassDefinition& definition = *work.definition;
  TileJob job = job_of(work);
  job.x = where.x;
  job.y = where.y;
  job.width = where.width;
  job.height = where.height;
  job.color_count = static_cast<int>(definition.writes.size());
  for (std::size_t i = 0; i < definition.writes.size(); ++i) {
    const ColorWrite& write = definition.writes[i];
    job.colors[i] = {storage.color[i], nullptr, write.format, write.blend, {}};
    std::copy(write.mask.begin(), write.mask.end(), job.colors[i].mask);
  }
  job.depth = definition.depth ? storage.depth : nullptr;
  job.chunks = &chunk;
  job.chunk_count = 1;
  job.load_colors = [](void*) {};
  return job;
}

// As an attachment holds it: channels that the format lacks are 0, 0, 0, 1.
TexelValue value_in(Format format, const float* texel) {
  TexelValue value{0.0f, 0.0f, 0.0f, 1.0f};
  for (int c = 0; c < channel_count(format); ++c)
    value[static_cast<std::size_t>(c)] = stored_value(format, texel[c]);
  return value;
}

bool gives_nothing(const FragmentOnTexel& fragment, const std::vector<ColorWrite>& writes) {
  for (std::size_t i = 0; i < writes.size(); ++i)
    for (int c = 0; c < channel_count(writes[i].format); ++c)
      if (fragment.given[i][static_cast<std::size_t>(c)] != 0.0f) return false;
  return true;
}

}  // namespace

class TexelReplay::Texels {
 public:
  Texels(const PassDefinition& definition, const TargetsBefore& before, const TexelRectangle& where)
      : where_(where), colors_(definition.writes.size()) {
    for (std::size_t i = 0; i < colors_.size(); ++i) {
      const Image* kept =
          i < before.colors.size() && !before.colors[i].values.empty() ? &before.colors[i] : nullptr;
      for (int y = where.y; y < where.y + where.height; ++y)
        for (int x = where.x; x < where.x + where.width; ++x)
          colors_[i].push_back(value_before(definition.writes[i], kept, x, y));
    }
    if (!definition.depth) return;
    for (int y = where.y; y < where.y + where.height; ++y)
      for (int x = where.x; x < where.x + where.width; ++x)
        depth_.push_back(before.depth.values.empty() ? definition.depth->clear : before.depth.at(x, y, 0));
  }

  // One primitive on the part of the rectangle that lies in one tile. `fragment` has its numbers.
  void draw(const FragmentWork& work, const PrimitiveChunk& chunk, const TexelRectangle& part,
            FragmentOnTexel& fragment, const FragmentVisitor& visit) {
    shade(work, chunk, part);
    for (const std::size_t pixel : shaded_.pixels) {
      fragment.x = part.x + static_cast<int>(pixel % kTile);
      fragment.y = part.y + static_cast<int>(pixel / kTile);
      for (std::size_t i = 0; i < colors_.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
          fragment.given[i][c] = stored_value(work.definition->writes[i].format, shaded_.given[i][pixel][c]);
      if (work.definition->zero_outside_quad && gives_nothing(fragment, work.definition->writes)) continue;
      fragment.depth = depth_.empty() ? 0.0f : tile_.depth[pixel];
      merge(work, chunk, fragment);
      if (shaded_.discarded[pixel]) fragment.outcome = FragmentOutcome::Discarded;
      visit(fragment);
    }
  }

 private:
  // All that it covers, whatever is before it: without a depth test.
  void shade(const FragmentWork& work, const PrimitiveChunk& chunk, const TexelRectangle& part) {
    for (const std::size_t pixel : shaded_.pixels) shaded_.covered[pixel] = false;
    shaded_.pixels.clear();
    shaded_.shader = work.fragment;
    shaded_.x = part.x;
    shaded_.y = part.y;
    shaded_.colors = colors_.size();
    TileJob job = replay_job(work, part, chunk, tile_);
    job.fragment = shade_and_take;
    job.depth_state = {Compare::Always, true};
    job.test_depth_late = false;
    taken_into = &shaded_;
    TileCounters counters;
    work.kernel(job, counters);
  }

  // Onto its texel, by the tests and blending of the pass.
  void merge(const FragmentWork& work, const PrimitiveChunk& chunk, FragmentOnTexel& fragment) {
    const std::size_t at = place(fragment.x, fragment.y);
    for (std::size_t i = 0; i < colors_.size(); ++i) {
      fragment.before[i] = colors_[i][at];
      std::copy(colors_[i][at].begin(), colors_[i][at].end(), pixel_.color[i][0]);
    }
    fragment.depth_before = pixel_.depth[0] = depth_.empty() ? 0.0f : depth_[at];
    TileCounters counters;
    work.kernel(replay_job(work, {fragment.x, fragment.y, 1, 1}, chunk, pixel_), counters);
    fragment.outcome = counters.samples_passed > 0 ? FragmentOutcome::Passed : FragmentOutcome::Behind;
    for (std::size_t i = 0; i < colors_.size(); ++i)
      fragment.after[i] = colors_[i][at] = value_in(work.definition->writes[i].format, pixel_.color[i][0]);
    if (!depth_.empty()) depth_[at] = pixel_.depth[0];
  }

  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y - where_.y) * static_cast<std::size_t>(where_.width) +
           static_cast<std::size_t>(x - where_.x);
  }

  TexelRectangle where_;
  std::vector<std::vector<TexelValue>> colors_;  // by attachment and texel
  std::vector<float> depth_;
  ShadedFragments shaded_;
  ReplayTile tile_, pixel_;
};

TexelReplay::TexelReplay(const PassDefinition& definition, const TargetsBefore& before,
                         const ImageShape& size, const TexelRectangle& where, const Workers& workers)
    : texels_(std::make_unique<Texels>(definition, before, where)),
      where_(where),
      grid_(size.width, size.height),
      workers_(workers) {}

TexelReplay::~TexelReplay() = default;

TexelRectangle TexelReplay::part_in(int tile) const {
  const int x = tile % grid_.columns * kTile, y = tile / grid_.columns * kTile;
  TexelRectangle part{std::max(where_.x, x), std::max(where_.y, y)};
  part.width = std::min(where_.x + where_.width, x + kTile) - part.x;
  part.height = std::min(where_.y + where_.height, y + kTile) - part.y;
  return part;
}

void TexelReplay::draw(std::size_t number, const PreparedDraw& prepared, ShadedVertices& shaded,
                       const FragmentVisitor& visit) {
  const std::size_t colors = prepared.work.definition->writes.size();
  FragmentOnTexel fragment{.draw = number};
  fragment.given.resize(colors);
  fragment.before.resize(colors);
  fragment.after.resize(colors);
  const FlushDenormals as_workers_do;
  std::vector<BinnedChunk> chunks;
  for (std::size_t first = 0; first < prepared.primitives; first += kPrimitivesPerBatch) {
    const std::size_t count = std::min(kPrimitivesPerBatch, prepared.primitives - first);
    prepared.shade(first, count, workers_, shaded);
    bin_primitives(prepared.primitive_stage, first, count, grid_, workers_, chunks);
    for (int tile = 0; tile < grid_.count(); ++tile) {
      const TexelRectangle part = part_in(tile);
      if (part.width < 1 || part.height < 1) continue;
      for (const BinnedChunk& chunk : chunks) {
        const auto at = static_cast<std::size_t>(tile);
        for (std::uint32_t i = chunk.first[at]; i < chunk.first[at + 1]; ++i) {
          const std::uint32_t record = chunk.touching[i];
          fragment.primitive = static_cast<std::uint32_t>(
              chunk.triangles.empty() ? chunk.points[record].primitive : chunk.triangles[record].primitive);
          texels_->draw(prepared.work, {chunk.triangles.data(), chunk.points.data(), &chunk.touching[i], 1},
                        part, fragment, visit);
        }
      }
    }
  }
}

}  // namespace caustics::raster

namespace caustics {

std::string_view name_of(FragmentOutcome outcome) {
  switch (outcome) {
    case FragmentOutcome::Passed:
      return "passed";
    case FragmentOutcome::Discarded:
      return "discarded";
    case FragmentOutcome::Behind:
      return "behind";
  }
  return "";
}

TexelValue value_before(const ColorWrite& write, const Image* kept, int x, int y) {
  const int channels = channel_count(write.format);
  TexelValue value{};
  for (int c = 0; c < 4; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    if (c >= channels)
      value[channel] = c == 3 ? 1.0f : 0.0f;
    else
      value[channel] = kept ? kept->at(x, y, c) : stored_value(write.format, write.clear[channel]);
  }
  return value;
}

}  // namespace caustics
