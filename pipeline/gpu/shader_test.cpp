#include "pipeline/gpu/shader.hpp"

#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("reflect: declarations are read from the text, in order") {
  const ShaderInterface i = reflect(
      "TEXTURE(0, first)\n  TEXTURE(1, second)\nVARYING_SMOOTH(0, Vec3, p)\n"
      "VARYING_FLAT(3, Vec2, q)\nATTRIBUTE(0, Vec3, position)\nOUTPUT(0, Vec4, color)\n");
  CHECK(i.textures == std::vector<std::string>{"first", "second"});
  CHECK(i.outputs == std::vector<std::string>{"color"});
  REQUIRE(i.varyings.size() == 2);
  CHECK(i.varyings[1].name == "q");
  CHECK(i.varyings[1].interpolation == Interpolation::Flat);
  CHECK(i.varying_components() == 5);
  CHECK(i.attribute_components() == 3);
}

TEST_CASE("reflect: what a condition leaves out is not read") {
  const std::string choice = "#ifdef HAZE\nTEXTURE(0, hazy)\n#else\nTEXTURE(0, clear)\n#endif\n";
  CHECK(reflect(choice).textures == std::vector<std::string>{"clear"});
  CHECK(reflect("#define HAZE 1\n" + choice).textures == std::vector<std::string>{"hazy"});
}

TEST_CASE("reflect: gaps, overlaps and unknown types are refused") {
  CHECK_THROWS_AS(reflect("VARYING_SMOOTH(1, Vec3, p)\n"), Error);
  CHECK_THROWS_AS(reflect("ATTRIBUTE(0, Vec3, p)\nATTRIBUTE(2, Vec3, q)\n"), Error);
  CHECK_THROWS_AS(reflect("TEXTURE(1, t)\n"), Error);
  CHECK_THROWS_AS(reflect("OUTPUT(0, Vec4, a)\nOUTPUT(0, Vec4, b)\n"), Error);
  CHECK_THROWS_AS(reflect("ATTRIBUTE(0, Mat4, m)\n"), Error);
  CHECK_THROWS_AS(reflect("TEXTURE(x, t)\n"), Error);
}
