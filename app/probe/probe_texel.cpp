#include "app/probe/probe_texel.hpp"

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
Image read(const RenderedFrame& frame, TextureId texture) {
  return texture == TextureId::None ? Image(Format::RGBA32F, 1, 1) : frame.device().read_back(texture);
}

NamedValues texel_of(const std::string& name, const Image& image, int x, int y) {
  NamedValues texel{name, {}, image.channels()};
  for (int c = 0; c < image.channels(); ++c) {
    texel.values[static_cast<std::size_t>(c)] = image.at(x, y, c);
  }
  return texel;
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

}  // namespace

ProbedPass::ProbedPass(const RenderedFrame& frame, const PlannedPass& pass, std::vector<Image> before)
    : pass_(pass), run_(frame.prepare(pass)), before_(std::move(before)) {
  for (const TextureId texture : run_.draws.front().textures) inputs_.push_back(read(frame, texture));
  for (const TextureId texture : run_.colors)
    stored_.push_back(texture == TextureId::None ? Image() : read(frame, texture));
  before_.resize(stored_.size());
}

ProbedPass::Outputs ProbedPass::shade(std::span<const Place> places, TraceSink& trace,
                                      std::array<std::int32_t, kBlock>& discarded) const {
  const ShaderInterface& interface = interface_of(*run_.definition->shader);
  Outputs outputs(run_.definition->writes.size() * 4),
      varyings(static_cast<std::size_t>(std::max(interface.varying_components(), 1)));
  std::vector<TextureView> views;
  for (const Image& image : inputs_)
    views.push_back({image.values.data(), image.width(), image.height(), image.channels()});
  std::array<float, kBlock> frag_x, frag_y;
  for (std::size_t lane = 0; lane < frag_x.size(); ++lane) {
    const Place& place = places[std::min(lane, places.size() - 1)];
    frag_x[lane] = static_cast<float>(place.x) + 0.5f;
    frag_y[lane] = static_cast<float>(place.y) + 0.5f;
  }
  std::array<std::int32_t, kBlock> front_facing, primitive_id{};
  front_facing.fill(-1);
  discarded.fill(0);
  const FragmentBlock block{
      .uniforms = run_.draws.front().uniforms.data(),
      .textures = views.data(),
      .frag_x = frag_x.data(),
      .frag_y = frag_y.data(),
      .front_facing = front_facing.data(),
      .primitive_id = primitive_id.data(),
      .varyings = reinterpret_cast<const float(*)[kBlock]>(varyings.data()),
      .outputs = reinterpret_cast<float(*)[kBlock]>(outputs.data()),
      .discarded = discarded.data(),
      .trace = &trace,
  };
  const raster::FlushDenormals as_the_device_does;
  run_.definition->shader->kernels.fragment[static_cast<std::size_t>(Lanes::Scalar)](block);
  return outputs;
}

ProbedTexel ProbedPass::at(int x, int y) const {
  const PassDefinition& definition = *pass_.definition;
  ProbedTexel probed;
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    if (inputs_[i].width() == pass_.width && inputs_[i].height() == pass_.height)
      probed.inputs.push_back(texel_of(definition.reads[i].name, inputs_[i], x, y));
  Recorder recorder;
  std::array<std::int32_t, kBlock> discarded;
  const Place place{x, y};
  const Outputs outputs = shade({&place, 1}, recorder, discarded);
  // The block is this texel all over.
  recorder.records.resize(recorder.records.size() / kBlock);
  probed.trace = std::move(recorder.records);
  probed.discarded = discarded[0] != 0;
  const raster::FlushDenormals as_the_device_does;
  for (std::size_t w = 0; w < definition.writes.size(); ++w) {
    const Image& image = stored_[w];
    if (image.values.empty()) continue;
    const NamedValues& stored = probed.stored.emplace_back(texel_of(definition.writes[w].name, image, x, y));
    NamedValues& given = probed.given.emplace_back(NamedValues{stored.name, {}, stored.count});
    const bool adds = definition.writes[w].blend == kAccumulate;
    for (std::size_t c = 0; c < static_cast<std::size_t>(stored.count); ++c) {
      given.values[c] = stored_value(image.shape.format, outputs[4 * w + c][0]);
      if (probed.discarded || (definition.writes[w].blend.enabled && (!adds || before_[w].values.empty())))
        continue;
      const float expected = adds
                                 ? stored_value(image.shape.format, before_[w].at(x, y, static_cast<int>(c)) +
                                                                        outputs[4 * w + c][0])
                                 : given.values[c];
      probed.agrees = probed.agrees && same_bits(expected, stored.values[c]);
    }
  }
  return probed;
}

}  // namespace caustics::app
