#include "app/output/attachments.hpp"

namespace caustics::app {

void for_each_attachment(const RenderedFrame& frame, const PlannedPass& pass,
                         const std::function<void(const PlannedTexture& texture, const Image& image)>& use) {
  for (const int index : pass.attachments())
    use(frame.plan().textures[static_cast<std::size_t>(index)], frame.read(index));
}

}  // namespace caustics::app
