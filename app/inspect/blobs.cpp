#include "app/inspect/blobs.hpp"

#include <zlib.h>

#include <bit>
#include <cstring>

#include "app/json.hpp"
#include "lab/study/html.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/format.hpp"
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

std::string compressed(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), 6);
  if (status != Z_OK) throw Error(ExitCode::InternalError, "zlib cannot compress an array");
  result.resize(size);
  return result;
}

template <class T>
const std::uint8_t* bytes_of(std::span<const T> values) {
  return reinterpret_cast<const std::uint8_t*>(values.data());
}

}  // namespace

Json Blobs::add(const std::uint8_t* bytes, std::size_t count, std::size_t size, const char* type) {
  const std::string planes = planes_of(bytes, count, size);
  Sha256 digest;
  digest.add(type, std::strlen(type));
  digest.add(planes.data(), planes.size());
  const auto [known, is_new] = by_digest_.try_emplace(digest.hexadecimal(), texts_.size());
  if (is_new) {
    texts_.push_back(study::base64(compressed(planes)));
    bytes_ += texts_.back().size();
  }
  return {{"blob", known->second}, {"type", type}, {"count", count}};
}

Json Blobs::add(std::span<const std::uint8_t> values) { return add(values.data(), values.size(), 1, "u8"); }

Json Blobs::add(std::span<const std::uint16_t> values) {
  return add(bytes_of(values), values.size(), 2, "u16");
}

Json Blobs::add(std::span<const std::uint32_t> values) {
  return add(bytes_of(values), values.size(), 4, "u32");
}

Json Blobs::add_floats(std::span<const float> values) {
  return add(bytes_of(values), values.size(), 4, "f32");
}

Json Blobs::add_halves(std::span<const float> values) {
  std::vector<std::uint16_t> halves;
  halves.reserve(values.size());
  for (const float value : values) halves.push_back(half_from_float(value));
  return add(bytes_of(std::span<const std::uint16_t>(halves)), halves.size(), 2, "f16");
}

}  // namespace caustics::app
