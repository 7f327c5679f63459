// Both devices, drawing the same, and what they disagreed on so far, judged by the driver's class.
#pragma once
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "gl_backend/gl_probe.hpp"
#include "raster/software_device.hpp"
#include "tests/gl/gl_or_skip.hpp"
#include "tests/parity/blend_allowances.hpp"
#include "tests/parity/torture.hpp"

namespace caustics::test {

class Match {
 public:
  explicit Match(const GlOptions& options = {.measure = true, .debug = true})
      : gl_(gl_or_skip(options)), software_(make_software_device()), driver_(driver_class(*gl_)) {}

  // Must every value be the same? Elsewhere what is not finite, and blending that a driver may do in its own
  // way, are left out, for a single texel on an edge would decide.
  bool exact() const { return driver_ == DriverClass::LlvmpipeFused; }

  // `states` names what is special about each attachment's blending (blend_class); empty: nothing.
  void compare(TortureCase c, const std::vector<std::string>& states = {}) {
    if (!exact() && c.definition.topology == Topology::Points) std::erase_if(c.vertices, off_target);
    const TortureResult a = draw(*software_, c), b = draw(*gl_, c);
    for (std::size_t i = 0; i < a.images.size(); ++i)
      add(difference(a.images[i], b.images[i]), c, i, i < states.size() ? states[i] : "");
    fragments_ += a.counts.fragments;
    samples_ += a.counts.samples_passed;
    samples_of_gl_ += b.counts.samples_passed;
    const bool counts_all = exact() && c.definition.count_samples;
    if ((a.counts.vertices != b.counts.vertices || a.counts.primitives != b.counts.primitives ||
         (counts_all && a.counts.samples_passed != b.counts.samples_passed)) &&
        miscounted_.empty())
      miscounted_ = count_text(a.counts) + " | " + count_text(b.counts);
    ++draws_;
  }

  // Call once, at the end.
  void finish() const {
    CHECK(fragments_ > 1000);  // something was drawn
    const ParityVerdict verdict = judge(sum_, ImageKind::RandomDraws, driver_);
    std::string found;
    for (const BoundCheck& check : verdict.checks)
      found += ", " + std::string(name_of(check.bound->measure)) + " " + scientific(check.found) + " of " +
               scientific(check.most);
    INFO(name_of(driver_) << ": " << sum_.all.differing << " of " << sum_.all.values << " values differ in "
                          << draws_ << " draws" << found << "; " << first_);
    CHECK(verdict.verdict != Verdict::Beyond);
    CHECK(samples_agree(samples_, samples_of_gl_, driver_));
    CHECK(miscounted_ == "");
  }

  // Every allowance was needed.
  void expect_all_needed() const {
    if (!exact()) return;
    for (const BlendAllowance& allowance : blend_allowances()) {
      INFO("no longer needed: " << allowance.name);
      CHECK(needed_.count(allowance.name) == 1);
    }
  }

 private:
  // Passes draw no points with a centre there, for drivers clip them otherwise.
  static bool off_target(const TortureVertex& v) {
    return !(std::fabs(v.x) <= v.w && std::fabs(v.y) <= v.w && v.z >= 0.0f && v.z <= v.w);
  }

  void add(const ImageDifference& d, const TortureCase& c, std::size_t image, const std::string& state) {
    if (!exact() && !state.empty()) return;
    sum_.all.values += d.all.values;
    for (const BlendAllowance& allowance : blend_allowances()) {
      if (allowance.name != state || d.all.differing == 0 || !covers(allowance, d)) continue;
      needed_.insert(state);
      return;
    }
    if (d.all.differing > 0 && first_.empty()) first_ = describe(image, state, c, d);
    sum_.all.differing += d.all.differing;
    sum_.all.nan_only_a += d.all.nan_only_a;
    sum_.all.nan_only_b += d.all.nan_only_b;
    sum_.all.infinite += d.all.infinite;
    sum_.texels += d.texels;
    sum_.covered += d.covered;
    sum_.coverage_mismatches += d.coverage_mismatches;
    sum_.jumps += d.jumps;
    sum_.steady.magnitude += d.steady.magnitude;
    sum_.steady.difference += d.steady.difference;
    sum_.same_shape = true;
  }

  std::string describe(std::size_t image, const std::string& state, const TortureCase& c,
                       const ImageDifference& d) const {
    const ValuePair& first = *d.all.first;
    return "draw " + std::to_string(draws_) + ", attachment " + std::to_string(image) + " (" + state +
           ") of " + std::to_string(c.width) + "x" + std::to_string(c.height) + ": " +
           std::to_string(d.differing_texels) + " texels by " + std::to_string(d.all.absolute.largest) +
           " at most, first at " + std::to_string(first.x) + "," + std::to_string(first.y) + " channel " +
           std::to_string(first.channel) + ": software " + std::to_string(first.a) + ", gl " +
           std::to_string(first.b);
  }

  static std::string scientific(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
  }

  static std::string count_text(const PassResult& r) {
    return std::to_string(r.vertices) + " vertices, " + std::to_string(r.primitives) + " primitives, " +
           std::to_string(r.samples_passed) + " samples";
  }

  std::unique_ptr<GlDevice> gl_;
  std::unique_ptr<Device> software_;
  DriverClass driver_ = DriverClass::LlvmpipeFused;
  std::string first_, miscounted_;
  std::set<std::string> needed_;
  ImageDifference sum_;
  std::size_t draws_ = 0;
  std::uint64_t fragments_ = 0, samples_ = 0, samples_of_gl_ = 0;
};

}  // namespace caustics::test
