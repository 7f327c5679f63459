#include "app/inspect/pixel_table.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/probe/pixel_light.hpp"
#include "raster/workers.hpp"

namespace caustics::app {

namespace {

// The kernel hands out one pixel after the other.
class TableSink final : public TraceSink {
 public:
  explicit TableSink(PixelTable& table) : table_(table) {}

  void record(const char* label, const float* values, int) override {
    if (std::string_view(label) == "pixel") {
      close();
      pixel_ = static_cast<std::size_t>(values[1]) * static_cast<std::size_t>(table_.width) +
               static_cast<std::size_t>(values[0]);
      is_open_ = true;
    } else {
      reader_.read(label, values);
    }
  }

  // Takes what is known of the pixel. The last of a row comes several times, to fill the block.
  void close() {
    const PixelFetches found = reader_.take();
    if (!is_open_ || pixel_ < table_.samples.size()) return;
    for (const MapFetch& fetch : found.fetches) {
      table_.map.push_back(static_cast<std::uint8_t>(fetch.map));
      table_.fetches.insert(table_.fetches.end(), {fetch.u, fetch.v, fetch.share, fetch.per_flux});
    }
    table_.samples.push_back(static_cast<std::uint8_t>(found.samples));
    table_.start.push_back(static_cast<std::uint32_t>(table_.map.size()));
    is_open_ = false;
  }

 private:
  PixelTable& table_;
  FetchReader reader_;
  std::size_t pixel_ = 0;
  bool is_open_ = false;
};

// Where the pass's text writes this, and what takes it in: an attachment of this name.
struct Given {
  std::string_view name;
  std::vector<float>* values;
};

void take_given(const PassDefinition& definition, const ProbedPass::Outputs& outputs,
                const std::array<std::int32_t, kBlock>& discarded, std::size_t pixels, const Given& given) {
  for (std::size_t w = 0; w < definition.writes.size(); ++w)
    for (std::size_t lane = 0; definition.writes[w].name == given.name && lane < pixels; ++lane)
      for (std::size_t c = 0; c < 4; ++c)
        given.values->push_back(discarded[lane] != 0
                                    ? 0.0f
                                    : stored_value(definition.writes[w].format, outputs[4 * w + c][lane]));
}

}  // namespace

PixelTable pixel_table(const RenderedFrame& frame, const PlannedPass& light_shading) {
  PixelTable table{.width = light_shading.width, .height = light_shading.height, .start = {0}};
  const ProbedPass pass(frame, light_shading);
  TableSink sink(table);
  std::array<std::int32_t, kBlock> discarded;
  std::vector<ProbedPass::Place> row;
  const raster::FlushDenormals as_the_device_does;
  for (int y = 0; y < table.height; ++y)
    for (int x = 0; x < table.width; x += kBlock) {
      row.clear();
      for (int i = x; i < std::min(x + kBlock, table.width); ++i) row.push_back({i, y});
      const ProbedPass::Outputs outputs = pass.shade(row, sink, discarded);
      sink.close();
      for (const Given& given : {Given{"direct", &table.direct}, Given{"caustic", &table.caustic}})
        take_given(*light_shading.definition, outputs, discarded, row.size(), given);
    }
  return table;
}

}  // namespace caustics::app
