// Random draws on both devices. On the drivers of docs/parity.md not one value differs; on others the
// differences are shown. One line repeats a test: caustics_tests "torture: slivers".
#include "gl_backend/gl_driver.hpp"
#include "pipeline/gpu/difference.hpp"
#include "raster/software_device.hpp"
#include "tests/gl/gl_or_skip.hpp"
#include "tests/parity/torture.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Both devices, and what they disagreed on so far.
class Match {
 public:
  Match() : gl_(gl_or_skip()), software_(make_software_device()) {
    if (gl_) driver_ = gl_driver_name(gl_->renderer(), gl_->version());
  }
  explicit operator bool() const { return gl_ != nullptr; }

  void compare(const TortureCase& c) {
    const TortureResult a = draw(*software_, c), b = draw(*gl_, c);
    for (std::size_t i = 0; i < a.images.size(); ++i) {
      const ImageDifference d = difference(a.images[i], b.images[i]);
      values_ += d.all.values;
      differing_ += d.all.differing;
      if (d.all.differing > 0 && first_.empty()) first_ = describe(i, c, d);
    }
    fragments_ += a.counts.fragments;
    const bool counted = a.counts.vertices == b.counts.vertices &&
                         a.counts.primitives == b.counts.primitives &&
                         (!c.definition.count_samples ||
                          a.counts.samples_passed == b.counts.samples_passed);
    if (!counted && miscounted_.empty()) miscounted_ = count_text(a.counts, b.counts);
    ++draws_;
  }

  // Call once, at the end.
  void finish() const {
    CHECK(fragments_ > 1000);  // something was drawn
    INFO(driver_ << ": " << differing_ << " of " << values_ << " values differ in " << draws_
                 << " draws; " << first_ << " " << miscounted_);
    if (is_measured_driver(driver_)) {
      CHECK(differing_ == 0);
      CHECK(miscounted_ == "");
    } else {
      WARN("not measured, " << driver_ << ": " << differing_ << " of " << values_
                            << " values differ in " << draws_ << " draws; " << first_ << " "
                            << miscounted_);
    }
  }

 private:
  std::string describe(std::size_t image, const TortureCase& c, const ImageDifference& d) const {
    return "draw " + std::to_string(draws_) + ", attachment " + std::to_string(image) + " of " +
           std::to_string(c.width) + "x" + std::to_string(c.height) + ": " +
           std::to_string(d.differing_texels) + " texels, first at " + std::to_string(d.all.first->x) +
           "," + std::to_string(d.all.first->y) + " channel " + std::to_string(d.all.first->channel) +
           ": software " + std::to_string(d.all.first->a) + ", gl " + std::to_string(d.all.first->b) +
           ", at most " + std::to_string(d.all.ulps.largest) + " ulps";
  }
  static std::string count_text(const PassResult& a, const PassResult& b) {
    const auto text = [](const PassResult& r) {
      return std::to_string(r.vertices) + " vertices, " + std::to_string(r.primitives) +
             " primitives, " + std::to_string(r.samples_passed) + " samples";
    };
    return "software " + text(a) + "; gl " + text(b);
  }

  std::unique_ptr<GlDevice> gl_;
  std::unique_ptr<Device> software_;
  std::string driver_, first_, miscounted_;
  std::size_t values_ = 0, differing_ = 0, draws_ = 0;
  std::uint64_t fragments_ = 0;
};

struct Size {
  int width, height;
};
// Powers of two, where the viewport's arithmetic is exact, and others, where it is not.
constexpr Size kSizes[] = {{256, 256}, {240, 180}, {333, 97}, {61, 512}, {1, 1}, {640, 360}};

void torture_triangles(const std::string& name, const TriangleMaker& maker, int triangles = 300,
                       Painter paint = random_color) {
  Match match;
  if (!match) return;
  Random random(name);
  for (const Size& size : kSizes)
    for (int i = 0; i < 4; ++i) {
      TortureCase c = plain_case(Topology::Triangles, size.width, size.height);
      // Every fragment counts in half of the draws: sums show what a depth test hides.
      if (i % 2 == 1) {
        for (ColorWrite& write : c.definition.writes) write.blend = kAccumulate;
        c.definition.depth_state = {};
        c.definition.depth.reset();
      }
      c.vertices = random_triangles(random, triangles, size.width, size.height, maker, paint);
      match.compare(c);
    }
  match.finish();
}

