// What every part of the glTF loader shares: the file's name, the limits, the notes, and the one
// way to refuse a file.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/scene/gltf/load_gltf.hpp"

namespace caustics::gltf {

class Context {
 public:
  Context(const std::filesystem::path& path, const LoadOptions& options);

  const LoadOptions& options() const { return options_; }
  const std::filesystem::path& path() const { return path_; }

  // Throws Error(BadInput): "file: where: what; advice" on one printable line. `where` is a JSON
  // path, empty for the file as a whole; `advice` may be empty.
  [[noreturn]] void fail(const std::string& where, const std::string& what,
                         const std::string& advice = "") const;

  // Adds a sentence for people. Equal sentences are kept once, and only the first few hundred.
  void note(const std::string& sentence);
  std::vector<std::string>& notes() { return notes_; }

  // Takes `bytes` out of the budget of max_bytes; fails when it is used up.
  void spend_bytes(std::uint64_t bytes, const std::string& where);
  std::uint64_t bytes_left() const { return bytes_left_; }

 private:
  std::filesystem::path path_;
  LoadOptions options_;
  std::vector<std::string> notes_;
  std::uint64_t bytes_left_;
};

// one_line of a text from a file, which is shortened in the middle.
std::string printable(const std::string& text, std::size_t longest = 200);

}  // namespace caustics::gltf
