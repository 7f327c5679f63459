// The bounds of every class of drivers, held against differences that are made for them.
#include "pipeline/gpu/parity_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

constexpr int kSide = 500;
constexpr DriverClass kClasses[] = {DriverClass::LlvmpipeFused,       DriverClass::LlvmpipeOtherPoints,
                                    DriverClass::LlvmpipeUnfused,     DriverClass::Hardware,
                                    DriverClass::ContractingHardware, DriverClass::FourSubpixelBits};
static_assert(std::size(kClasses) == kDriverClasses);
constexpr ImageKind kKinds[] = {ImageKind::Shading, ImageKind::RasterizedMap, ImageKind::Samples,
                                ImageKind::FluxMap, ImageKind::Intermediate,  ImageKind::Beauty,
                                ImageKind::Picture, ImageKind::RandomDraws};
static_assert(std::size(kKinds) == kImageKinds);

// A quarter of a million covered texels between 1 and 2.
Image drawn() {
  Image image(Format::R32F, kSide, kSide);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = 1.0f + static_cast<float>(i % 1000) / 1000.0f;
  return image;
}

// Every texel off by this share of itself, up and down in turn, so that the sum stays.
void scale_all(Image& image, double share) {
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] *= static_cast<float>(1.0 + ((i / 1000) % 2 ? share : -share));
}

// A share of all texels, the first ones, changed by `change`.
template <class Change>
void change_share(Image& image, double share, Change change) {
  const auto count = static_cast<std::size_t>(std::floor(share * static_cast<double>(image.values.size())));
  for (std::size_t i = 0; i < count; ++i) image.values[i] = change(image.values[i]);
}

// A picture with a fault of about this size in one measure.
Image faulty(Measure measure, double size) {
  Image image = drawn();
  switch (measure) {
    case Measure::Coverage:
      change_share(image, size, [](float) { return 0.0f; });
      break;
    case Measure::Jumps:
      change_share(image, size, [](float v) { return v * 1.02f; });
      break;
    case Measure::RelativeL1:
      // Of what may not jump, everywhere; of the rest, where few texels can hold it too.
      scale_all(image, size);
      break;
    case Measure::TotalFlux:
      for (float& v : image.values) v *= static_cast<float>(1.0 + size);
      break;
    case Measure::P999:
      // Of the larger magnitude: a value and its opposite are 2 apart.
      change_share(image, 0.0015, [&](float v) { return static_cast<float>(v * (1.0 - size)); });
      break;
    case Measure::BeyondAStep:
      change_share(image, size, [](float v) { return v + 2.0f / 255.0f; });
      break;
  }
  return image;
}

ParityVerdict judged(const ParityBound& bound, DriverClass driver, double size) {
  // Only this bound: a fault that is made for one measure shows in others too.
  return judge(difference(drawn(), faulty(bound.measure, size)), bound.kind, driver, {&bound, 1});
}

}  // namespace

TEST_CASE("parity bounds: in every class a fault of twice each bound is noticed, what is within passes") {
  int planted = 0;
  for (const ParityBound& bound : parity_bounds())
    for (const DriverClass driver : kClasses) {
      const double most = bound.most[static_cast<std::size_t>(driver)];
      INFO(name_of(driver) << ", " << name_of(bound.kind) << ", " << name_of(bound.measure) << ": " << most);
      ++planted;
      if (most == 0.0) {
        Image one = drawn();
        one.values[7] = std::nextafter(one.values[7], 9.0f);
        CHECK(judge(difference(drawn(), one), bound.kind, driver, {&bound, 1}).verdict == Verdict::Beyond);
        continue;
      }
      CHECK(judged(bound, driver, 0.8 * most).verdict == Verdict::Within);
      // Nothing is further apart than 2 of a value.
      const double twice = bound.measure == Measure::P999 ? std::min(2.0 * most, 1.99) : 2.0 * most;
      CHECK(judged(bound, driver, twice).verdict == Verdict::Beyond);
    }
  CHECK(planted >= 60);
}

