// Random draws on both devices, judged by the driver's class: on llvmpipe with fused multiply-add not one
// value differs. One line repeats a test: caustics_tests "torture: slivers".
#include "tests/parity/match.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

struct Size {
  int width, height;
};
// Powers of two, where the viewport's arithmetic is exact, and others, where it is not.
constexpr Size kSizes[] = {{256, 256}, {240, 180}, {333, 97}, {61, 512}, {1, 1}, {640, 360}};

// What is not finite, or becomes so in triangles without an area, on drivers that cover or round otherwise:
// there one side alone has it.
void skip_unless_judged(const Match& match, bool finite) {
  if (!finite && !match.exact()) skip("only a driver that covers the same texels can be judged");
}

// Four draws in every size; `make` gives the vertices of each.
template <class Make>
void torture_draws(const std::string& name, Topology topology, bool finite, const Make& make) {
  Match match;
  skip_unless_judged(match, finite);
  Random random(name);
  for (const Size& size : kSizes)
    for (int i = 0; i < 4; ++i) {
      TortureCase c = plain_case(topology, size.width, size.height);
      // Every fragment counts in half of the draws: sums show what a depth test hides.
      if (i % 2 == 1) {
        for (ColorWrite& write : c.definition.writes) write.blend = kAccumulate;
        c.definition.depth_state = {};
        c.definition.depth.reset();
      }
      c.vertices = make(random, size);
      match.compare(c);
    }
  match.finish();
}

void torture_triangles(const std::string& name, const TriangleMaker& maker, int triangles = 300,
                       Painter paint = random_color, bool finite = true) {
  torture_draws(name, Topology::Triangles, finite, [&](Random& random, const Size& size) {
    return random_triangles(random, triangles, size.width, size.height, maker, paint);
  });
}

void torture_points(const std::string& name, float largest, int points, Painter paint = random_color) {
  torture_draws(name, Topology::Points, true,
                [&](Random& random, const Size&) { return random_points(random, points, largest, paint); });
}

template <class T, std::size_t N>
T pick(Random& random, const T (&choices)[N]) {
  return choices[random.below(static_cast<int>(N))];
}

constexpr Format kFormats[] = {Format::R32F, Format::RG32F, Format::RGBA32F, Format::RGBA16F, Format::RGBA8};
constexpr BlendFactor kFactors[] = {BlendFactor::Zero,
                                    BlendFactor::One,
                                    BlendFactor::SourceColor,
                                    BlendFactor::SourceAlpha,
                                    BlendFactor::OneMinusSourceAlpha,
                                    BlendFactor::DestinationColor};

// From 0 to 1, so that sums of products stay small.
void unit_color(Random& random, TortureVertex& v) {
  for (float& c : v.color) c = random.between(0.0f, 1.0f);
}

BlendState random_blend(Random& random) {
  BlendState blend{.enabled = !random.one_in(3)};
  blend.equation = pick(random, {BlendEquation::Add, BlendEquation::Min, BlendEquation::Max});
  blend.source = pick(random, kFactors);
  blend.destination = pick(random, kFactors);
  return blend;
}

Image random_image(Random& random, Format format, int width, int height) {
  Image image(format, width, height);
  for (float& v : image.values) v = stored_value(format, random.between(0.0f, 1.0f));
  return image;
}

TortureCase random_state(Random& random) {
  const Size size = pick(random, kSizes);
  const Topology topology = random.one_in(3) ? Topology::Points : Topology::Triangles;
  TortureCase c = plain_case(topology, size.width, size.height);
  for (ColorWrite& write : c.definition.writes) {
    write.format = pick(random, kFormats);
    write.blend = random_blend(random);
    for (bool& channel : write.mask) channel = !random.one_in(5);
    for (float& v : write.clear) v = random.between(0.0f, 1.0f);
  }
  const Compare compares[] = {Compare::Always,  Compare::Less,         Compare::LessEqual,
                              Compare::Greater, Compare::GreaterEqual, Compare::Equal};
  c.definition.depth_state = {pick(random, compares), !random.one_in(3)};
  c.definition.depth->clear = random.between(0.0f, 1.0f);
  c.definition.cull = pick(random, {Cull::None, Cull::Back, Cull::Front});
  if (random.one_in(3)) c.discard_below = random.between(-0.2f, 0.8f);
  for (std::size_t i = 0; i < 3; ++i) {
    const Format format = i < 2 ? c.definition.writes[i].format : Format::Depth32F;
    c.keep.push_back(random.one_in(3));
    c.before.push_back(random_image(random, format, size.width, size.height));
  }
  const TriangleMaker makers[] = {torture::large, torture::perspective, torture::medium, torture::aligned,
                                  torture::off_screen};
  c.vertices = topology == Topology::Points
                   ? random_points(random, 200, 64.0f, unit_color)
                   : random_triangles(random, 100, size.width, size.height, pick(random, makers), unit_color);
  return c;
}

}  // namespace

