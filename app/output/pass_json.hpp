// A pass in a dump's manifest: what another program needs to run its own pass with the same inputs.
#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/frame.hpp"

namespace caustics::app {

// Where a dump has what a pass is fed with. Each may return null: nothing is bound, which reads as one texel
// of zeros.
struct DumpedFiles {
  // Of a texture of the plan, as it is before the pass.
  std::function<nlohmann::ordered_json(int texture)> of_texture;
  // Of a texture of the drawn surface's material.
  std::function<nlohmann::ordered_json(TextureId texture)> of_material;
};

// Names, state, what is read and written, the uniforms' types and offsets, and each draw with their values.
nlohmann::ordered_json pass_json(const RenderedFrame& frame, const PlannedPass& pass,
                                 const DumpedFiles& files);

}  // namespace caustics::app
