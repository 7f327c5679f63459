#include "pipeline/scene/gltf/json.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "pipeline/scene/gltf/context.hpp"

namespace caustics::gltf {

namespace {

bool by_key(const JsonMember& a, const JsonMember& b) { return a.key < b.key; }

// In the order of their keys, of equal ones the last.
void sort_members(Json::Object& members) {
  std::stable_sort(members.begin(), members.end(), by_key);
  const auto same = [](const JsonMember& a, const JsonMember& b) { return a.key == b.key; };
  // std::unique keeps the first of equal ones: from the end that is the last.
  const auto kept = std::unique(members.rbegin(), members.rend(), same);
  members.erase(members.begin(), kept.base());
}

std::string text_of(double number) {
  char digits[32];
  constexpr double kExact = 9007199254740992.0;  // 2^53
  const bool whole =
      number >= -kExact && number <= kExact && number == static_cast<double>(static_cast<long long>(number));
  const auto end = whole ? std::to_chars(digits, digits + sizeof digits, static_cast<long long>(number)).ptr
                         : std::to_chars(digits, digits + sizeof digits, number).ptr;
  return std::string(digits, end);
}

// What nlohmann-json calls while it reads; false would end the reading.
class Builder {
 public:
  explicit Builder(std::string& problem) : problem_(problem) {}

  Json take() { return std::move(root_); }

  bool null() { return add(std::monostate()); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return add(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(std::vector<std::uint8_t>&) { return false; }  // no part of JSON's text
  bool start_object(std::size_t) { return open(Json::Object()); }
  bool start_array(std::size_t) { return open(Json::Array()); }
  bool key(std::string& name) {
    open_.back()->as<Json::Object>().push_back({std::move(name), Json()});
    return true;
  }
  bool end_object() {
    sort_members(open_.back()->as<Json::Object>());
    return end_array();
  }
  bool end_array() {
    open_.pop_back();
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) {
    // nlohmann-json prefixes its messages with an identifier in brackets.
    problem_ = error.what();
    const std::size_t end = problem_.find("] ");
    if (end != std::string::npos) problem_ = problem_.substr(end + 2);
    return false;
  }

 private:
  // Where the next value belongs. What is open does not grow while something in it is open: pointers hold.
  Json& place() {
    if (open_.empty()) return root_;
    Json& parent = *open_.back();
    if (parent.is_object()) return parent.as<Json::Object>().back().value;
    return parent.as<Json::Array>().emplace_back();
  }
  template <typename T>
  bool add(T value) {
    place().set(std::move(value));
    return true;
  }
  template <typename T>
  bool open(T value) {
    Json& here = place();
    here.set(std::move(value));
    open_.push_back(&here);
    return true;
  }

  std::string& problem_;
  Json root_;
  std::vector<Json*> open_;
};

}  // namespace

const Json* Json::find(std::string_view key) const {
  if (!is_object()) return nullptr;
  const Object& members = as<Object>();
  const auto found =
      std::lower_bound(members.begin(), members.end(), key,
                       [](const JsonMember& member, std::string_view k) { return member.key < k; });
  return found != members.end() && found->key == key ? &found->value : nullptr;
}

std::string Json::described() const {
  if (is<std::string>()) return "the string \"" + printable(as<std::string>(), 40) + "\"";
  if (is_array()) return "an array";
  if (is_object()) return "an object";
  if (is<bool>()) return as<bool>() ? "true" : "false";
  return is<double>() ? text_of(as<double>()) : "null";
}

Json parse_json(std::string_view text, std::string& problem) {
  Builder builder(problem);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder) && problem.empty())
    problem = "the JSON cannot be read";
  return builder.take();
}

}  // namespace caustics::gltf
