#include "gl_backend/precise_text.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <vector>

namespace caustics::gl {

namespace {

// Words hold their dots, `u.light.x`, so that no component is taken for a name of its own. Numbers are words.
enum class Kind { Blank, Directive, Word, Symbol };

struct Token {
  Kind kind = Kind::Blank;
  std::string_view text;
};

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; }

Kind kind_of_first(std::string_view text) {
  if (is_space(text[0]) || text.starts_with("//") || text.starts_with("/*")) return Kind::Blank;
  if (text[0] == '#') return Kind::Directive;
  return in_word(text[0]) && text[0] != '.' ? Kind::Word : Kind::Symbol;
}

std::size_t length_of_word(std::string_view text) {
  std::size_t length = 1;
  const auto signs_exponent = [&](char c) {
    return (c == '-' || c == '+') && is_digit(text[0]) &&
           (text[length - 1] == 'e' || text[length - 1] == 'E');
  };
  while (length < text.size() && (in_word(text[length]) || signs_exponent(text[length]))) ++length;
  return length;
}

std::size_t length_of_first(std::string_view text, Kind kind) {
  const auto through = [&](std::string_view end) {
    const std::size_t found = text.find(end, kind == Kind::Directive ? 1 : 2);
    return found == text.npos ? text.size() : found + end.size();
  };
  if (kind == Kind::Word) return length_of_word(text);
  if (kind == Kind::Directive || text.starts_with("//")) return through("\n");
  return text.starts_with("/*") ? through("*/") : 1;
}

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  while (!text.empty()) {
    const Kind kind = kind_of_first(text);
    const std::size_t length = length_of_first(text, kind);
    tokens.push_back({kind, text.substr(0, length)});
    text.remove_prefix(length);
  }
  return tokens;
}

// Types whose variables may be precise; structs are added as they are met.
const std::set<std::string_view> kTypes = {"Float", "Int",   "Bool",  "Vec2", "Vec3", "Vec4",
                                           "float", "int",   "bool",  "vec2", "vec3", "vec4",
                                           "ivec2", "ivec3", "ivec4", "mat4"};

class Rewriter {
 public:
  explicit Rewriter(std::string_view text) : tokens_(tokens_of(text)), types_(kTypes) {}

  std::string rewritten() {
    while (at_ < end()) {
      if (is("struct")) {
        types_.insert(text_at(next(at_)));
        copy_through("}");
      } else if (is("{")) {  // of an interface block
        copy_through("}");
      } else if (begins_function()) {
        function();
      } else {
        copy();
      }
    }
    return std::move(result_);
  }

 private:
  std::size_t end() const { return tokens_.size(); }
  std::string_view text_at(std::size_t i) const { return i < end() ? tokens_[i].text : std::string_view(); }
  bool is_at(std::size_t i, std::string_view text) const { return text_at(i) == text; }
  bool is(std::string_view text) const { return is_at(at_, text); }
  bool is_word(std::size_t i) const { return i < end() && tokens_[i].kind == Kind::Word; }
  bool is_type(std::size_t i) const { return types_.count(text_at(i)) != 0; }

  // The next token that means something.
  std::size_t next(std::size_t i) const {
    do ++i;
    while (i < end() && (tokens_[i].kind == Kind::Blank || tokens_[i].kind == Kind::Directive));
    return i;
  }

  // The token that closes the bracket at i.
  std::size_t closing(std::size_t i) const {
    int depth = 0;
    for (; i < end(); ++i) {
      if (is_at(i, "(") || is_at(i, "{") || is_at(i, "[")) ++depth;
      if (is_at(i, ")") || is_at(i, "}") || is_at(i, "]")) --depth;
      if (depth == 0) break;
    }
    return i;
  }

  // The first such symbol from i on that no bracket holds; `last` where there is none.
  std::size_t find(std::string_view symbol, std::size_t i, std::size_t last) const {
    while (i < last && !is_at(i, symbol))
      i = (is_at(i, "(") || is_at(i, "{") || is_at(i, "[") ? closing(i) : i) + 1;
    return std::min(i, last);
  }

  bool calculates(std::size_t from, std::size_t to) const {
    for (std::size_t i = from; i < to; ++i)
      if (is_at(i, "+") || is_at(i, "-") || is_at(i, "*") || is_at(i, "/")) return true;
    return false;
  }

  void write(std::string_view text) { result_ += text; }
  void copy() { write(tokens_[at_++].text); }
  void copy_to(std::size_t to) {
    while (at_ < std::min(to, end())) copy();
  }
  void copy_through(std::string_view symbol) {
    while (at_ < end() && !is(symbol)) copy();
    if (at_ < end()) copy();
  }

  bool begins_function() const {
    const std::size_t name = next(at_);
    return (is_type(at_) || is("void")) && is_word(name) && is_at(next(name), "(");
  }

  // A type and a name: what follows a type otherwise is a constructor's bracket, a comma of a macro.
  bool begins_declaration() const { return is_type(at_) && is_word(next(at_)); }

  void function() {
    const std::string_view type = text_at(at_);
    const std::size_t open = next(next(at_)), close = closing(open);
    copy_to(open);
    statements(close, type);
    copy_to(close + 1);
    const std::size_t body = next(close);
    if (!is_at(body, "{")) return;
    copy_to(body);
    statements(closing(body), type);
  }

  // Everything up to `last`, which is inside of a function of that type.
  void statements(std::size_t last, std::string_view type) {
    while (at_ < std::min(last, end())) {
      if (is("return")) {
        result_of(type);
      } else if (is("if") || is("while")) {
        copy_to(next(at_));
        if (is("(")) condition(at_ + 1, closing(at_));
      } else if (is("for")) {
        loop_head(type);
      } else if (begins_declaration()) {
        write("precise ");
        copy();
      } else {
        copy();
      }
    }
  }

  void result_of(std::string_view type) {
    const std::size_t value = next(at_), last = find(";", value, end());
    if (value >= last) return copy_to(last);
    at_ = value;
    write("{ precise " + std::string(type) + " returned = ");
    copy_to(last);
    write("; return returned; }");
    at_ = std::min(last + 1, end());
  }

  void condition(std::size_t from, std::size_t to) {
    copy_to(from);
    if (!calculates(from, to)) return copy_to(to);
    write("exact_condition = (");
    copy_to(to);
    write(")");
  }

  void loop_head(std::string_view type) {
    const std::size_t open = next(at_), close = closing(open);
    const std::size_t first = find(";", open + 1, close), second = find(";", first + 1, close);
    copy_to(open);
    statements(first, type);
    if (second < close) condition(next(first), second);
    copy_to(close);
  }

  std::vector<Token> tokens_;
  std::set<std::string_view> types_;
  std::size_t at_ = 0;
  std::string result_;
};

}  // namespace

std::string precise_text(std::string_view text) { return Rewriter(text).rewritten(); }

}  // namespace caustics::gl
