#include "lab/study/fingerprint.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/sha256.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::study {

using Json = nlohmann::ordered_json;

namespace {

// The uris of buffers and images that are files beside the scene.
std::vector<std::string> named_files(const std::filesystem::path& scene) {
  std::ifstream in(scene);
  const Json document = Json::parse(in, nullptr, false);
  std::vector<std::string> files;
  if (!document.is_object()) return files;
  for (const char* list : {"buffers", "images"}) {
    if (!document.contains(list) || !document[list].is_array()) continue;
    for (const Json& each : document[list]) {
      if (!each.is_object() || !each.contains("uri") || !each["uri"].is_string()) continue;
      const std::string uri = each["uri"];
      if (uri.rfind("data:", 0) != 0) files.push_back(uri);
    }
  }
  return files;
}

}  // namespace

Json fingerprint(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  const std::string why = std::filesystem::exists(path, error) ? "cannot be read" : "no such file";
  if (!in) throw Error(ExitCode::BadInput, one_line(path.string()) + ": " + why);
  Sha256 hash;
  std::uint64_t bytes = 0;
  std::vector<char> block(std::size_t{1} << 20);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    hash.add(block.data(), static_cast<std::size_t>(in.gcount()));
    bytes += static_cast<std::uint64_t>(in.gcount());
  }
  return {{"path", path.string()}, {"bytes", bytes}, {"sha256", hash.hexadecimal()}};
}

Json scene_fingerprint(const std::filesystem::path& path) {
  Json result = fingerprint(path);
  if (path.extension() == ".glb") return result;
  for (const std::string& file : named_files(path)) {
    // What cannot be found as it is written (escaped uris) is the loader's business.
    std::error_code error;
    const std::filesystem::path beside = path.parent_path() / file;
    if (std::filesystem::is_regular_file(beside, error)) result["files"].push_back(fingerprint(beside));
  }
  return result;
}

}  // namespace caustics::study
