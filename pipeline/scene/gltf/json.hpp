// A JSON document as a tree of values, read once.
//
// A tree of our own: nlohmann-json's values allocate in their destructors and moves, which may not throw, so
// memory that runs out there ends the process. Its lexer and grammar read the text, without its values.
#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace caustics::gltf {

struct JsonMember;

class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<JsonMember>;  // ascending by key, each key once

  template <typename T>
  bool is() const {
    return std::holds_alternative<T>(value_);
  }
  template <typename T>
  const T& as() const {
    return std::get<T>(value_);
  }
  template <typename T>
  T& as() {
    return std::get<T>(value_);
  }
  template <typename T>
  T& set(T value) {
    return value_.template emplace<T>(std::move(value));
  }
  bool is_object() const { return is<Object>(); }
  bool is_array() const { return is<Array>(); }

  // The member of an object, or null.
  const Json* find(std::string_view key) const;
  // What stands there, for messages: `the string "..."`, `an array`, `an object`, or the text of the rest.
  std::string described() const;

 private:
  std::variant<std::monostate, bool, double, std::string, Array, Object> value_;  // monostate: null
};

struct JsonMember {
  std::string key;
  Json value;
};

// Of two members of one name the last one counts. Where the text is no JSON, `problem` receives the reason.
// The text's depth must be bounded: trees are destroyed by recursion.
Json parse_json(std::string_view text, std::string& problem);

}  // namespace caustics::gltf
