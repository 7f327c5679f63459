// --dump: every attachment of every pass as an EXR file, the tables that passes read, and a manifest that
// says what each pass was fed with.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "app/output/dump_pictures.hpp"

namespace caustics::app {

// A label as part of a file's name: whatever is not a plain letter or digit becomes '_'.
std::string file_part(const std::string& label);

// That the manifest takes for each pass until it is written, in bytes.
inline constexpr std::size_t kBytesOfDumpedPass = 12000;

class Dump {
 public:
  // See DumpFolder. `pictures`: to look at, too.
  Dump(const std::filesystem::path& folder, bool pictures);
  Dump(const Dump&) = delete;
  Dump& operator=(const Dump&) = delete;
  ~Dump();
  // Called right after the pass, because later passes may add to the same textures.
  void add(const RenderedFrame& frame, const PlannedPass& pass);
  void finish();

 private:
  void add_attachment(const PlannedPass& pass, const Attachment& attachment);
  // The file that holds a texture as it is now.
  nlohmann::ordered_json file_of(const RenderedFrame& frame, int texture);
  nlohmann::ordered_json material_file(const RenderedFrame& frame, TextureId texture);
  std::string table_file(const RenderedFrame& frame, TextureId texture, const std::string& name);

  DumpFolder folder_;
  std::unique_ptr<nlohmann::ordered_json> manifest_;
  std::map<int, std::string> latest_;          // of each texture of the plan: the file written last
  std::map<std::string, std::string> tables_;  // file, by name
  std::optional<DumpPictures> pictures_;
};

}  // namespace caustics::app
