#include "app/output/dump.hpp"

#include "app/json.hpp"
#include "app/output/attachment_kind.hpp"
#include "app/output/image_file.hpp"
#include "app/output/pass_json.hpp"
#include "app/output/stats.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/parser.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

Json image_json(Format format, const Image& image, const std::string& file) {
  return {{"format", format_name(format)},
          {"width", image.width()},
          {"height", image.height()},
          {"sha256", sha256(image)},
          {"file", file}};
}

}  // namespace

std::string file_part(const std::string& label) {
  std::string part = label.substr(0, 80);
  for (char& c : part) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!plain && c != '-') c = '_';
  }
  while (!part.empty() && part.back() == '_') part.pop_back();
  return part;
}

Dump::Dump(const std::filesystem::path& folder, bool pictures)
    : folder_(folder, pictures), manifest_(std::make_unique<Json>()) {
  if (pictures) pictures_.emplace(folder_);
  for (const char* list : {"attachments", "tables", "passes"}) (*manifest_)[list] = Json::array();
}

Dump::~Dump() = default;

void Dump::add(const RenderedFrame& frame, const PlannedPass& pass) {
  const glm::dvec3& origin = frame.scene().origin;
  (*manifest_)["scene_origin"] = {origin.x, origin.y, origin.z};
  // Before its attachments: what it has read may be written by it too.
  (*manifest_)["passes"].push_back(
      pass_json(frame, pass,
                {.of_texture = [&](int texture) { return file_of(frame, texture); },
                 .of_material = [&](TextureId texture) { return material_file(frame, texture); }}));
  for_each_attachment(frame, pass, [&](const Attachment& attachment) { add_attachment(pass, attachment); });
}

void Dump::add_attachment(const PlannedPass& pass, const Attachment& attachment) {
  const std::size_t number = (*manifest_)["attachments"].size();
  const PlannedTexture& texture = attachment.texture;
  const std::string stem = (number < 10 ? "0" : "") + std::to_string(number) + "_" + file_part(pass.label) +
                           "." + file_part(texture.name);
  write_exr(folder_.file(stem + ".exr"), channels_of(attachment.image));
  Json json = image_json(texture.format, attachment.image, stem + ".exr");
  json["kind"] = name_of(kind_of(texture.format, attachment.meaning));
  json["meaning"] = attachment.meaning;
  if (pictures_) json["pictures"] = pictures_->add(pass.label, attachment, stem);
  Json named = {{"pass", pass.label}, {"attachment", texture.name}};
  named.update(json);
  (*manifest_)["attachments"].push_back(named);
  latest_[attachment.index] = stem + ".exr";
}

Json Dump::file_of(const RenderedFrame& frame, int texture) {
  const PlannedTexture& planned = frame.plan().textures[static_cast<std::size_t>(texture)];
  if (planned.external) {
    const TextureId id = frame.on_device().external(planned.name);
    return id == TextureId::None ? Json() : Json(table_file(frame, id, planned.name));
  }
  const auto found = latest_.find(texture);
  return found == latest_.end() ? Json() : Json(found->second);
}

Json Dump::material_file(const RenderedFrame& frame, TextureId texture) {
  if (texture == TextureId::None) return nullptr;
  const int images = static_cast<int>(frame.scene().images.size());
  for (int i = 0; i < images; ++i) {
    const std::string name = "material_texture[" + std::to_string(i) + "]";
    if (frame.on_device().image(i) == texture) return table_file(frame, texture, name);
    if (frame.on_device().coarser(i) == texture) return table_file(frame, texture, name + ".levels");
  }
  return nullptr;
}

std::string Dump::table_file(const RenderedFrame& frame, TextureId texture, const std::string& name) {
  const auto found = tables_.find(name);
  if (found != tables_.end()) return found->second;
  const std::string file = "table_" + file_part(name) + ".exr";
  const Image image = frame.device().read_back(texture);
  write_exr(folder_.file(file), channels_of(image));
  Json json = {{"name", name}};
  json.update(image_json(image.shape.format, image, file));
  (*manifest_)["tables"].push_back(json);
  return tables_[name] = file;
}

void Dump::finish() {
  if (pictures_) pictures_->finish();
  folder_.finish(*manifest_);
}

}  // namespace caustics::app
