#include "app/probe_texel.hpp"

#include <algorithm>
#include <bit>

#include "pipeline/gpu/device.hpp"
#include "pipeline/shader/kernel.hpp"
#include "raster/workers.hpp"

namespace caustics::app {

namespace {

struct Recorder final : TraceSink {
  std::vector<NamedValues> records;
  void record(const char* label, const float* values, int count) override {
    NamedValues named{label, {}, count};
    std::copy_n(values, count, named.values.begin());
    records.push_back(std::move(named));
  }
};

// A texture that the frame lacks is one texel of zeros.
Image input_image(const RenderedFrame& frame, TextureId texture) {
  return texture == TextureId::None ? Image(Format::RGBA32F, 1, 1) : frame.device().read_back(texture);
}

std::vector<TextureView> views_of(const std::vector<Image>& images) {
  std::vector<TextureView> views;
  views.reserve(images.size());
  for (const Image& image : images) {
    views.push_back({image.values.data(), image.width(), image.height(), image.channels()});
  }
  return views;
}

using LaneRow = std::array<float, kBlock>;

// One block whose 16 fragments are all this texel; the trace of the first is kept.
std::vector<LaneRow> run_kernel(const PassRun& run, const std::vector<TextureView>& views, int x, int y,
                                std::vector<NamedValues>& trace, bool& is_discarded) {
  const std::size_t outputs = run.definition->writes.size() * 4;
  const ShaderInterface& interface = interface_of(*run.definition->shader);
  std::vector<LaneRow> output_rows(outputs),
      varyings(static_cast<std::size_t>(std::max(interface.varying_components(), 1)));
  LaneRow frag_x, frag_y;
  frag_x.fill(static_cast<float>(x) + 0.5f);
  frag_y.fill(static_cast<float>(y) + 0.5f);
  std::array<std::int32_t, kBlock> front_facing, primitive_id{}, discarded{};
  front_facing.fill(-1);
  Recorder recorder;
  const FragmentBlock block{
      .uniforms = run.draws.front().uniforms.data(),
      .textures = views.data(),
      .frag_x = frag_x.data(),
      .frag_y = frag_y.data(),
      .front_facing = front_facing.data(),
      .primitive_id = primitive_id.data(),
      .varyings = reinterpret_cast<const float(*)[kBlock]>(varyings.data()),
      .outputs = reinterpret_cast<float(*)[kBlock]>(output_rows.data()),
      .discarded = discarded.data(),
      .trace = &recorder,
  };
  run.definition->shader->kernels.fragment[static_cast<std::size_t>(Lanes::Scalar)](block);
  recorder.records.resize(recorder.records.size() / kBlock);
  trace = std::move(recorder.records);
  is_discarded = discarded[0] != 0;
  return output_rows;
}

NamedValues texel_of(const std::string& name, const Image& image, int x, int y) {
  NamedValues texel{name, {}, image.channels()};
  for (int c = 0; c < image.channels(); ++c) {
    texel.values[static_cast<std::size_t>(c)] = image.at(x, y, c);
  }
  return texel;
}

}  // namespace

ProbedTexel probe_texel(const RenderedFrame& frame, const PlannedPass& pass, int x, int y) {
  const PassRun run = frame.prepare(pass);
  const PassDefinition& definition = *run.definition;
  ProbedTexel probed;
  std::vector<Image> images;
  for (const TextureId texture : run.draws.front().textures) {
    images.push_back(input_image(frame, texture));
    const Image& image = images.back();
    if (image.width() != pass.width || image.height() != pass.height) continue;
    probed.inputs.push_back(texel_of(definition.reads[images.size() - 1].name, image, x, y));
  }
  const raster::FlushDenormals as_the_device_does;
  const std::vector<LaneRow> outputs =
      run_kernel(run, views_of(images), x, y, probed.trace, probed.discarded);
  for (std::size_t w = 0; w < definition.writes.size(); ++w) {
    if (run.colors[w] == TextureId::None) continue;
    const Image image = frame.device().read_back(run.colors[w]);
    probed.stored.push_back(texel_of(definition.writes[w].name, image, x, y));
    if (probed.discarded || definition.writes[w].blend.enabled) continue;
    for (int c = 0; c < image.channels(); ++c) {
      const std::size_t channel = static_cast<std::size_t>(c);
      const float computed = stored_value(image.shape.format, outputs[4 * w + channel][0]);
      probed.agrees = probed.agrees && std::bit_cast<std::uint32_t>(computed) ==
                                           std::bit_cast<std::uint32_t>(probed.stored.back().values[channel]);
    }
  }
  return probed;
}

}  // namespace caustics::app
