#include "pipeline/scene/gltf/context.hpp"

#include <algorithm>
#include <limits>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::gltf {

namespace {
constexpr std::size_t kMostNotes = 300;

// What the budget leaves beside what the process has taken already; without a budget no limit.
std::uint64_t memory_left(const LoadOptions& options) {
  if (!options.memory) return std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t taken = resident_memory().now;
  return options.memory->bytes > taken ? options.memory->bytes - taken : 0;
}
}  // namespace

std::string printable(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return one_line(text);
  // Cut between two characters: bytes 10xxxxxx go on with one.
  const auto cut = [&](std::size_t at) {
    while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u) --at;
    return at;
  };
  const std::size_t half = longest / 2;
  return one_line(text.substr(0, cut(half))) + "..." + one_line(text.substr(cut(text.size() - half)));
}

Context::Context(const std::filesystem::path& path, const LoadOptions& options)
    : path_(path), options_(options), bytes_left_(options.max_bytes), memory_left_(memory_left(options)) {}

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
  take_memory(bytes, "bytes");
}

void Context::need_memory(std::uint64_t bytes, const std::string& what) const {
  if (bytes <= memory_left_) return;
  const auto text = [](std::uint64_t size) { return bytes_text(static_cast<double>(size)); };
  throw Error(ExitCode::WrongUsage, printable(path_.string(), 400) + ": its " + what + " need " +
                                        text(bytes) + " of memory, of which " + text(memory_left_) +
                                        " are left of the " + text(options_.memory->bytes) + " " +
                                        options_.memory->whose + "; make them smaller, or raise --memory");
}

void Context::take_memory(std::uint64_t bytes, const std::string& what) {
  need_memory(bytes, what);
  memory_left_ -= bytes;
}

}  // namespace caustics::gltf
