// What an OpenGL driver that was measured may differ by from the software device: data, each entry
// with its reason. A driver that nobody measured has none; its differences are reported as they
// are.
#pragma once
#include <string>
#include <vector>

#include "pipeline/gpu/difference.hpp"

namespace caustics {

struct Allowance {
  std::string driver;      // as gl_backend/gl_driver.hpp names it
  std::string pass;        // a pass definition's name, or what else was drawn; "*": all
  std::string attachment;  // without a light's number; "*": all
  double texels = 0.0;     // largest share of texels that may differ, 0..1
  double relative = 0.0;   // largest 99.9th percentile of the relative difference (difference.hpp)
  std::string reason;
};

// Applies a driver's allowances, and remembers which were needed.
class AllowanceBook {
 public:
  AllowanceBook(const std::string& driver, std::vector<Allowance> allowances);

  // The allowance that covers the difference, null when there is none or it is not enough. Call it
  // only for images that differ. Nothing covers a NaN or an infinity on one side alone.
  const Allowance* covers(const std::string& pass, const std::string& attachment,
                          const ImageDifference& difference);
  // Those that no difference has needed so far.
  std::vector<Allowance> unused() const;

 private:
  std::vector<Allowance> allowances_;
  std::vector<bool> used_;
};

}  // namespace caustics
