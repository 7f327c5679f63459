// What is done to a shader's text so that OpenGL computes what it says.
#include "gl_backend/precise_text.hpp"

#include "gl_backend/gl_text.hpp"
#include "tests/support/catch.hpp"

using caustics::gl::precise_text;

namespace {

// A text as the body of a function that returns a Float.
std::string in_function(const std::string& statements) {
  const std::string head = "Float f() {", all = precise_text(head + statements + "}");
  REQUIRE(all.substr(0, head.size()) == head);
  REQUIRE(all.back() == '}');
  return all.substr(head.size(), all.size() - head.size() - 1);
}

}  // namespace

TEST_CASE("precise text: local variables and parameters of every type bear the mark") {
  CHECK(in_function("Float a = b * c, d;") == "precise Float a = b * c, d;");
  CHECK(in_function("if (x) { vec4 a = b; }") == "if (x) { precise vec4 a = b; }");
  CHECK(in_function("for (int i = 0; i < n; i++) Vec3 p;") ==
        "for (precise int i = 0; i < n; i++) precise Vec3 p;");
  CHECK(precise_text(
            "struct Hit { Float t; };\nvoid g(Hit h, mat4 m, Texture t, OUT(Bool) b) { Hit k = h; }") ==
        "struct Hit { Float t; };\nvoid g(precise Hit h, precise mat4 m, Texture t, OUT(Bool) b) "
        "{ precise Hit k = h; }");
}

TEST_CASE("precise text: a result passes through a variable of the function's type") {
  CHECK(in_function("return a * b;") == "{ precise Float returned = a * b; return returned; }");
  CHECK(in_function("if (c) return a; else return f(b);") ==
        "if (c) { precise Float returned = a; return returned; } "
        "else { precise Float returned = f(b); return returned; }");
  CHECK(precise_text("Bool g(Float x) {\n  return x > 1.0f &&\n    x < 2.0f;\n}\n") ==
        "Bool g(precise Float x) {\n  { precise Bool returned = x > 1.0f &&\n    x < 2.0f; return returned; "
        "}\n}\n");
  CHECK(precise_text("void main() { return; }") == "void main() { return; }");
}

TEST_CASE("precise text: a condition passes through a variable where it calculates") {
  CHECK(in_function("if (a * b > c) x = y;") == "if (exact_condition = (a * b > c)) x = y;");
  CHECK(in_function("while (any_lane(-a < f(b))) x = y;") ==
        "while (exact_condition = (any_lane(-a < f(b)))) x = y;");
  CHECK(in_function("for (int i = 0; a[i] + b < c; i++) {}") ==
        "for (precise int i = 0; exact_condition = (a[i] + b < c); i++) {}");
  CHECK(in_function("if (a > 1.0e-6f && f(b)) x = y;") == "if (a > 1.0e-6f && f(b)) x = y;");
  CHECK(in_function("for (;;) {}") == "for (;;) {}");
}

TEST_CASE("precise text: what declares nothing stays, with comments, directives and line breaks") {
  for (const std::string text :
       {"UNIFORMS_BEGIN\nvec4 window;\nUNIFORMS_END\nVARYING_FLAT(0, Vec3, flux)\n",
        "layout(std140) uniform B { mat4 m; } u;\n", "#define discard_if(c) if (c + 1) discard\n",
        "// Float a;\n/* return Float b; */\n", "precise bool exact_condition;\n"})
    CHECK(precise_text(text) == text);
  CHECK(in_function("x = Float(a) * u.from.x; // Float b;\n#ifdef HAZE\n#endif\n") ==
        "x = Float(a) * u.from.x; // Float b;\n#ifdef HAZE\n#endif\n");
}

TEST_CASE("gl text: a choice's value stands where the text asks it, and nowhere else") {
  static constexpr caustics::ShaderChoice kChoices[] = {{"size", 0}, {"has_size", 4}};
  const caustics::Shader shader{
      "test",
      "a(u.size, u.has_size, -u.size) u.sizes u.size.x menu.size b.u.size size u.size",
      {},
      nullptr,
      [] { return std::span<const caustics::ShaderChoice>(kChoices); }};
  const int values[] = {12, 0};
  CHECK(caustics::gl::gl_text(shader, caustics::gl::Stage::Vertex, values)
            .ends_with("a(12, 0, -12) u.sizes u.size.x menu.size b.u.size size 12"));
  CHECK(caustics::gl::gl_text(shader, caustics::gl::Stage::Vertex).ends_with(shader.text));
}

TEST_CASE("precise text: what is not GLSL comes out too") {
  for (const std::string text :
       {"", "Float f(", "Float f() { return", "Float f() { if (a + b", "Float f() { for (;", "struct", "}}}",
        "Float f() { return a; }}", "/*", "#"})
    CHECK(precise_text(text).size() >= text.size());
}
