#include "pipeline/gpu/validate.hpp"

#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

const Shader kShader{"test", "TEXTURE(0, source)\nOUTPUT(0, Vec4, copy)\n", {}};

PassDefinition sound() {
  return {.name = "copy",
          .purpose = "test",
          .reads = {{.name = "source", .meaning = "m"}},
          .writes = {{.name = "copy", .meaning = "m"}},
          .shader = &kShader};
}

std::string complaint(const PassDefinition& definition) {
  try {
    validate(definition);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::InternalError);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("validate: a sound definition passes") { CHECK(complaint(sound()).empty()); }

TEST_CASE("validate: each wrong definition is refused in a line that names the pass") {
  const auto refused = [](const PassDefinition& definition, const std::string& part) {
    const std::string text = complaint(definition);
    CHECK(text.find("pass 'copy'") != std::string::npos);
    CHECK(text.find(part) != std::string::npos);
    CHECK(text.find('\n') == std::string::npos);
  };
  PassDefinition d = sound();
  d.shader = nullptr;
  refused(d, "no shader");
  d = sound();
  d.reads.clear();
  refused(d, "declares 1");
  d = sound();
  d.writes.push_back({.name = "other", .meaning = "m"});
  refused(d, "declares 1");
  d = sound();
  d.writes[0].format = Format::Depth32F;
  refused(d, "depth format");
  d = sound();
  d.depth_state.write = true;
  refused(d, "without a depth attachment");
}
