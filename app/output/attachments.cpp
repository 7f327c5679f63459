#include "app/output/attachments.hpp"

namespace caustics::app {

void for_each_attachment(const RenderedFrame& frame, const PlannedPass& pass,
                         const std::function<void(const Attachment& attachment)>& use) {
  const auto show = [&](int index, std::string_view meaning, const std::array<float, 4>& clear) {
    if (index < 0) return;
    const Image image = frame.read(index);
    use({frame.plan().textures[static_cast<std::size_t>(index)], index, image, meaning, clear});
  };
  const PassDefinition& definition = *pass.definition;
  for (std::size_t i = 0; i < pass.writes.size(); ++i)
    show(pass.writes[i], definition.writes[i].meaning, definition.writes[i].clear);
  if (definition.depth) {
    const float clear = definition.depth->clear;
    show(pass.depth, definition.depth->meaning, {clear, clear, clear, clear});
  }
}

}  // namespace caustics::app
