#include "gl_backend/gl_text.hpp"

#include <cctype>

#include "gl_backend/precise_text.hpp"

namespace caustics::gl {

namespace {

void replace_word(std::string& text, const std::string& word, const std::string& by) {
  const auto in_word = [&](std::size_t i) {
    return i < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_' || text[i] == '.');
  };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    if (!in_word(at - 1) && !in_word(at + word.size())) text.replace(at, word.size(), by);
}

std::string with_choices(const Shader& shader, std::span<const int> values) {
  std::string text(shader.text);
  for (std::size_t i = 0; i < values.size(); ++i)
    replace_word(text, "u." + std::string(choices_of(shader)[i].name), std::to_string(values[i]));
  return text;
}

}  // namespace

std::string gl_text(const Shader& shader, Stage stage, std::span<const int> choices) {
  const bool quads = stage == Stage::VertexOfQuads;
  std::string head = stage == Stage::Fragment ? "#define FRAGMENT_STAGE 1\n" : "#define VERTEX_STAGE 1\n";
  if (quads) head += "#define POINT_QUADS 1\n";
  return precise_text("#version 450 core\n" + head + std::string(kPrelude) + "\n#line 1\n" +
                      with_choices(shader, choices) + (quads ? std::string(kPointQuads) : ""));
}

}  // namespace caustics::gl
