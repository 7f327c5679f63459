#include "pipeline/scene/gltf/context.hpp"

#include <algorithm>

#include "pipeline/gpu/error.hpp"

namespace caustics::gltf {

namespace {
constexpr std::size_t kMostNotes = 300;
}

std::string printable(const std::string& text, std::size_t longest) {
  std::string line = text;
  if (line.size() > longest) {
    const std::size_t half = longest / 2;
    line = line.substr(0, half) + "..." + line.substr(line.size() - half);
  }
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return line;
}

Context::Context(const std::filesystem::path& path, const LoadOptions& options)
    : path_(path), options_(options), bytes_left_(options.max_bytes) {}

void Context::fail(const std::string& where, const std::string& what, const std::string& advice) const {
  std::string line = printable(path_.string(), 400) + ": ";
  if (!where.empty()) line += printable(where) + ": ";
  line += printable(what, 500);
  if (!advice.empty()) line += "; " + printable(advice, 500);
  throw Error(ExitCode::BadInput, line);
}

void Context::note(const std::string& sentence) {
  const std::string line = printable(sentence, 500);
  if (notes_.size() > kMostNotes) return;
  if (std::find(notes_.begin(), notes_.end(), line) != notes_.end()) return;
  notes_.push_back(notes_.size() < kMostNotes ? line : "Further notes are left out.");
}

void Context::spend_bytes(std::uint64_t bytes, const std::string& where) {
  if (bytes > bytes_left_) {
    fail(where,
         "the file and what it refers to hold more than " + std::to_string(options_.max_bytes) + " bytes",
         "split the scene or shrink its textures");
  }
  bytes_left_ -= bytes;
}

}  // namespace caustics::gltf
