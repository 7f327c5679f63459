// Numbers in a page: compressed, as text that a script of the page reads without fetching anything.
#pragma once
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

namespace caustics::app {

// Each array becomes the base64 of a zlib stream of its words, bit by bit what they were. Words of several
// bytes lie in it as planes, all lowest bytes first, then all second ones, little endian: neighbours are
// alike then. Where that is shorter, the words are channel after channel, each less the one before it
// (blobs.js reads them): { "channels", "beside" }. What two runs have alike is there once.
class Blobs {
 public:
  // What the recording says of an array: { "blob", "type", "count" }, and how it is coded. `channels`: of a
  // texel, one of which follows the other.
  nlohmann::ordered_json add(std::span<const std::uint8_t> values);
  nlohmann::ordered_json add(std::span<const std::uint16_t> values);
  nlohmann::ordered_json add(std::span<const std::uint32_t> values);
  nlohmann::ordered_json add_floats(std::span<const float> values, int channels = 1);

  const std::vector<std::string>& texts() const { return texts_; }
  std::size_t bytes() const { return bytes_; }  // of all texts

 private:
  nlohmann::ordered_json add_words(std::span<const std::uint32_t> words, int channels, const char* type);
  nlohmann::ordered_json add(const std::string& planes, std::size_t count, const char* type,
                             const nlohmann::ordered_json& coding);
  std::vector<std::string> texts_;
  std::map<std::string, std::size_t> by_digest_;  // of type, coding and bytes: index of the text
  std::size_t bytes_ = 0;
};

}  // namespace caustics::app