TEST_CASE("parity bounds: equal images are equal in every class, whatever they hold") {
  for (const ImageKind kind : kKinds)
    for (const DriverClass driver : kClasses) {
      const ParityVerdict verdict = judge(difference(drawn(), drawn()), kind, driver);
      CHECK(verdict.verdict == Verdict::Equal);
      CHECK(verdict.reason == "");
    }
}

TEST_CASE("parity bounds: llvmpipe that draws as the software device may differ in no value") {
  for (const ParityBound& bound : parity_bounds())
    CHECK(bound.most[static_cast<std::size_t>(DriverClass::LlvmpipeFused)] == 0.0);
}

TEST_CASE("parity bounds: each has a cause, and none is as wide as all that can be found") {
  for (const ParityBound& bound : parity_bounds()) {
    INFO(name_of(bound.kind) << ", " << name_of(bound.measure));
    CHECK(bound.cause.size() > 20);
    // A relative difference reaches 2, all others are shares.
    for (const double most : bound.most) CHECK(most < (bound.measure == Measure::P999 ? 2.0 : 0.5));
  }
}

TEST_CASE("parity bounds: a NaN, an infinity, another shape, no bound or no cause is beyond in every class") {
  Image nan = drawn(), infinite = drawn();
  nan.values[3] = std::numeric_limits<float>::quiet_NaN();
  infinite.values[3] = std::numeric_limits<float>::infinity();
  ParityBound nameless = parity_bounds().front();
  nameless.cause = "";
  for (const DriverClass driver : kClasses)
    for (const ImageKind kind : kKinds) {
      const auto reason = [&](const Image& a, const Image& b) {
        const ParityVerdict verdict = judge(difference(a, b), kind, driver);
        CHECK(verdict.verdict == Verdict::Beyond);
        return verdict.reason;
      };
      CHECK(reason(nan, drawn()) == "a NaN on one side alone");
      CHECK(reason(drawn(), nan) == "a NaN on one side alone");
      CHECK(reason(drawn(), infinite) == "an infinity on one side alone");
      CHECK(reason(drawn(), Image(Format::R32F, kSide, 1)) == "another size or format");
      CHECK(judge(difference(nan, nan), kind, driver).verdict == Verdict::Equal);
      CHECK(judge(difference(drawn(), drawn()), kind, driver, {}).verdict == Verdict::Beyond);
      nameless.kind = kind;
      const ParityVerdict verdict = judge(difference(drawn(), drawn()), kind, driver, {&nameless, 1});
      CHECK(verdict.reason == "a bound without a cause");
    }
}

TEST_CASE("parity bounds: one texel on an edge is never too many where edges may differ") {
  Image a(Format::R32F, 4, 1), b(Format::R32F, 4, 1);
  a.values = {1, 2, 3, 0};
  b.values = {1, 2, 3, 4};
  const auto verdict = [&](DriverClass driver) {
    return judge(difference(a, b), ImageKind::RasterizedMap, driver).verdict;
  };
  CHECK(verdict(DriverClass::Hardware) == Verdict::Within);
  CHECK(verdict(DriverClass::LlvmpipeFused) == Verdict::Beyond);
  b.values[0] = 0;
  CHECK(verdict(DriverClass::Hardware) == Verdict::Beyond);
}

TEST_CASE("parity bounds: samples that passed agree as coverage does") {
  CHECK(samples_agree(1000000, 1000000, DriverClass::LlvmpipeFused));
  CHECK_FALSE(samples_agree(1000000, 1000001, DriverClass::LlvmpipeFused));
  CHECK(samples_agree(1000000, 999000, DriverClass::LlvmpipeUnfused));
  CHECK(samples_agree(10, 11, DriverClass::Hardware));
  CHECK_FALSE(samples_agree(10, 12, DriverClass::Hardware));
  CHECK_FALSE(samples_agree(0, 1, DriverClass::FourSubpixelBits));
}
