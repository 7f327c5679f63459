#include "tests/fuzz/mutate_gltf.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <iterator>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace caustics::fuzz {

namespace {

using Random = std::minstd_rand;

// Sizes that overflow, numbers at the edge of single precision and of the documented ranges, and sizes of
// arrays.
constexpr std::string_view kNumbers[] = {
    "0",     "1",          "2",          "3",           "4",      "5",     "-1",         "0.5",
    "1e38",  "-1e38",      "1e-38",      "1e-45",       "1e12",   "1e-12", "1e30",       "1e6",
    "1e-6",  "1000",       "0.01",       "100",         "-0.0",   "1.5",   "3.14159265", "1.57079",
    "10497", "33071",      "5120",       "5121",        "5123",   "5125",  "5126",       "255",
    "65535", "2147483647", "4294967295", "-2147483648", "1e308",  "-1e-3", "0.99",       "-1.0",
    "1e999", "64",         "2048",       "131072",      "0.2001", "1e9",   "16777217",   "1e-7"};
constexpr float kFloats[] = {0.0f,
                             -0.0f,
                             1.0f,
                             -1.0f,
                             0.5f,
                             1e38f,
                             -1e38f,
                             1e-38f,
                             1e-45f,
                             1e12f,
                             1e6f,
                             1e-6f,
                             1e-12f,
                             1e19f,
                             1e30f,
                             2.0f,
                             3.4e38f,
                             0.999999f,
                             std::numeric_limits<float>::infinity(),
                             std::numeric_limits<float>::quiet_NaN()};

struct Span {
  std::size_t at = 0, length = 0;
};

std::size_t below(Random& random, std::size_t count) { return random() % count; }

bool starts_number(char c) { return (c >= '0' && c <= '9') || c == '-'; }
bool in_number(char c) { return starts_number(c) || c == '.' || c == 'e' || c == 'E' || c == '+'; }

// The numbers of a JSON text, outside its strings.
std::vector<Span> numbers_of(std::string_view json) {
  std::vector<Span> found;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (in_string && json[i] == '\\')
      ++i;
    else if (json[i] == '"')
      in_string = !in_string;
    else if (!in_string && starts_number(json[i])) {
      const std::size_t start = i;
      while (i + 1 < json.size() && in_number(json[i + 1])) ++i;
      found.push_back({start, i + 1 - start});
    }
  }
  return found;
}

// Values and members of a JSON text: what lies between two commas or brackets of one depth.
std::vector<Span> values_of(std::string_view json) {
  std::vector<Span> found;
  std::vector<std::size_t> starts;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string && c == '\\')
      ++i;
    else if (c == '"')
      in_string = !in_string;
    if (in_string) continue;
    const bool closes = c == ']' || c == '}';
    if ((c == ',' || closes) && !starts.empty()) {
      if (i > starts.back()) found.push_back({starts.back(), i - starts.back()});
      starts.pop_back();
    }
    if (c == ',' || c == '[' || c == '{') starts.push_back(i + 1);
  }
  return found;
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  if (at + 4 <= bytes.size()) std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

void add_word(std::string& bytes, std::size_t value) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> 8 * k & 255u);
}

// libFuzzer's own mutation of a part, which also brings the dictionary's words and pieces of other inputs.
void mutate_plainly(std::string& text, std::size_t room) {
  const std::size_t size = text.size();
  text.resize(std::max(size, size + std::min<std::size_t>(room, 4096)));
  text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), size, text.size()));
}

void mutate_parts(Parts& parts, Random& random, std::size_t room) {
  const auto seed = static_cast<unsigned>(random());
  switch (below(random, 10)) {
    case 0:
    case 1:
    case 2:
    case 3:
      return change_number(parts.json, seed);
    case 4:
    case 5:
      return change_value(parts.json, seed);
    case 6:
      return mutate_plainly(parts.json, room);
    case 7:
    case 8:
      return parts.bin.empty() ? change_number(parts.json, seed) : change_word(parts.bin, seed);
    default:
      return mutate_plainly(parts.glb ? parts.bin : parts.json, room);
  }
}

}  // namespace

Parts parts_of(const std::string& bytes) {
  Parts parts;
  if (bytes.compare(0, 4, "glTF") != 0 || bytes.size() < 20) {
    parts.json = bytes;
    return parts;
  }
  parts.glb = true;
  const std::size_t json = std::min<std::size_t>(word_at(bytes, 12), bytes.size() - 20);
  parts.json = bytes.substr(20, json);
  if (const std::size_t bin = 20 + json + 8; bin < bytes.size())
    parts.bin = bytes.substr(bin, word_at(bytes, 20 + json));
  return parts;
}

