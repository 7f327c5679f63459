// What the Device contract promises, on OpenGL: textures, clears, uniforms, errors, and that
// nothing is made twice.
#include <cmath>
#include <cstring>

#include "tests/gl/gl_or_skip.hpp"
#include "tests/support/device_contracts.hpp"

using namespace caustics;
using namespace caustics::test;

namespace caustics {
extern const Shader gl_fetch_shader;
}

namespace {

Image numbered(Format format, int width, int height) {
  Image image(format, width, height);
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    const float value = static_cast<float>((i * 37u) % 101u) / 100.0f - (i % 3 ? 0.0f : 0.4f);
    image.values[i] = stored_value(format, format == Format::Depth32F ? std::fabs(value) : value);
  }
  return image;
}

struct FetchRun {
  PassDefinition definition{.name = "fetch",
                            .purpose = "test",
                            .reads = {{.name = "first", .meaning = "m"}, {.name = "second", .meaning = "m"}},
                            .writes = {{.name = "sum", .meaning = "m"}},
                            .shader = &gl_fetch_shader};
  PassRun run;

  FetchRun(TextureId target, TextureId first, TextureId second, std::vector<std::array<float, 4>> tints) {
    run.definition = &definition;
    run.colors = {target};
    for (const std::array<float, 4>& tint : tints) {
      Draw draw{.vertex_count = 3, .textures = {first, second}};
      draw.uniforms.resize(gl_fetch_shader.uniform_bytes());
      std::memcpy(draw.uniforms.data(), tint.data(), sizeof tint);
      run.draws.push_back(draw);
    }
  }
};

}  // namespace

TEST_CASE("gl: an image comes back as it was sent, in every format and at odd widths") {
  const auto device = gl_or_skip();
  for (const Format format : kAllFormats) {
    INFO(format_name(format));
    const Image image = numbered(format, 7, 5);
    const TextureId texture = device->upload(image);
    CHECK(device->shape(texture) == image.shape);
    CHECK(device->read_back(texture).values == image.values);
  }
}

TEST_CASE("gl: half texels keep what they are, the largest and the smallest too") {
  const auto device = gl_or_skip();
  Image image(Format::RGBA16F, 2, 1);
  image.values = {65504.0f, -65504.0f, 0x1p-24f, -0.0f, 1.0f / 0.0f, -0x1p-14f, 2049.0f, 0.1f};
  const Image back = device->read_back(device->upload(image));
  for (std::size_t i = 0; i < 8; ++i) CHECK(back.values[i] == stored_value(Format::RGBA16F, image.values[i]));
  CHECK(std::signbit(back.values[3]));
}

TEST_CASE("gl: a run clears what it does not keep, with the format's rounding") {
  const auto device = gl_or_skip();
  for (const Format format : kAllFormats) {
    if (is_depth(format)) continue;
    INFO(format_name(format));
    PassDefinition definition{.name = "clear",
                              .purpose = "test",
                              .writes = {{.name = "a",
                                          .format = format,
                                          .meaning = "m",
                                          .clear = {0.3f, 1e6f, -2.0f, 0.7f},
                                          .mask = {false, false, false, false}}},
                              .depth = DepthWrite{.name = "d", .meaning = "m", .clear = 0.3f},
                              .shader = &raster_probe_shader};
    const Image before = numbered(format, 3, 2);
    PassRun run{.definition = &definition,
                .colors = {device->upload(before)},
                .depth = device->create_texture(Format::Depth32F, 3, 2),
                .keep = {true, false}};
    device->run(run);
    CHECK(device->read_back(run.colors[0]).values == before.values);
    CHECK(device->read_back(run.depth).at(2, 1, 0) == 0.3f);
    run.keep = {};
    device->run(run);
    const Image after = device->read_back(run.colors[0]);
    for (int c = 0; c < after.channels(); ++c)
      CHECK(after.at(2, 1, c) ==
            stored_value(format, definition.writes[0].clear[static_cast<std::size_t>(c)]));
  }
}