void torture_points(const std::string& name, float largest, int points, Painter paint = random_color) {
  Match match;
  if (!match) return;
  Random random(name);
  for (const Size& size : kSizes)
    for (int i = 0; i < 4; ++i) {
      TortureCase c = plain_case(Topology::Points, size.width, size.height);
      if (i % 2 == 1) {
        for (ColorWrite& write : c.definition.writes) write.blend = kAccumulate;
        c.definition.depth_state = {};
        c.definition.depth.reset();
      }
      c.vertices = random_points(random, points, largest, paint);
      match.compare(c);
    }
  match.finish();
}

template <class T, std::size_t N>
T pick(Random& random, const T (&choices)[N]) {
  return choices[random.below(static_cast<int>(N))];
}

BlendState random_blend(Random& random) {
  BlendState blend{.enabled = !random.one_in(3)};
  blend.equation = pick(random, {BlendEquation::Add, BlendEquation::Min, BlendEquation::Max});
  const BlendFactor factors[] = {BlendFactor::Zero,        BlendFactor::One,
                                 BlendFactor::SourceColor, BlendFactor::SourceAlpha,
                                 BlendFactor::OneMinusSourceAlpha, BlendFactor::DestinationColor};
  blend.source = pick(random, factors);
  blend.destination = pick(random, factors);
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
  const Format formats[] = {Format::R32F, Format::RG32F, Format::RGBA32F, Format::RGBA16F,
                            Format::RGBA8};
  for (ColorWrite& write : c.definition.writes) {
    write.format = pick(random, formats);
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
  const TriangleMaker makers[] = {torture::large, torture::perspective, torture::medium,
                                  torture::aligned, torture::off_screen};
  c.vertices = topology == Topology::Points
                   ? random_points(random, 200, 64.0f)
                   : random_triangles(random, 100, size.width, size.height, pick(random, makers));
  return c;
}

}  // namespace

TEST_CASE("torture: large triangles") { torture_triangles("large", torture::large); }
TEST_CASE("torture: triangles in perspective") {
  torture_triangles("perspective", torture::perspective);
}
TEST_CASE("torture: tiny triangles") { torture_triangles("tiny", torture::tiny, 3000); }
TEST_CASE("torture: triangles of some pixels") { torture_triangles("medium", torture::medium, 3000); }
TEST_CASE("torture: slivers") { torture_triangles("slivers", torture::sliver, 1000); }
TEST_CASE("torture: corners on pixel centres and borders") {
  torture_triangles("aligned", torture::aligned);
}
TEST_CASE("torture: degenerate triangles") {
  torture_triangles("degenerate", [](Random& r, int w, int h, TortureVertex (&c)[3]) {
    r.one_in(2) ? torture::degenerate(r, w, h, c) : torture::large(r, w, h, c);
  });
}
TEST_CASE("torture: triangles far off the target") {
  torture_triangles("off-screen", torture::off_screen);
}
TEST_CASE("torture: triangles through the near and the far plane") {
  torture_triangles("near and far", torture::near_and_far);
}
TEST_CASE("torture: triangles with corners behind the eye") {
  torture_triangles("behind", torture::behind_the_eye);
}
TEST_CASE("torture: positions that are NaN or infinite") {
  torture_triangles("non-finite positions", torture::non_finite_position);
}
TEST_CASE("torture: colours that are denormal, huge or between two stored values") {
  torture_triangles("odd colours", torture::large, 100, odd_color);
}
TEST_CASE("torture: colours that are NaN or infinite") {
  torture_triangles("non-finite colours", torture::large, 20, non_finite_color);
}

TEST_CASE("torture: shared edges") {
  Match match;
  if (!match) return;
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
  if (!match) return;
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
  if (!match) return;
  Random random("states");
  for (int i = 0; i < 400; ++i) match.compare(random_state(random));
  match.finish();
}
