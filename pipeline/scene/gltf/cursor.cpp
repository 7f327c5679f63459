#include "pipeline/scene/gltf/cursor.hpp"

namespace caustics::gltf {

void Cursor::require() const {
  if (!value_) fail("is missing", kExportAgainOrCorrect);
}

Cursor Cursor::member(const char* key) const {
  std::string path = path_.empty() ? key : path_ + "." + key;
  if (!value_) return {*context_, nullptr, std::move(path)};
  if (!value_->is_object()) fail("must be an object, is " + value_->described(), kExportAgainOrCorrect);
  return {*context_, value_->find(key), std::move(path)};
}

std::vector<std::string> Cursor::keys() const {
  std::vector<std::string> names;
  if (!value_) return names;
  if (!value_->is_object()) fail("must be an object, is " + value_->described(), kExportAgainOrCorrect);
  for (const JsonMember& member : value_->as<Json::Object>()) names.push_back(member.key);
  return names;
}

std::size_t Cursor::size() const {
  if (!value_) return 0;
  if (!value_->is_array()) fail("must be an array, is " + value_->described(), kExportAgainOrCorrect);
  return value_->as<Json::Array>().size();
}

Cursor Cursor::element(std::size_t i) const {
  std::string path = path_ + "[" + std::to_string(i) + "]";
  const bool there = i < size();
  return {*context_, there ? &value_->as<Json::Array>()[i] : nullptr, std::move(path)};
}

double Cursor::number() const {
  require();
  if (!value_->is<double>()) fail("must be a number, is " + value_->described(), kExportAgainOrCorrect);
  return value_->as<double>();
}

double Cursor::number(double fallback) const { return value_ ? number() : fallback; }

std::int64_t Cursor::integer(std::int64_t lowest, std::int64_t highest) const {
  require();
  if (!value_->is<double>()) fail("must be an integer, is " + value_->described(), kExportAgainOrCorrect);
  // Compared as double first: what does not fit an integer fails here and is never converted.
  const double value = value_->as<double>();
  constexpr double kLargest = 9007199254740992.0;  // 2^53
  const bool fits = value >= -kLargest && value <= kLargest;
  const std::int64_t whole = fits ? static_cast<std::int64_t>(value) : 0;
  if (fits && static_cast<double>(whole) != value) {
    fail("must be an integer, is " + value_->described(), kExportAgainOrCorrect);
  }
  if (!fits || whole < lowest || whole > highest) {
    fail("must be from " + std::to_string(lowest) + " to " + std::to_string(highest) + ", is " +
             value_->described(),
         kExportAgainOrCorrect);
  }
  return whole;
}

std::int64_t Cursor::integer(std::int64_t lowest, std::int64_t highest, std::int64_t fallback) const {
  return value_ ? integer(lowest, highest) : fallback;
}

int Cursor::index(const char* array, std::size_t count) const {
  require();
  if (!value_->is<double>()) fail("must be an index, is " + value_->described(), kExportAgainOrCorrect);
  const double value = value_->as<double>();
  if (!(value >= 0 && value < static_cast<double>(count))) {
    fail("refers to " + std::string(array) + "[" + value_->described() + "], but there " +
             (count == 1 ? "is 1" : "are " + std::to_string(count)),
         kExportAgainOrCorrect);
  }
  return static_cast<int>(integer(0, static_cast<std::int64_t>(count) - 1));
}

std::optional<int> Cursor::optional_index(const char* array, std::size_t count) const {
  if (!value_) return std::nullopt;
  return index(array, count);
}

bool Cursor::boolean(bool fallback) const {
  if (!value_) return fallback;
  if (!value_->is<bool>()) fail("must be true or false, is " + value_->described(), kExportAgainOrCorrect);
  return value_->as<bool>();
}

std::string Cursor::string() const {
  require();
  if (!value_->is<std::string>()) fail("must be a string, is " + value_->described(), kExportAgainOrCorrect);
  return value_->as<std::string>();
}

std::string Cursor::string(const std::string& fallback) const { return value_ ? string() : fallback; }

std::vector<double> Cursor::numbers(std::size_t count) const {
  std::vector<double> values;
  if (!value_) return values;
  if (size() != count) {
    fail("must have " + std::to_string(count) + " numbers, has " + std::to_string(size()),
         kExportAgainOrCorrect);
  }
  for (std::size_t i = 0; i < count; ++i) values.push_back(element(i).number());
  return values;
}

}  // namespace caustics::gltf
