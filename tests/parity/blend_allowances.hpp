// Where drivers blend otherwise than the equation is written: data. No pass uses any of these states.
#pragma once
#include <string>
#include <vector>

#include "pipeline/gpu/difference.hpp"
#include "pipeline/gpu/pass_definition.hpp"

namespace caustics::test {

// What a colour attachment's format and blending have in common with others that a driver treats
// alike; "" for what every driver has to do as written.
inline std::string blend_class(const ColorWrite& write) {
  const BlendState& b = write.blend;
  const bool adds = b.enabled && b.equation == BlendEquation::Add;
  const auto constant = [](BlendFactor f) { return f == BlendFactor::Zero || f == BlendFactor::One; };
  const auto pair = [&](BlendFactor one, BlendFactor other) {
    return (b.source == one && b.destination == other) || (b.source == other && b.destination == one);
  };
  if (write.format == Format::RGBA16F) return "half";
  if (!adds) return "";
  if (write.format == Format::RGBA8)
    return constant(b.source) && constant(b.destination) ? "" : "8 bits, products";
  if (b.source == b.destination && !constant(b.source)) return "equal factors";
  if (write.format == Format::R32F && (pair(BlendFactor::One, BlendFactor::Zero) ||
                                       pair(BlendFactor::SourceAlpha, BlendFactor::OneMinusSourceAlpha)))
    return "one channel, complementary factors";
  return "";
}

// What llvmpipe may differ by in one of these states; the others it draws to the bit.
struct BlendAllowance {
  std::string name;       // blend_class()
  double texels = 0.0;    // largest share of texels that may differ, 0..1
  double relative = 0.0;  // largest 99.9th percentile of the relative difference
  std::string reason;
};

inline const std::vector<BlendAllowance>& blend_allowances() {
  static const std::vector<BlendAllowance> allowances = {
      {"half", 1.0, 0.03,
       "halves are rounded towards zero, after each blend; the software device rounds to nearest"},
      {"8 bits, products", 1.0, 1.0,
       "products of 8-bit integers after each blend, which may lose a whole step, as from 1/255 to 0"},
      {"equal factors", 1.0, 5e-7, "s f + d f is computed as (s + d) f"},
      {"one channel, complementary factors", 0.35, 3e-7,
       "s f + d (1 - f) is computed as d + f (s - d), also for f = 1"},
  };
  return allowances;
}

// Nothing covers a NaN or an infinity on one side alone.
inline bool covers(const BlendAllowance& allowance, const ImageDifference& d) {
  if (!d.same_shape || d.all.nan_only_a + d.all.nan_only_b + d.all.infinite > 0) return false;
  return static_cast<double>(d.differing_texels) <= allowance.texels * static_cast<double>(d.texels) &&
         d.all.relative.p999 <= allowance.relative;
}

}  // namespace caustics::test
