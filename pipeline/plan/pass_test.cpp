// What a pass's definition makes of a draw's uniform block and an instance's state, and what is refused when
// passes are registered.
#include "pipeline/plan/pass.hpp"

#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

struct alignas(16) Block {
  float width = 0.5f;
  int has_mirrors = 0;
};
Block filled(const PassContext&) { return {}; }

struct LongBlock {
  Block block;
  Block more;
};
LongBlock filled_longer(const PassContext&) { return {}; }

std::span<const ShaderChoice> mirrors_asked() {
  static constexpr ShaderChoice choices[] = {{"has_mirrors", offsetof(Block, has_mirrors)}};
  return choices;
}

const Shader kShader{"glow", "OUTPUT(0, Vec4, light)\n", {}, [] { return sizeof(Block); }, mirrors_asked};
const Shader kLongShader{
    "glow_longer", "OUTPUT(0, Vec4, light)\n", {}, [] { return sizeof(LongBlock); }, mirrors_asked};

Pass glow() {
  return {.name = "glow",
          .purpose = "test",
          .reason = "test",
          .drawn_for = {kLight, kLightFar},
          .writes = {{.name = "light", .meaning = "m"}},
          .depth = DepthWrite{.name = "depth", .meaning = "m"},
          .depth_state = {.compare = Compare::Less, .write = true},
          .states = {{.label = kLightFar.label, .depth_clear = 0.0f, .blend = kAccumulate}},
          .shaders = {{&kShader, block_of<filled>},
                      {&kLongShader, block_of<filled_longer>, with<&Effects::medium>}},
          .choices = {{"has_mirrors", chosen_by<&Effects::mirrors>}}};
}

void check_refused(const Pass& pass, const std::string& why, const std::string& remedy) {
  try {
    validate(Registry{pass});
    FAIL("not refused: " << why);
  } catch (const Error& error) {
    const std::string text = error.what();
    INFO(text);
    CHECK(error.code() == ExitCode::InternalError);
    CHECK(text.starts_with("pass 'glow': "));
    CHECK(text.find(why) != text.npos);
    CHECK(text.ends_with("; " + remedy));
    CHECK(text.find('\n') == text.npos);
  }
}

Block block_in(const UniformBytes& bytes) {
  Block block;
  std::memcpy(&block, bytes.data(), sizeof block);
  return block;
}

}  // namespace

TEST_CASE("pass: a choice is made in the uniform block of every permutation") {
  Effects effects;
  const PassContext context{.effects = &effects};
  CHECK(block_in(glow().uniforms(context)).has_mirrors == 0);
  effects.mirrors.active = true;
  CHECK(block_in(glow().uniforms(context)).has_mirrors == 1);
  CHECK(block_in(glow().uniforms(context)).width == 0.5f);
  effects.medium.active = true;
  const UniformBytes longer = glow().uniforms(context);
  CHECK(longer.size() == sizeof(LongBlock));
  CHECK(block_in(longer).has_mirrors == 1);
}

TEST_CASE("pass: a state is that of the instance with its label alone") {
  const PassDefinition plain = definition_of(glow(), {}, kLight), far = definition_of(glow(), {}, kLightFar);
  CHECK(plain.depth->clear == 1.0f);
  CHECK(far.depth->clear == 0.0f);
  CHECK(far.depth_state.compare == Compare::Less);
  CHECK(plain.writes[0].blend == BlendState{});
  CHECK(far.writes[0].blend == kAccumulate);
}

TEST_CASE("registration: a sound pass is taken, two of one name are not") {
  CHECK_NOTHROW(validate(Registry{glow()}));
  CHECK_THROWS_AS(validate(Registry{glow(), glow()}), Error);
}

TEST_CASE("registration: an empty, a short and a long uniform block are refused in every permutation") {
  const std::string remedy = "give `block_of` a function that returns the struct of that text";
  Pass pass = glow();
  pass.shaders[0].block = {};
  check_refused(pass, "its uniform block has 0 bytes, that of its shader 'glow' 16", remedy);
  pass = glow();
  pass.shaders[1].block = block_of<filled>;
  check_refused(pass, "its uniform block has 16 bytes, that of its shader 'glow_longer' 32", remedy);
  pass = glow();
  pass.shaders[0].block = block_of<filled_longer>;
  check_refused(pass, "its uniform block has 32 bytes, that of its shader 'glow' 16", remedy);
}

TEST_CASE("registration: a permutation without a shader is refused") {
  Pass pass = glow();
  pass.shaders[1].shader = nullptr;
  check_refused(pass, "has", "set `shader`");
}

TEST_CASE("registration: choices that a text asks and those that a pass makes must be the same") {
  Pass pass = glow();
  pass.choices.clear();
  check_refused(pass, "its shader 'glow' asks the choice 'has_mirrors', which nothing makes",
                "add it to `choices`");
  pass = glow();
  pass.choices.push_back({"has_panes", chosen_by<&Effects::thin_panes>});
  check_refused(pass, "makes the choice 'has_panes', which its shader does not ask",
                "declare it by CHOICE and ask it, or remove it");
}

TEST_CASE("registration: a state must be that of an instance") {
  Pass pass = glow();
  pass.states[0].label = "farther";
  check_refused(pass, "has a state for 'farther', for which it is not drawn",
                "add that to `drawn_for` or remove the state");
}