std::string joined(const Parts& parts) {
  if (!parts.glb) return parts.json;
  std::string json = parts.json, bin = parts.bin, bytes = "glTF";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  bin.resize((bin.size() + 3) / 4 * 4, '\0');
  add_word(bytes, 2);
  add_word(bytes, 20 + json.size() + (bin.empty() ? 0 : 8 + bin.size()));
  add_word(bytes, json.size());
  bytes += "JSON" + json;
  if (bin.empty()) return bytes;
  add_word(bytes, bin.size());
  return bytes + std::string("BIN\0", 4) + bin;
}

void change_number(std::string& json, unsigned seed) {
  Random random(seed + 1u);
  const std::vector<Span> numbers = numbers_of(json);
  if (numbers.empty()) return;
  const Span chosen = numbers[below(random, numbers.size())];
  std::string value;
  switch (below(random, 3)) {
    case 0: {
      const Span other = numbers[below(random, numbers.size())];
      value = json.substr(other.at, other.length);
      break;
    }
    case 1: {
      constexpr double kFactors[] = {0.5, 2.0, -1.0, 1.001, 10.0, 0.1};
      double old = 0.0;
      std::from_chars(json.data() + chosen.at, json.data() + chosen.at + chosen.length, old);
      char text[32];
      const double changed = below(random, 2) == 0 ? old * kFactors[below(random, std::size(kFactors))]
                                                   : old + static_cast<double>(below(random, 5)) - 2.0;
      value.assign(text, std::to_chars(text, text + sizeof text, changed).ptr);
      break;
    }
    default:
      value = kNumbers[below(random, std::size(kNumbers))];
  }
  json.replace(chosen.at, chosen.length, value);
}

void change_value(std::string& json, unsigned seed) {
  Random random(seed + 1u);
  const std::vector<Span> values = values_of(json);
  if (values.empty()) return;
  const Span chosen = values[below(random, values.size())], other = values[below(random, values.size())];
  const std::string text = json.substr(chosen.at, chosen.length);
  switch (below(random, 3)) {
    case 0: {  // with the comma before or behind it
      const bool before = chosen.at > 0 && json[chosen.at - 1] == ',';
      const bool behind =
          !before && chosen.at + chosen.length < json.size() && json[chosen.at + chosen.length] == ',';
      json.erase(chosen.at - (before ? 1 : 0), chosen.length + (before || behind ? 1 : 0));
      break;
    }
    case 1:
      json.insert(chosen.at, text + ",");
      break;
    default:
      json.replace(other.at, other.length, text);
  }
}

void change_word(std::string& bin, unsigned seed) {
  Random random(seed + 1u);
  const std::size_t words = bin.size() / 4;
  if (words == 0) return;
  char* word = bin.data() + 4 * below(random, words);
  float value = 0.0f;
  std::memcpy(&value, word, 4);
  switch (below(random, 4)) {
    case 0:
      value = kFloats[below(random, std::size(kFloats))];
      break;
    case 1:
      value *= 1.0f + 0.001f * static_cast<float>(below(random, 2001)) - 1.0f;
      break;
    case 2:
      std::memcpy(&value, bin.data() + 4 * below(random, words), 4);
      break;
    default: {
      const auto index = static_cast<std::uint32_t>(below(random, 16));
      std::memcpy(&value, &index, 4);
    }
  }
  std::memcpy(word, &value, 4);
}

}  // namespace caustics::fuzz

// The render fuzzer's inputs end in bytes that choose settings (CAUSTICS_FUZZ_TAIL of them), which stay at
// the end.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  using namespace caustics::fuzz;
  Random random(seed + 1u);
  constexpr std::size_t kTail = CAUSTICS_FUZZ_TAIL;
  if (size <= kTail || below(random, 20) == 0) return LLVMFuzzerMutate(data, size, max_size);
  std::string tail(reinterpret_cast<const char*>(data) + size - kTail, kTail);
  if (kTail > 0 && below(random, 4) == 0) {
    data[size - kTail + below(random, kTail)] = static_cast<std::uint8_t>(random());
    return size;
  }
  Parts parts = parts_of(std::string(reinterpret_cast<const char*>(data), size - kTail));
  const std::size_t room = max_size > size + 64 ? max_size - size - 64 : 0;
  for (std::size_t n = 1 + below(random, 3); n > 0; --n) mutate_parts(parts, random, room);
  const std::string bytes = joined(parts) + tail;
  if (bytes.size() > max_size) return size;
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}
