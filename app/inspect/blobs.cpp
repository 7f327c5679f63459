#include "app/inspect/blobs.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "app/json.hpp"
#include "lab/study/html.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/sha256.hpp"

namespace caustics::app {

namespace {

static_assert(std::endian::native == std::endian::little);

std::string planes_of(const std::uint8_t* bytes, std::size_t count, std::size_t size) {
  std::string planes(count * size, '\0');
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < size; ++k) planes[k * count + i] = static_cast<char>(bytes[i * size + k]);
  return planes;
}

std::string planes_of(std::span<const std::uint32_t> words) {
  return planes_of(reinterpret_cast<const std::uint8_t*>(words.data()), words.size(), 4);
}

std::string compressed(const std::string& bytes, int level) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), level);
  if (status != Z_OK) throw Error(ExitCode::InternalError, "zlib cannot compress an array");
  result.resize(size);
  return result;
}

// How words are put before they are packed.
struct Coding {
  bool differences = false;  // else as they are
  bool beside = false;       // the second and third channel less the first, too
};
constexpr Coding kCodings[] = {{}, {true, false}, {true, true}};

// A difference of either sign as a small number.
std::uint32_t folded(std::uint32_t difference) {
  return (difference << 1) ^ (std::uint32_t{0} - (difference >> 31));
}

// Channel after channel, each word less the one of the texel before it.
std::vector<std::uint32_t> differences(std::span<const std::uint32_t> words, std::size_t channels,
                                       bool beside) {
  std::vector<std::uint32_t> coded;
  coded.reserve(words.size());
  const auto step = [&](std::size_t i, std::size_t c) {
    return words[i + c] - (i == 0 ? 0 : words[i + c - channels]);
  };
  for (std::size_t c = 0; c < channels; ++c) {
    const bool less_the_first = beside && (c == 1 || c == 2);
    for (std::size_t i = 0; i < words.size(); i += channels)
      coded.push_back(folded(step(i, c) - (less_the_first ? step(i, 0) : 0)));
  }
  return coded;
}

std::string planes_of(std::span<const std::uint32_t> words, std::size_t channels, const Coding& coding) {
  return coding.differences ? planes_of(differences(words, channels, coding.beside)) : planes_of(words);
}

// The one that packs a part from the middle best.
Coding best_coding(std::span<const std::uint32_t> words, std::size_t channels) {
  const std::size_t texels = words.size() / channels, tried = std::min<std::size_t>(texels, 1 << 15);
  const auto part = words.subspan((texels - tried) / 2 * channels, tried * channels);
  Coding best;
  std::size_t least = std::string::npos;
  for (const Coding& coding : kCodings) {
    if (coding.beside && channels < 3) continue;
    const std::size_t size = compressed(planes_of(part, channels, coding), 1).size();
    if (size < least) best = coding, least = size;
  }
  return best;
}

}  // namespace

Json Blobs::add(const std::string& planes, std::size_t count, const char* type, const Json& coding) {
  Sha256 digest;
  const std::string kind = type + coding.dump();
  digest.add(kind.data(), kind.size());
  digest.add(planes.data(), planes.size());
  const auto [known, is_new] = by_digest_.try_emplace(digest.hexadecimal(), texts_.size());
  if (is_new) {
    texts_.push_back(study::base64(compressed(planes, 6)));
    bytes_ += texts_.back().size();
  }
  Json array = {{"blob", known->second}, {"type", type}, {"count", count}};
  array.update(coding);
  return array;
}

Json Blobs::add_words(std::span<const std::uint32_t> words, int channels, const char* type) {
  const auto each = static_cast<std::size_t>(channels);
  const Coding coding = best_coding(words, each);
  Json said = Json::object();
  if (coding.differences) said = {{"channels", channels}, {"beside", coding.beside}};
  return add(planes_of(words, each, coding), words.size(), type, said);
}

Json Blobs::add(std::span<const std::uint8_t> values) {
  return add(planes_of(values.data(), values.size(), 1), values.size(), "u8", Json::object());
}

Json Blobs::add(std::span<const std::uint16_t> values) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(values.data());
  return add(planes_of(bytes, values.size(), 2), values.size(), "u16", Json::object());
}

Json Blobs::add(std::span<const std::uint32_t> values) { return add_words(values, 1, "u32"); }

Json Blobs::add_floats(std::span<const float> values, int channels) {
  std::vector<std::uint32_t> words(values.size());
  if (!values.empty()) std::memcpy(words.data(), values.data(), values.size_bytes());
  return add_words(words, channels, "f32");
}

}  // namespace caustics::app
