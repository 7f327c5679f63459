#include "pipeline/gpu/shader_lines.hpp"

#include <algorithm>
#include <cstdint>

namespace caustics {

namespace {

class Conditions {
 public:
  bool counts(std::string_view line) {
    if (const auto name = word_after(line, "#define "); !name.empty()) defined_.push_back(name);
    if (line.starts_with("#if")) {
      open_.push_back(is_true(line));
    } else if (line.starts_with("#else") && !open_.empty()) {
      open_.back() = open_.back() == State::Always ? State::Always
                     : open_.back() == State::No   ? State::Yes
                                                   : State::No;
    } else if (line.starts_with("#endif") && !open_.empty()) {
      open_.pop_back();
    }
    return std::find(open_.begin(), open_.end(), State::No) == open_.end();
  }

 private:
  enum class State : std::uint8_t { No, Yes, Always };

  static std::string_view word_after(std::string_view line, std::string_view directive) {
    if (!line.starts_with(directive)) return {};
    line.remove_prefix(directive.size());
    return line.substr(0, line.find_first_of(" \t("));
  }

  State is_true(std::string_view line) const {
    const auto wanted = word_after(line, "#ifdef "), unwanted = word_after(line, "#ifndef ");
    const auto name = wanted.empty() ? unwanted : wanted;
    if (name.empty() || name.ends_with("_STAGE")) return State::Always;
    const bool known = std::find(defined_.begin(), defined_.end(), name) != defined_.end();
    return known == !wanted.empty() ? State::Yes : State::No;
  }

  std::vector<std::string_view> defined_;
  std::vector<State> open_;
};

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> lines_that_count(std::string_view text) {
  std::vector<std::string_view> lines;
  Conditions conditions;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (conditions.counts(line)) lines.push_back(line);
  }
  return lines;
}

}  // namespace caustics