TEST_CASE("gl: a missing texture is one texel of zeros, and each draw has its own uniforms") {
  const auto device = gl_or_skip();
  const Image image = numbered(Format::RGBA32F, 4, 3);
  const TextureId texture = device->upload(image);
  const TextureId target = device->create_texture(Format::RGBA32F, 4, 3);
  FetchRun fetch(target, texture, TextureId::None, {{100, 0, 0, 0}, {0, 10, 20, 30}});
  device->run(fetch.run);
  Image expected = image;
  for (std::size_t i = 0; i < expected.values.size(); ++i)
    expected.values[i] += static_cast<float>(10 * (i % 4));
  CHECK(device->read_back(target).values == expected.values);

  fetch.definition.writes[0].blend = kAccumulate;
  FetchRun none(target, TextureId::None, TextureId::None, {{1, 2, 3, 4}, {10, 20, 30, 40}});
  none.definition.writes[0].blend = kAccumulate;
  device->run(none.run);
  const Image sum = device->read_back(target);
  for (int c = 0; c < 4; ++c) CHECK(sum.at(3, 2, c) == 11.0f * static_cast<float>(c + 1));
}

TEST_CASE("gl: textures of fewer channels and depth textures read as (r, g, 0, 1)") {
  const auto device = gl_or_skip();
  const TextureId target = device->create_texture(Format::RGBA32F, 2, 2);
  for (const Format format : {Format::R32F, Format::RG32F, Format::Depth32F}) {
    INFO(format_name(format));
    const Image image = numbered(format, 2, 2);
    FetchRun fetch(target, device->upload(image), TextureId::None, {{0, 0, 0, 0}});
    device->run(fetch.run);
    const Image out = device->read_back(target);
    CHECK(out.at(1, 1, 0) == image.at(1, 1, 0));
    CHECK(out.at(1, 1, 1) == (format == Format::RG32F ? image.at(1, 1, 1) : 0.0f));
    CHECK(out.at(1, 1, 2) == 0.0f);
    CHECK(out.at(1, 1, 3) == 1.0f);
  }
}

TEST_CASE("gl: a steady loop makes nothing new") {
  const auto device = gl_or_skip({});
  const TextureId target = device->create_texture(Format::RGBA32F, 4, 4);
  FetchRun fetch(target, TextureId::None, TextureId::None, {{1, 1, 1, 1}, {2, 2, 2, 2}});
  device->run(fetch.run);
  const DeviceObjects first = device->made();
  CHECK(first.programs == 1);
  CHECK(first.textures == 1);
  for (int i = 0; i < 20; ++i) CHECK(device->run(fetch.run).milliseconds == 0.0);
  const DeviceObjects last = device->made();
  CHECK(last.programs == first.programs);
  CHECK(last.buffers == first.buffers);
  CHECK(last.textures == first.textures);
  CHECK(last.framebuffers == first.framebuffers);
  CHECK(last.vertex_layouts == first.vertex_layouts);
  CHECK(last.read_backs == 0);
}

TEST_CASE("gl: each value of a choice has a program of its own, made once") {
  const auto device = gl_or_skip({});
  const TextureId target = device->create_texture(Format::RGBA32F, 1, 1);
  FetchRun fetch(target, TextureId::None, TextureId::None, {{1, 2, 3, 4}, {1, 2, 3, 4}});
  fetch.definition.writes[0].blend = kAccumulate;
  const auto drawn = [&](std::initializer_list<int> choices) {
    auto draw = fetch.run.draws.begin();
    for (const int& choice : choices)
      std::memcpy(&(draw++)->uniforms[choices_of(gl_fetch_shader)[0].offset], &choice, sizeof choice);
    device->run(fetch.run);
    return device->read_back(target).at(0, 0, 3);
  };
  CHECK(drawn({0, 0}) == 8.0f);
  CHECK(device->made().programs == 1);
  CHECK(drawn({0, 1}) == 0.0f);
  CHECK(device->made().programs == 2);
  CHECK(drawn({1, 1}) == -8.0f);
  CHECK(drawn({1, 0}) == 0.0f);
  CHECK(device->made().programs == 2);
}

