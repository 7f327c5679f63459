#include "pipeline/gpu/uniform_layout.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/shader.hpp"
#include "pipeline/gpu/shader_lines.hpp"

namespace caustics {

namespace {

struct UniformMember {
  std::string_view type, name, comment;
};
using UniformMembers = std::vector<UniformMember>;

// "vec2 scale;  // texels", or "CHOICE(estimator)  // ESTIMATOR_PAPER ..."; nothing of other lines.
std::optional<UniformMember> member_of(std::string_view line) {
  constexpr std::string_view kChoice = "CHOICE(";
  const auto slashes = std::min(line.find("//"), line.size());
  const std::string_view code = trimmed(line.substr(0, slashes));
  const std::string_view comment = trimmed(line.substr(std::min(slashes + 2, line.size())));
  if (code.starts_with(kChoice) && code.ends_with(')'))
    return UniformMember{"int", code.substr(kChoice.size(), code.size() - kChoice.size() - 1), comment};
  const auto blank = code.find(' ');
  if (blank == code.npos || !code.ends_with(';')) return {};
  return UniformMember{code.substr(0, blank), trimmed(code.substr(blank, code.size() - 1 - blank)), comment};
}

// The structs of a text and its uniform block. Structs of what varies from lane to lane are among them; no
// block has such members.
struct UniformDeclarations {
  std::map<std::string_view, UniformMembers> structs;
  UniformMembers block;
};

UniformDeclarations declarations_in(std::string_view text) {
  constexpr std::string_view kStruct = "struct ";
  UniformDeclarations found;
  UniformMembers* open = nullptr;
  for (const std::string_view line : lines_that_count(text)) {
    if (line.starts_with(kStruct)) {
      const std::string_view rest = line.substr(kStruct.size());
      open = &found.structs[rest.substr(0, rest.find_first_of(" {"))];
      open->clear();  // a text that both stages include
    } else if (line.starts_with("UNIFORMS_BEGIN")) {
      open = &found.block;
    } else if (line.starts_with("}") || line.starts_with("UNIFORMS_END")) {
      open = nullptr;
    } else if (open) {
      if (const auto member = member_of(line)) open->push_back(*member);
    }
  }
  return found;
}

std::size_t aligned(std::size_t offset, std::size_t alignment) {
  return (offset + alignment - 1) / alignment * alignment;
}

std::string with_comment(const std::string& meaning, std::string_view comment) {
  return meaning + (meaning.empty() || comment.empty() ? "" : ": ") + std::string(comment);
}

// Lays members out from `offset` on; returns where they end.
std::size_t lay_out(const UniformDeclarations& declared, const UniformMembers& members,
                    const UniformVariable& whole, std::vector<UniformVariable>& variables) {
  std::size_t end = whole.offset;
  for (const UniformMember& member : members) {
    const int components = uniform_components(member.type);
    end = aligned(end, components == 1 ? 4 : components == 2 ? 8 : 16);
    const UniformVariable variable{whole.name + std::string(member.name), std::string(member.type),
                                   with_comment(whole.meaning, member.comment), end};
    if (components > 0) {
      variables.push_back(variable);
      end += 4 * static_cast<std::size_t>(components);
      continue;
    }
    const auto found = declared.structs.find(member.type);
    if (found == declared.structs.end())
      throw Error(ExitCode::InternalError,
                  "uniform '" + variable.name + "' has the type '" + variable.type +
                      "': use int, float, vec2, vec3, vec4, mat4 or a struct of these");
    end = lay_out(declared, found->second, {variable.name + ".", variable.type, variable.meaning, end},
                  variables);
  }
  return aligned(end, 16);
}

}  // namespace

int uniform_components(std::string_view type) {
  if (type == "int" || type == "float") return 1;
  if (type == "vec2") return 2;
  if (type == "vec3") return 3;
  if (type == "vec4") return 4;
  return type == "mat4" ? 16 : 0;
}

UniformLayout reflect_uniforms(std::string_view text) {
  const UniformDeclarations declared = declarations_in(text);
  UniformLayout layout;
  layout.bytes = lay_out(declared, declared.block, {}, layout.variables);
  return layout;
}

const UniformLayout& uniform_layout_of(const Shader& shader) {
  static std::mutex mutex;
  static std::map<std::string, UniformLayout, std::less<>> known;  // by text; references into it stay
  const std::lock_guard lock(mutex);
  const auto found = known.find(shader.text);
  return found != known.end()
             ? found->second
             : known.emplace(std::string(shader.text), reflect_uniforms(shader.text)).first->second;
}

}  // namespace caustics
