#include "app/output/fine_picture.hpp"

#include <algorithm>

#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/owned.hpp"

namespace caustics::app {

namespace {

const PlannedPass& pass_that_draws_the_picture(const RenderedFrame& frame) {
  const auto& passes = frame.plan().passes;
  const auto found = std::find_if(passes.begin(), passes.end(), [](const PlannedPass& pass) {
    const auto& writes = pass.definition->writes;
    return std::any_of(writes.begin(), writes.end(),
                       [](const ColorWrite& write) { return write.name == "picture"; });
  });
  if (found == passes.end()) throw Error(ExitCode::InternalError, "no pass draws the picture");
  return *found;
}

}  // namespace

Image fine_picture(const RenderedFrame& frame) {
  const PlannedPass& pass = pass_that_draws_the_picture(frame);
  PassDefinition definition = *pass.definition;
  for (ColorWrite& write : definition.writes) write.format = Format::RGBA32F;
  Device& device = frame.device();
  const OwnedTexture target(device, device.create_texture(Format::RGBA32F, pass.width, pass.height));
  PassRun run = frame.prepare(pass);
  run.definition = &definition;
  run.colors = {target.id()};
  device.run(run);
  return device.read_back(target.id());
}

}  // namespace caustics::app