TEST_CASE("gl: a run is timed, and its figures are those of the software device") {
  const auto device = gl_or_skip();
  RasterBench b = counting(64, 64);
  b.definition.count_samples = true;
  const auto square = {b.at(0, 0), b.at(64, 0), b.at(64, 64), b.at(0, 0), b.at(64, 64), b.at(0, 64)};
  b.on = device.get();
  b.draw(square);
  CHECK(b.result.milliseconds > 0.0);
  CHECK(b.result.samples_passed == 4096);
  CHECK(b.result.vertices == 6);
  CHECK(b.result.primitives == 2);
  CHECK((b.result.fragments == 0 || b.result.fragments >= 4096));
}

TEST_CASE("gl: a run drops the side that it culls and no other, whatever was culled before it") {
  const auto device = gl_or_skip();
  RasterBench b = counting(4, 4);
  b.on = device.get();
  const std::vector<RasterVertex> front = {b.at(0, 0), b.at(8, 0), b.at(0, 8)};
  const std::vector<RasterVertex> back = {front[0], front[2], front[1]};
  for (const Cull cull :
       {Cull::None, Cull::Back, Cull::None, Cull::Front, Cull::Back, Cull::Front, Cull::None}) {
    b.definition.cull = cull;
    CHECK(RasterBench::sum(b.draw(front)[0]) == (cull == Cull::Front ? 0.0 : 16.0));
    CHECK(RasterBench::sum(b.draw(back)[0]) == (cull == Cull::Back ? 0.0 : 16.0));
  }
}

TEST_CASE("gl: where no sample passed, what depends on the occlusion query is cleared and not drawn") {
  for (const bool measures : {true, false}) {
    const auto device = gl_or_skip({.measure = measures});
    check_occlusion_queries(*device, measures);
  }
}

TEST_CASE("gl: what is written to an absent target goes nowhere, the others hold the same") {
  check_absent_targets(*gl_or_skip());
}

TEST_CASE("gl: textures beyond the limits and ids that do not exist are refused") {
  const auto device = gl_or_skip();
  const int most = device->max_texture_size();
  CHECK(most >= 4096);
  CHECK_THROWS_AS(device->create_texture(Format::R32F, 0, 1), Error);
  CHECK_THROWS_AS(device->create_texture(Format::R32F, 1, most + 1), Error);
  CHECK_THROWS_AS(device->read_back(static_cast<TextureId>(99)), Error);
  MeshData mesh{.layout = {{"position", 1}}, .vertices = {1.0f}, .indices = {1}};
  CHECK_THROWS_AS(device->create_mesh(mesh), Error);
  mesh.indices = {0};
  const MeshId one = device->create_mesh(mesh);
  const DeviceObjects made = device->made();
  mesh.vertices = {2.0f};
  CHECK_NOTHROW(device->update(one, mesh));
  CHECK(device->made() == made);
  mesh.vertices = {2.0f, 3.0f};
  CHECK_THROWS_AS(device->update(one, mesh), Error);
  CHECK_THROWS_AS(device->update(static_cast<MeshId>(99), mesh), Error);
  const TextureId texture = device->create_texture(Format::R32F, most, 1);
  device->destroy(texture);
  CHECK_THROWS_AS(device->shape(texture), Error);
}