TEST_CASE("torture: large triangles") { torture_triangles("large", torture::large); }
TEST_CASE("torture: triangles in perspective") { torture_triangles("perspective", torture::perspective); }
TEST_CASE("torture: tiny triangles") { torture_triangles("tiny", torture::tiny, 3000); }
TEST_CASE("torture: triangles of some pixels") { torture_triangles("medium", torture::medium, 3000); }
TEST_CASE("torture: slivers") { torture_triangles("slivers", torture::sliver, 1000); }
TEST_CASE("torture: corners on pixel centres and borders") { torture_triangles("aligned", torture::aligned); }
TEST_CASE("torture: degenerate triangles") {
  torture_triangles(
      "degenerate",
      [](Random& r, int w, int h, TortureVertex(&c)[3]) {
        r.one_in(2) ? torture::degenerate(r, w, h, c) : torture::large(r, w, h, c);
      },
      300, random_color, false);
}
TEST_CASE("torture: triangles far off the target") { torture_triangles("off-screen", torture::off_screen); }
TEST_CASE("torture: triangles through the near and the far plane") {
  torture_triangles("near and far", torture::near_and_far);
}
TEST_CASE("torture: triangles with corners behind the eye") {
  torture_triangles("behind", torture::behind_the_eye);
}
TEST_CASE("torture: positions that are NaN or infinite") {
  torture_triangles("non-finite positions", torture::non_finite_position, 300, random_color, false);
}
TEST_CASE("torture: colours that are denormal, huge or between two stored values") {
  torture_triangles("odd colours", torture::large, 100, odd_color, false);
}
TEST_CASE("torture: colours that are NaN or infinite") {
  torture_triangles("non-finite colours", torture::large, 20, non_finite_color, false);
}

TEST_CASE("torture: shared edges") {
  Match match;
  Random random("shared edges");
  for (const Size& size : kSizes)
    for (const int cells : {1, 7, 40}) {
      TortureCase c = plain_case(Topology::Triangles, size.width, size.height);
      for (ColorWrite& write : c.definition.writes) write.blend = kAccumulate;
      c.definition.depth_state = {};
      c.vertices = shared_edges(random, cells);
      match.compare(c);
    }
  match.finish();
}

TEST_CASE("torture: points of every size") { torture_points("points", 64.0f, 1000); }
TEST_CASE("torture: small points") { torture_points("small points", 6.0f, 10000); }
TEST_CASE("torture: points whose colours are denormal, huge or between two stored values") {
  torture_points("odd points", 16.0f, 500, odd_color);
}
TEST_CASE("torture: points at NaN and infinite places") {
  Match match;
  skip_unless_judged(match, false);
  Random random("non-finite points");
  for (const Size& size : kSizes) {
    TortureCase c = plain_case(Topology::Points, size.width, size.height);
    c.vertices = random_points(random, 1000, 16.0f);
    for (TortureVertex& v : c.vertices) {
      float* const coordinates[5] = {&v.x, &v.y, &v.z, &v.w, &v.w};
      if (random.one_in(5)) *coordinates[random.below(4)] = torture::not_finite(random);
      if (random.one_in(9)) v.w = -v.w;
    }
    match.compare(c);
  }
  match.finish();
}

TEST_CASE("torture: combinations of formats, blending, depth, culling, masks and discarding") {
  Match match;
  Random random("states");
  for (int i = 0; i < 400; ++i) {
    const TortureCase c = random_state(random);
    match.compare(c, {blend_class(c.definition.writes[0]), blend_class(c.definition.writes[1]), ""});
  }
  match.finish();
}

TEST_CASE("torture: every blend equation and factor in every format, and no allowance in vain") {
  Match match;
  Random random("blending");
  for (const Format format : kFormats)
    for (const BlendEquation equation : {BlendEquation::Add, BlendEquation::Min, BlendEquation::Max})
      for (const BlendFactor source : kFactors)
        for (const BlendFactor destination : kFactors) {
          TortureCase c = plain_case(Topology::Triangles, 48, 32);
          c.definition.depth_state = {};
          c.definition.depth.reset();
          for (ColorWrite& write : c.definition.writes) {
            write.format = format;
            write.blend = {true, equation, source, destination};
            write.clear = {0.25f, 0.5f, 0.75f, 1.0f};
          }
          c.vertices = random_triangles(random, 12, 48, 32, torture::large, unit_color);
          const std::string name = blend_class(c.definition.writes[0]);
          match.compare(c, {name, name});
        }
  match.finish();
  match.expect_all_needed();
}
