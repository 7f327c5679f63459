#include "pipeline/gpu/uniform_layout.hpp"

#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("uniform layout: names, offsets by std140, and meanings are read from the text") {
  const UniformLayout layout = reflect_uniforms(
      "struct Window {\n  vec2 scale;  // texels\n  float near;\n};\n"
      "struct Ray {\n  Vec3 origin;\n};\n"
      "UNIFORMS_BEGIN\n"
      "float share;       // of the light\n"
      "// a line of its own\n"
      "Window window;     // the map's\n"
      "vec3 color;\n"
      "CHOICE(has_panes)  // 1: there are panes\n"
      "mat4 turn;\n"
      "int count;\n"
      "UNIFORMS_END\n");
  const std::vector<std::string> names = {"share",     "window.scale", "window.near", "color",
                                          "has_panes", "turn",         "count"};
  const std::vector<std::size_t> offsets = {0, 16, 24, 32, 44, 48, 112};
  REQUIRE(layout.variables.size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    CHECK(layout.variables[i].name == names[i]);
    CHECK(layout.variables[i].offset == offsets[i]);
  }
  CHECK(layout.variables[1].meaning == "the map's: texels");
  CHECK(layout.variables[2].meaning == "the map's");
  CHECK(layout.variables[4].type == "int");
  CHECK(layout.variables[4].meaning == "1: there are panes");
  CHECK(layout.bytes == 128);
}

TEST_CASE("uniform layout: a text without a block has none, and what a condition leaves out is not read") {
  CHECK(reflect_uniforms("TEXTURE(0, t)\n").bytes == 0);
  const std::string text = "UNIFORMS_BEGIN\n#ifdef HAZE\nfloat thick;\n#endif\nfloat share;\nUNIFORMS_END\n";
  CHECK(reflect_uniforms(text).variables.size() == 1);
  CHECK(reflect_uniforms("#define HAZE 1\n" + text).variables.size() == 2);
  CHECK_THROWS_WITH(reflect_uniforms("UNIFORMS_BEGIN\nbool wrong;\nUNIFORMS_END\n"),
                    "uniform 'wrong' has the type 'bool': use int, float, vec2, vec3, vec4, mat4 or a "
                    "struct of these");
}

TEST_CASE("uniform layout: of every pass it is as long as C++ has the block, and its choices lie alike") {
  for (const Pass& pass : pass_registry()) {
    for (const Permutation& permutation : pass.shaders) {
      const Shader& shader = *permutation.shader;
      INFO(shader.name);
      const UniformLayout& layout = uniform_layout_of(shader);
      CHECK(layout.bytes == shader.uniform_bytes());
      for (const ShaderChoice& choice : choices_of(shader)) {
        const auto found = std::find_if(layout.variables.begin(), layout.variables.end(),
                                        [&](const UniformVariable& v) { return v.name == choice.name; });
        REQUIRE(found != layout.variables.end());
        CHECK(found->offset == choice.offset);
      }
    }
  }
}
