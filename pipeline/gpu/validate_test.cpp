#include "pipeline/gpu/validate.hpp"

#include "pipeline/gpu/error.hpp"
#include "raster/software_device.hpp"
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

const Shader kMeshShader{"test", "ATTRIBUTE(0, Vec3, position)\nOUTPUT(0, Vec4, copy)\n", {}};

template <class Check>
std::string complaint_of(Check check) {
  try {
    check();
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::InternalError);
    return error.what();
  }
  return "";
}

std::string complaint(const PassDefinition& definition) {
  return complaint_of([&] { validate(definition); });
}

void check_refused(const std::string& text, const std::string& part) {
  CHECK(text.find("pass 'copy'") != std::string::npos);
  CHECK(text.find(part) != std::string::npos);
  CHECK(text.find('\n') == std::string::npos);
}

// A shader of so many textures and outputs, all of the pass's names.
Shader shader_of(std::size_t textures, std::size_t outputs) {
  std::string text;
  for (std::size_t i = 0; i < textures; ++i)
    text += "TEXTURE(" + std::to_string(i) + ", t" + std::to_string(i) + ")\n";
  for (std::size_t i = 0; i < outputs; ++i)
    text += "OUTPUT(" + std::to_string(i) + ", Vec4, o" + std::to_string(i) + ")\n";
  static std::vector<std::string> texts;
  texts.reserve(16);
  texts.push_back(text);
  return {"test", texts.back(), {}};
}

// A run of the sound definition with fitting targets, which a test spoils.
struct SoundRun {
  std::unique_ptr<Device> device = make_software_device();
  PassDefinition definition = sound();
  PassRun run;

  SoundRun() {
    run.definition = &definition;
    run.colors = {device->create_texture(definition.writes[0].format, 4, 4)};
    run.draws = {Draw{.vertex_count = 3, .textures = {device->create_texture(Format::RGBA32F, 2, 2)}}};
  }
  std::string complaint() const {
    return complaint_of([&] { validate(run, *device); });
  }
};

}  // namespace

TEST_CASE("validate: a sound definition passes") { CHECK(complaint(sound()).empty()); }

TEST_CASE("validate: each wrong definition is refused in a line that names the pass") {
  const auto refused = [](const PassDefinition& definition, const std::string& part) {
    check_refused(complaint(definition), part);
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
  d.reads[0].name = "sauce";
  refused(d, "read 0 is 'sauce', its shader 'test' declares 'source' there");
  d = sound();
  d.writes[0].name = "kopy";
  refused(d, "write 0 is 'kopy', its shader 'test' declares 'copy' there");
  d = sound();
  d.depth_state.write = true;
  refused(d, "without a depth attachment");
  d = sound();
  d.reads[0].name = "copy";
  refused(d, "reads and writes 'copy'");
  d = sound();
  d.name.clear();
  CHECK(complaint(d) == "a pass has no name");
}

TEST_CASE("validate: definitions beyond what OpenGL promises, or without a use, are refused") {
  const auto refused = [](std::size_t textures, std::size_t outputs, const std::string& part,
                          bool same_names = false) {
    const Shader shader = shader_of(textures, outputs);
    PassDefinition d{.name = "copy", .purpose = "test", .shader = &shader};
    for (std::size_t i = 0; i < textures; ++i)
      d.reads.push_back({.name = "t" + std::to_string(i), .meaning = "m"});
    for (std::size_t i = 0; i < outputs; ++i)
      d.writes.push_back({.name = same_names ? "o" : "o" + std::to_string(i), .meaning = "m"});
    check_refused(complaint(d), part);
  };
  refused(1, 0, "writes nothing");
  refused(0, 9, "writes 9 colour attachments; 8");
  refused(17, 1, "more than the 16 textures");
  refused(0, 2, "writes 'o' twice", true);
}

TEST_CASE("validate: each wrong run is refused in a line that names the pass") {
  CHECK(SoundRun().complaint().empty());
  const auto refused = [](void (*spoil)(SoundRun&), const std::string& part) {
    SoundRun r;
    spoil(r);
    check_refused(r.complaint(), part);
  };
  refused([](SoundRun& r) { r.run.colors.clear(); }, "got 0 colour targets, writes 1");
  refused([](SoundRun& r) { r.run.depth = r.device->create_texture(Format::Depth32F, 4, 4); },
          "takes no depth target");
  refused([](SoundRun& r) { r.definition.depth = DepthWrite{.name = "d", .meaning = "m"}; },
          "needs a depth target");
  refused([](SoundRun& r) { r.run.keep = {false, true}; }, "`keep` must have one entry");
  refused([](SoundRun& r) { r.run.colors = {r.device->create_texture(Format::R32F, 4, 4)}; },
          "target 'copy' has format R32F, must be");
  refused(
      [](SoundRun& r) {
        r.definition.depth = DepthWrite{.name = "d", .meaning = "m"};
        r.run.depth = r.device->create_texture(Format::Depth32F, 4, 5);
      },
      "target 'd' differs in size");
  refused([](SoundRun& r) { r.run.draws[0].textures.clear(); }, "binds 0 textures, the pass reads 1");
  refused([](SoundRun& r) { r.run.draws[0].textures = r.run.colors; },
          "reads a texture that the pass writes");
  refused([](SoundRun& r) { r.run.draws[0].uniforms.resize(20); }, "multiple of 16 bytes");
  refused(
      [](SoundRun& r) {
        r.definition.topology = Topology::Rectangles;
        r.run.draws[0].mesh = r.device->create_mesh({.layout = {{"position", 3}}, .vertices = {0, 0, 0}});
      },
      "draws rectangles of a mesh");
  SoundRun none;
  none.run.definition = nullptr;
  CHECK(none.complaint() == "a run names no pass definition");
}

TEST_CASE("validate: a shader with attributes needs a mesh that has them") {
  SoundRun r;
  r.definition.reads.clear();
  r.definition.shader = &kMeshShader;
  r.run.draws[0].textures.clear();
  check_refused(r.complaint(), "a draw has no mesh");
  r.run.draws[0].mesh = r.device->create_mesh({.layout = {{"position", 2}}, .vertices = {0, 0}});
  check_refused(r.complaint(), "lacks attribute 'position' with 3 components");
  r.run.draws[0].mesh = r.device->create_mesh({.layout = {{"position", 3}}, .vertices = {0, 0, 0}});
  CHECK(r.complaint().empty());
}
