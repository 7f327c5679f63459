// A place in the file's JSON that knows its path, so that whatever is wrong there is said with the
// path.
//
// A cursor may stand on nothing (an absent member); reading a value from it gives the default, or
// fails where the value is required. A value of the wrong type always fails.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/scene/gltf/context.hpp"
#include "pipeline/scene/gltf/json.hpp"

namespace caustics::gltf {

// What to do about a file that is wrong: the last part of a message.
constexpr const char* kExportAgain = "export the file again";
constexpr const char* kExportAgainOrCorrect = "export the file again or correct it by hand";

class Cursor {
 public:
  Cursor(const Context& context, const Json* value, std::string path)
      : context_(&context), value_(value), path_(std::move(path)) {}

  bool present() const { return value_ != nullptr; }
  const std::string& path() const { return path_; }
  const Context& context() const { return *context_; }
  const Json& json() const { return *value_; }

  Cursor member(const char* key) const;  // of an object, or of nothing
  Cursor member(const std::string& key) const { return member(key.c_str()); }
  std::vector<std::string> keys() const;  // of an object, or of nothing
  std::size_t size() const;               // of an array; nothing has size 0
  Cursor element(std::size_t i) const;

  double number() const;  // required
  double number(double fallback) const;
  // An integer from lowest to highest; numbers such as 3.0 count as integers, as in JSON Schema.
  std::int64_t integer(std::int64_t lowest, std::int64_t highest) const;
  std::int64_t integer(std::int64_t lowest, std::int64_t highest, std::int64_t fallback) const;
  // An index into the top-level array `array` with `count` elements.
  int index(const char* array, std::size_t count) const;  // required
  std::optional<int> optional_index(const char* array, std::size_t count) const;
  bool boolean(bool fallback) const;
  std::string string() const;  // required
  std::string string(const std::string& fallback) const;
  // An array of exactly `count` numbers, or empty where the cursor stands on nothing.
  std::vector<double> numbers(std::size_t count) const;

  [[noreturn]] void fail(const std::string& what, const std::string& advice = "") const {
    context_->fail(path_, what, advice);
  }

 private:
  void require() const;

  const Context* context_;
  const Json* value_;
  std::string path_;
};

}  // namespace caustics::gltf
