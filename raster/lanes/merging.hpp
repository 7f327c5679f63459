// How a shaded fragment gets into a tile's colours: blending, masks, and the rounding of the target's format.
// As tile_renderer.hpp, which includes it in the namespace of one instruction set.
#pragma once
#include "raster/lanes/sixteen.hpp"
#include "raster/tile_job.hpp"

namespace caustics::raster::CAUSTICS_TILE_NAMESPACE {

// ---- half and 8-bit targets: the rounding of pipeline/gpu/format.cpp, which lives outside this
// instruction set and is called through the linker.
inline float quantized(Format format, float value) {
  return format == Format::RGBA16F || format == Format::RGBA8 ? stored_value(format, value) : value;
}

inline float factor_of(BlendFactor factor, const float* source, const float* destination, int channel) {
  switch (factor) {
    case BlendFactor::Zero:
      return 0.0f;
    case BlendFactor::One:
      return 1.0f;
    case BlendFactor::SourceColor:
      return source[channel];
    case BlendFactor::SourceAlpha:
      return source[3];
    case BlendFactor::OneMinusSourceAlpha:
      return 1.0f - source[3];
    case BlendFactor::DestinationColor:
      return destination[channel];
  }
  return 0.0f;
}

// A term of the Add equation; a factor of 0 gives 0 and of 1 the value itself.
inline float weighted(BlendFactor factor, float value, const float* source, const float* destination,
                      int channel) {
  if (factor == BlendFactor::Zero) return 0.0f;
  if (factor == BlendFactor::One) return value;
  return value * factor_of(factor, source, destination, channel);
}

inline float blended(const BlendState& blend, const float* source, const float* destination, int channel) {
  const float s = source[channel], d = destination[channel];
  // A NaN loses against a number in Min and Max, as on llvmpipe.
  if (blend.equation == BlendEquation::Min) return s < d || d != d ? s : d;
  if (blend.equation == BlendEquation::Max) return s > d || d != d ? s : d;
  return weighted(blend.source, s, source, destination, channel) +
         weighted(blend.destination, d, source, destination, channel);
}

inline void write_color(const TileColor& target, float* texel, const float* color) {
  const bool unorm = target.format == Format::RGBA8;
  float source[4], result[4];
  for (int c = 0; c < 4; ++c) {
    source[c] = color[c];
    // Fixed-point targets clamp before blending (17.3.6.1).
    if (unorm) source[c] = source[c] >= 0.0f ? (source[c] <= 1.0f ? source[c] : 1.0f) : 0.0f;
  }
  for (int c = 0; c < 4; ++c)
    result[c] = target.blend.enabled ? blended(target.blend, source, texel, c) : source[c];
  for (int c = 0; c < 4; ++c)
    if (target.mask[c]) texel[c] = quantized(target.format, result[c]);
}

// How a fragment gets into a target. ReplaceByte: as Replace, once a block's values have been rounded to the
// bytes that the target can hold. ReplaceValue and AddValue: into TileColor::values.
enum class Merging { None, General, Replace, ReplaceByte, Add, ReplaceValue, AddValue };

inline Merging merging_of(const TileColor& target) {
  const BlendState& blend = target.blend;
  if (!target.texels && !target.values) return Merging::None;
  if (target.values) return blend.enabled ? Merging::AddValue : Merging::ReplaceValue;
  const bool all = target.mask[0] && target.mask[1] && target.mask[2] && target.mask[3];
  if (all && !blend.enabled && target.format == Format::RGBA8) return Merging::ReplaceByte;
  if (!all || target.format != Format::RGBA32F) return Merging::General;
  if (!blend.enabled) return Merging::Replace;
  const bool adds = blend.equation == BlendEquation::Add && blend.source == BlendFactor::One &&
                    blend.destination == BlendFactor::One;
  return adds ? Merging::Add : Merging::General;
}

// stored_value of RGBA8 for a block of one channel. Adding 1.5 * 2^23 leaves no place for a fraction: the sum
// is rounded to the nearest whole number, ties to even, as unorm8_from_float has it.
inline void round_to_bytes(float (&values)[kBlock]) {
  constexpr float kNoFraction = 12582912.0f;
  for (int lane = 0; lane < kBlock; ++lane) {
    float v = values[lane];
    v = v > 0.0f ? v : 0.0f;
    v = v < 1.0f ? v : 1.0f;
    values[lane] = ((v * 255.0f + kNoFraction) - kNoFraction) / 255.0f;
  }
}

// Where texels are not all of four channels that are replaced or added to.
inline void merge_texel(const TileColor& target, Merging merging, int pixel, const float (*outputs)[kBlock],
                        int lane) {
  if (merging == Merging::None) return;
  if (merging == Merging::ReplaceValue) {
    target.values[pixel] = outputs[0][lane];
    return;
  }
  if (merging == Merging::AddValue) {
    target.values[pixel] = outputs[0][lane] + target.values[pixel];
    return;
  }
  float color[4];
  for (int c = 0; c < 4; ++c) color[c] = outputs[c][lane];
  write_color(target, target.texels[pixel], color);
}

// Of a block the lanes whose bits are set, one after the other: several may lie at one pixel.
inline void merge_lanes(const TileColor& target, Merging merging, const std::int32_t* pixels, unsigned lanes,
                        const float (*outputs)[kBlock]) {
  const bool adds = merging == Merging::Add;
  if (!adds && merging != Merging::Replace && merging != Merging::ReplaceByte) {
    for (; lanes != 0; lanes &= lanes - 1) {
      const int lane = __builtin_ctz(lanes);
      merge_texel(target, merging, pixels[lane], outputs, lane);
    }
    return;
  }
  float colors[kBlock][4];
  replace_row(colors, outputs);
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = __builtin_ctz(lanes);
    float* const texel = target.texels[pixels[lane]];
    Texel color, stored;
    __builtin_memcpy(&color, colors[lane], sizeof color);
    __builtin_memcpy(&stored, texel, sizeof stored);
    if (adds) color = color + stored;
    __builtin_memcpy(texel, &color, sizeof color);
  }
}

// Sixteen neighbours from `pixel` on.
inline void merge_texels(const TileColor& target, Merging merging, int pixel,
                         const float (*outputs)[kBlock]) {
  if (merging == Merging::None) return;
  if (merging == Merging::Replace || merging == Merging::ReplaceByte) {
    replace_row(target.texels + pixel, outputs);
  } else if (merging == Merging::ReplaceValue) {
    store_floats(target.values + pixel, load_floats(outputs[0]));
  } else if (merging == Merging::AddValue) {
    float* const values = target.values + pixel;
    store_floats(values, load_floats(outputs[0]) + load_floats(values));
  } else {
    std::int32_t pixels[kBlock];
    store_ints(pixels, pixel + kNeighbours);
    merge_lanes(target, merging, pixels, 0xffffu, outputs);
  }
}

}  // namespace caustics::raster::CAUSTICS_TILE_NAMESPACE
