#include "app/output/attachments.hpp"

namespace caustics::app {

void for_each_attachment(const RenderedFrame& frame, const PlannedPass& pass,
                         const std::function<void(const PlannedTexture& texture, const Image& image)>& use) {
  std::vector<int> attachments = pass.writes;
  if (pass.depth >= 0) attachments.push_back(pass.depth);
  for (const int index : attachments) {
    use(frame.plan().textures[static_cast<std::size_t>(index)], frame.read(index));
  }
}

}  // namespace caustics::app
