// --dump of `caustics parity`: both images of every attachment that differs, and where they differ.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "pipeline/renderer/parity.hpp"

namespace caustics::app {

class ParityDump {
 public:
  // Makes the folder; throws Error (CannotWrite).
  explicit ParityDump(const std::filesystem::path& folder);
  // Writes NN_<pass>.<attachment>.software.exr, .gl.exr and .mask.exr (1 where a texel differs, else 0) if
  // any texel differs.
  void add(const AttachmentParity& parity, const Image& reference, const Image& tested);
  // Writes manifest.json, the report, last: a folder with one is complete.
  void finish(const nlohmann::ordered_json& report);

 private:
  std::filesystem::path folder_;
  int count_ = 0;
};

}  // namespace caustics::app