TEST_CASE("gl: a shader that OpenGL refuses gives one line with its name, stage and line") {
  const auto device = gl_or_skip();
  static const Shader kBad{"broken",
                           "OUTPUT(0, Vec4, color)\n"
                           "#ifdef VERTEX_STAGE\nvoid main() { set_position(Vec4(0.0f)); }\n"
                           "#else\nvoid main() { color = undeclared; }\n#endif\n",
                           {}};
  RasterBench b;
  b.definition.shader = &kBad;
  b.definition.name = "bad_pass";
  b.on = device.get();
  try {
    b.draw({b.at(0, 0)});
    FAIL("it was accepted");
  } catch (const Error& error) {
    const std::string line = error.what();
    CHECK(error.code() == ExitCode::InternalError);
    CHECK(line.find("'broken' (fragment stage)") != std::string::npos);
    CHECK(line.find("undeclared") != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
  }
  // The device is as good as before.
  b.definition.shader = &raster_probe_shader;
  CHECK(RasterBench::sum(b.draw({b.at(0, 0), b.at(16, 0), b.at(0, 16)})[0]) == 64.0);
}

TEST_CASE("gl: OpenGL takes every form that the rewriting to precise gives a text") {
  const auto device = gl_or_skip();
  static const Shader kForms{
      "forms",
      "OUTPUT(0, Vec4, color)\n"
      "struct Pair { Float a; Vec2 b; };\n"
      "const int kThree = 3;\n"
      "#ifdef VERTEX_STAGE\n"
      "void main() { set_position(Vec4(vertex_id() == 1 ? 3.0f : -1.0f, vertex_id() == 2 ? 3.0f : -1.0f, "
      "0.5f, 1.0f)); }\n"
      "#else\n"
      "Pair pair_of(Float a, mat4 m, const Int n) { Pair p; p.a = a * 2.0f; p.b = Vec2(m[0].x, Float(n)); "
      "return p; }\n"
      "Bool grows(Pair p) { if (p.a * p.a > p.a) return p.b.x < p.b.y; else return false; }\n"
      "Int count(INOUT(Float) x) { const float step = 1.5f; Int n = 0; while (x * step < 10.0f) { x *= step; "
      "n++; } return n; }\n"
      "void twice(OUT(Vec3) v, Float x) { Float both[2]; both[0] = x; both[1] = x + x; v = Vec3(both[1]); "
      "return; }\n"
      "void main() {\n"
      "  Float x = 1.0f, y = 0.0f;\n"
      "  for (float i = 0.0f; i + 0.5f < float(kThree); i += 1.0f) y += i;\n"
      "  Pair p = pair_of(x + y, mat4(1.0f), 2);\n"
      "  Vec3 v;\n"
      "  twice(v, y);\n"
      "  discard_if(p.a + v.x < 0.0f);\n"
      "  color = Vec4(p.a, Float(count(x)), v.z, sel(grows(p), Float(1.0f), Float(0.0f)));\n"
      "}\n"
      "#endif\n",
      {}};
  const PassDefinition definition{
      .name = "forms", .purpose = "test", .writes = {{.name = "color", .meaning = "m"}}, .shader = &kForms};
  const TextureId target = device->create_texture(Format::RGBA32F, 1, 1);
  device->run({.definition = &definition, .colors = {target}, .draws = {{.vertex_count = 3}}});
  CHECK(device->read_back(target).values == std::vector<float>{8.0f, 5.0f, 6.0f, 1.0f});
}

TEST_CASE("gl: a device that does not exist is a missing backend, told in one line") {
  for (const int index : {77, -5}) {
    try {
      make_gl_device({.device = index});
      FAIL("there is one");
    } catch (const Error& error) {
      CHECK(error.code() == ExitCode::BackendUnavailable);
      const std::string line = error.what();
      CHECK(line.find("--backend software") != std::string::npos);
      CHECK(line.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("gl: every listed device either works or says why not, and two live side by side") {
  const auto first = gl_or_skip();
  const std::vector<GlDeviceInfo> devices = list_gl_devices();
  REQUIRE(!devices.empty());
  const Image image = numbered(Format::RGBA8, 3, 3);
  const TextureId kept = first->upload(image);
  for (const GlDeviceInfo& info : devices) {
    INFO(info.platform << ": " << info.reason);
    CHECK(info.reason.empty() == !info.renderer.empty());
    if (!info.reason.empty()) continue;
    const auto second = make_gl_device({.device = info.index});
    CHECK(second->renderer() == info.renderer);
    const TextureId other = second->upload(numbered(Format::R32F, 2, 2));
    CHECK(first->read_back(kept).values == image.values);
    CHECK(second->read_back(other).values == numbered(Format::R32F, 2, 2).values);
  }
  CHECK(first->read_back(kept).values == image.values);
}
