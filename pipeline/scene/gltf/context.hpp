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

  // Takes `bytes` out of max_bytes and of the memory; fails when either is used up.
  void spend_bytes(std::uint64_t bytes, const std::string& where);

  // Throws Error(WrongUsage) where the scene's `what`, such as "images", take more bytes than
  // LoadOptions::memory leaves beside what the process and the file have taken. To be called before they are
  // taken.
  void need_memory(std::uint64_t bytes, const std::string& what) const;
  // The same for what stays: the next has so much less.
  void take_memory(std::uint64_t bytes, const std::string& what);

 private:
  std::filesystem::path path_;
  LoadOptions options_;
  std::vector<std::string> notes_;
  std::uint64_t bytes_left_;
  std::uint64_t memory_left_;  // bytes
};

// one_line of a text from a file, which is shortened in the middle.
std::string printable(const std::string& text, std::size_t longest = 200);

}  // namespace caustics::gltf
