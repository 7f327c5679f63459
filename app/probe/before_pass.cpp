#include "app/probe/before_pass.hpp"

#include "pipeline/gpu/device.hpp"

namespace caustics::app {

TargetsBefore targets_before(const RenderedFrame& frame, const PlannedPass& pass) {
  const PassRun run = frame.prepare(pass);
  TargetsBefore before;
  before.colors.resize(run.colors.size());
  for (std::size_t i = 0; i < run.colors.size(); ++i)
    if (!run.keep.empty() && run.keep[i] && run.colors[i] != TextureId::None)
      before.colors[i] = frame.device().read_back(run.colors[i]);
  if (run.depth != TextureId::None && !run.keep.empty() && run.keep.back())
    before.depth = frame.device().read_back(run.depth);
  return before;
}

std::vector<Image> colors_before(const RenderedFrame& frame, const PlannedPass& pass) {
  std::vector<Image> colors = targets_before(frame, pass).colors;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (!colors[i].values.empty()) continue;
    const ColorWrite& write = pass.definition->writes[i];
    colors[i] = Image(write.format, pass.width, pass.height);
    const auto channels = static_cast<std::size_t>(colors[i].channels());
    for (std::size_t v = 0; v < colors[i].values.size(); ++v)
      colors[i].values[v] = stored_value(write.format, write.clear[v % channels]);
  }
  return colors;
}

const Mesh* mesh_of(const RenderedFrame& frame, const Draw& draw) {
  if (draw.mesh == MeshId::None) return nullptr;
  const Scene& scene = frame.scene();
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (frame.on_device().mesh(static_cast<int>(i)) == draw.mesh) return &scene.meshes[i];
  return nullptr;
}

}  // namespace caustics::app
