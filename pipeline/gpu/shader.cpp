#include "pipeline/gpu/shader.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <mutex>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/shader_lines.hpp"

namespace caustics {

std::string_view lanes_name(Lanes lanes) {
  switch (lanes) {
    case Lanes::Scalar:
      return "scalar";
    case Lanes::Plain4:
      return "plain4";
    case Lanes::Sse41x4:
      return "sse41";
    case Lanes::Avx2x8:
      return "avx2";
    case Lanes::Avx512x16:
      return "avx512";
  }
  return "?";
}

std::span<const ShaderChoice> choices_of(const Shader& shader) {
  return shader.choices ? shader.choices() : std::span<const ShaderChoice>();
}

namespace {

[[noreturn]] void refuse(std::string_view line, const std::string& why) {
  throw Error(ExitCode::InternalError, "shader declaration '" + std::string(line) + "': " + why);
}

int components_of(std::string_view type, std::string_view line) {
  if (type == "Float") return 1;
  if (type == "Vec2") return 2;
  if (type == "Vec3") return 3;
  if (type == "Vec4") return 4;
  refuse(line, "the type must be Float, Vec2, Vec3 or Vec4");
}

struct Declaration {
  std::string_view line;
  int number = 0;
  std::vector<std::string_view> words;  // after the number
};

// Parses "KEYWORD(number, word, word)" at the start of a line.
bool parse(std::string_view line, std::string_view keyword, Declaration& result) {
  if (!line.starts_with(keyword) || line.size() <= keyword.size() || line[keyword.size()] != '(')
    return false;
  const auto end = line.find(')');
  if (end == line.npos) refuse(line, "a closing parenthesis is missing on the line");
  std::string_view rest = line.substr(keyword.size() + 1, end - keyword.size() - 1);
  std::vector<std::string_view> words;
  for (std::size_t start = 0; start <= rest.size();) {
    const auto comma = std::min(rest.find(',', start), rest.size());
    words.push_back(trimmed(rest.substr(start, comma - start)));
    start = comma + 1;
  }
  if (words.size() < 2) refuse(line, "expected a number and a name");
  int number = 0;
  const auto [stop, error] = std::from_chars(words[0].data(), words[0].data() + words[0].size(), number);
  if (error != std::errc{} || stop != words[0].data() + words[0].size())
    refuse(line, "the first argument must be a whole number");
  result = {line, number, {words.begin() + 1, words.end()}};
  return true;
}

void add_variable(std::vector<ShaderVariable>& list, const Declaration& d, Interpolation how) {
  if (d.words.size() != 2) refuse(d.line, "expected (component, type, name)");
  const int expected = list.empty() ? 0 : list.back().first_component + list.back().components;
  if (d.number != expected) refuse(d.line, "component " + std::to_string(expected) + " comes next");
  list.push_back({std::string(d.words[1]), d.number, components_of(d.words[0], d.line), how});
}

void add_name(std::vector<std::string>& list, const Declaration& d) {
  if (d.number != static_cast<int>(list.size()))
    refuse(d.line, "number " + std::to_string(list.size()) + " comes next");
  list.emplace_back(d.words.back());
}

int sum_of_components(const std::vector<ShaderVariable>& list) {
  return list.empty() ? 0 : list.back().first_component + list.back().components;
}

}  // namespace

int ShaderInterface::attribute_components() const { return sum_of_components(attributes); }
int ShaderInterface::varying_components() const { return sum_of_components(varyings); }

ShaderInterface reflect(std::string_view text) {
  ShaderInterface result;
  for (const std::string_view line : lines_that_count(text)) {
    result.discards = result.discards || line.find("discard_if(") != line.npos;
    Declaration d;
    if (parse(line, "ATTRIBUTE", d)) add_variable(result.attributes, d, Interpolation::Smooth);
    if (parse(line, "VARYING_SMOOTH", d)) add_variable(result.varyings, d, Interpolation::Smooth);
    if (parse(line, "VARYING_FLAT", d)) add_variable(result.varyings, d, Interpolation::Flat);
    if (parse(line, "TEXTURE", d)) add_name(result.textures, d);
    if (parse(line, "OUTPUT", d)) add_name(result.outputs, d);
  }
  return result;
}

const ShaderInterface& interface_of(const Shader& shader) {
  static std::mutex mutex;
  static std::map<std::string, ShaderInterface, std::less<>> known;  // by text; references into it stay
  const std::lock_guard lock(mutex);
  const auto found = known.find(shader.text);
  return found != known.end() ? found->second
                              : known.emplace(std::string(shader.text), reflect(shader.text)).first->second;
}

}  // namespace caustics
