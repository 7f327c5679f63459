#include "pipeline/renderer/run_pass.hpp"

#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/owned.hpp"

namespace caustics {

PassDefinition definition_with(const Pass& pass, Effect Effects::*effect, const DrawnFor& drawn_for) {
  Effects effects;
  (effects.*effect).active = true;
  return definition_of(pass, effects, drawn_for);
}

PassImages run_pass(Device& device, const PassDefinition& definition, const PassInputs& inputs) {
  std::vector<OwnedTexture> owned;
  const auto own = [&](TextureId texture) {
    owned.emplace_back(device, texture);
    return texture;
  };
  PassRun run{.definition = &definition};
  for (const ColorWrite& write : definition.writes)
    run.colors.push_back(own(device.create_texture(write.format, inputs.width, inputs.height)));
  if (definition.depth) run.depth = own(device.create_texture(Format::Depth32F, inputs.width, inputs.height));
  Draw draw{.vertex_count = inputs.vertex_count, .uniforms = inputs.uniforms};
  OwnedMesh mesh;
  if (!inputs.mesh.vertices.empty()) {
    mesh = OwnedMesh(device, device.create_mesh(inputs.mesh));
    draw.mesh = mesh.id();
    draw.vertex_count = 0;
  }
  for (const Image& image : inputs.textures)
    draw.textures.push_back(image.values.empty() ? TextureId::None : own(device.upload(image)));
  // What the frame lacks.
  if (draw.textures.size() < definition.reads.size())
    draw.textures.resize(definition.reads.size(), TextureId::None);
  run.draws.push_back(draw);
  PassImages out;
  out.result = device.run(run);
  for (std::size_t i = 0; i < run.colors.size(); ++i)
    out.images[definition.writes[i].name] = device.read_back(run.colors[i]);
  if (definition.depth) out.images[definition.depth->name] = device.read_back(run.depth);
  return out;
}

}  // namespace caustics
