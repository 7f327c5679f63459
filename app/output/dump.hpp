// --dump: every attachment of every pass as an EXR file, and a manifest of their hashes.
#pragma once
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "app/frame.hpp"

namespace caustics::app {

// A label as part of a file's name: whatever is not a plain letter or digit becomes '_'.
std::string file_part(const std::string& label);

// Makes the folder and takes away a manifest of an earlier run; throws Error (CannotWrite).
void make_dump_folder(const std::filesystem::path& folder);

class Dump {
 public:
  // Makes the folder; throws Error (CannotWrite).
  explicit Dump(const std::filesystem::path& folder);
  Dump(const Dump&) = delete;
  Dump& operator=(const Dump&) = delete;
  ~Dump();
  // Called right after the pass, because later passes may add to the same textures.
  void add(const RenderedFrame& frame, const PlannedPass& pass);
  // The manifest comes last, so that a folder with one is complete.
  void finish();

 private:
  std::filesystem::path folder_;
  std::unique_ptr<nlohmann::ordered_json> manifest_;
};

}  // namespace caustics::app
