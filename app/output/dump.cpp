#include "app/output/dump.hpp"

#include "app/json.hpp"
#include "app/output/attachments.hpp"
#include "app/output/image_file.hpp"
#include "app/output/stats.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/parser.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

std::string file_part(const std::string& label) {
  std::string part = label.substr(0, 80);
  for (char& c : part) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!plain && c != '-') c = '_';
  }
  while (!part.empty() && part.back() == '_') part.pop_back();
  return part;
}

void make_dump_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw Error(ExitCode::CannotWrite, folder.string() + ": cannot make this folder: " +
                                           (error ? error.message() : "a file is in its place"));
  }
  require_writable(folder / "manifest.json");
  std::filesystem::remove(folder / "manifest.json", error);
}

Dump::Dump(const std::filesystem::path& folder) : folder_(folder), manifest_(std::make_unique<Json>()) {
  make_dump_folder(folder);
  (*manifest_)["attachments"] = Json::array();
}

Dump::~Dump() = default;

void Dump::add(const RenderedFrame& frame, const PlannedPass& pass) {
  for_each_attachment(frame, pass, [&](const PlannedTexture& texture, const Image& image) {
    const std::size_t number = (*manifest_)["attachments"].size();
    const std::string file = (number < 10 ? "0" : "") + std::to_string(number) + "_" + file_part(pass.label) +
                             "." + file_part(texture.name) + ".exr";
    write_exr(folder_ / file, channels_of(image));
    (*manifest_)["attachments"].push_back({{"pass", pass.label},
                                           {"attachment", texture.name},
                                           {"format", format_name(texture.format)},
                                           {"width", texture.width},
                                           {"height", texture.height},
                                           {"sha256", sha256(image)},
                                           {"file", file}});
  });
}

void Dump::finish() { write_atomically(folder_ / "manifest.json", json_text(*manifest_)); }

}  // namespace caustics::app
