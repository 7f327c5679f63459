// Both devices, drawing the same, and what they disagreed on so far.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "gl_backend/gl_driver.hpp"
#include "pipeline/gpu/allowance.hpp"
#include "raster/software_device.hpp"
#include "tests/gl/gl_or_skip.hpp"
#include "tests/parity/torture.hpp"

namespace caustics::test {

class Match {
 public:
  explicit Match(std::vector<Allowance> allowances = {})
      : gl_(gl_or_skip()),
        software_(make_software_device()),
        driver_(gl_driver_name(gl_->renderer(), gl_->version())),
        book_(driver_, std::move(allowances)) {}

  // Are this driver's differences known? On others they are only shown.
  bool measured() const { return is_measured_driver(driver_); }

  // `classes` names each attachment, depth last, for the allowances; empty: there are none.
  void compare(const TortureCase& c, const std::vector<std::string>& classes = {}) {
    const TortureResult a = draw(*software_, c), b = draw(*gl_, c);
    for (std::size_t i = 0; i < a.images.size(); ++i) {
      const ImageDifference d = difference(a.images[i], b.images[i]);
      values_ += d.all.values;
      if (d.all.differing == 0) continue;
      const std::string name = i < classes.size() ? classes[i] : "";
      if (book_.covers("torture", name, d)) continue;
      differing_ += d.all.differing;
      if (first_.empty()) first_ = describe(i, name, c, d);
    }
    fragments_ += a.counts.fragments;
    if (!same_counts(c, a.counts, b.counts) && miscounted_.empty())
      miscounted_ = count_text(a.counts) + " | " + count_text(b.counts);
    ++draws_;
  }

  // Call once, at the end.
  void finish() const {
    CHECK(fragments_ > 1000);  // something was drawn
    const std::string result = driver_ + ": " + std::to_string(differing_) + " of " +
                               std::to_string(values_) + " values differ in " + std::to_string(draws_) +
                               " draws; " + first_ + " " + miscounted_;
    if (!measured()) {
      WARN("not measured: " << result);
      return;
    }
    INFO(result);
    CHECK(differing_ == 0);
    CHECK(miscounted_ == "");
  }

  // Every allowance for this driver was needed.
  void expect_all_needed() const {
    for (const Allowance& a : book_.unused()) {
      INFO("no longer needed on " << a.driver << ": " << a.attachment);
      CHECK(a.attachment == "");
    }
  }

 private:
  static bool same_counts(const TortureCase& c, const PassResult& a, const PassResult& b) {
    return a.vertices == b.vertices && a.primitives == b.primitives &&
           (!c.definition.count_samples || a.samples_passed == b.samples_passed);
  }

  std::string describe(std::size_t image, const std::string& name, const TortureCase& c,
                       const ImageDifference& d) const {
    const ValuePair& first = *d.all.first;
    return "draw " + std::to_string(draws_) + ", attachment " + std::to_string(image) + " (" + name +
           ") of " + std::to_string(c.width) + "x" + std::to_string(c.height) + ": " +
           std::to_string(d.differing_texels) + " texels by " + std::to_string(d.all.absolute.largest) +
           " at most, first at " + std::to_string(first.x) + "," + std::to_string(first.y) + " channel " +
           std::to_string(first.channel) + ": software " + std::to_string(first.a) + ", gl " +
           std::to_string(first.b);
  }

  static std::string count_text(const PassResult& r) {
    return std::to_string(r.vertices) + " vertices, " + std::to_string(r.primitives) + " primitives, " +
           std::to_string(r.samples_passed) + " samples";
  }

  std::unique_ptr<GlDevice> gl_;
  std::unique_ptr<Device> software_;
  std::string driver_, first_, miscounted_;
  AllowanceBook book_;
  std::size_t values_ = 0, differing_ = 0, draws_ = 0;
  std::uint64_t fragments_ = 0;
};

}  // namespace caustics::test
