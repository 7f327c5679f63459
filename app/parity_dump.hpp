// --dump of `caustics parity`: both images of every attachment that differs, and where they differ.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "app/output/dump_folder.hpp"
#include "pipeline/renderer/parity.hpp"

namespace caustics::app {

class ParityDump {
 public:
  // See DumpFolder.
  explicit ParityDump(const std::filesystem::path& folder) : folder_(folder, false) {}
  // Writes NN_<pass>.<attachment>.software.exr, .gl.exr and .mask.exr (1 where a texel differs, else 0) if
  // any texel differs.
  void add(const AttachmentParity& parity, const Image& reference, const Image& tested);
  // The report is the manifest.
  void finish(const nlohmann::ordered_json& report);

 private:
  DumpFolder folder_;
  int count_ = 0;
};

}  // namespace caustics::app
