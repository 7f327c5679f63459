// The interface between the rasterizer and a pass's compiled shader: blocks of 16 vertices or
// fragments, stored component after component, whatever the lane width that works through them.
#pragma once
#include <cstdint>

namespace caustics {

inline constexpr int kBlock = 16;

// Operations on floats that this thread's scalar kernels have done: sums, products, quotients, signs, square
// roots, roundings, comparisons and choices, each as one. Wider lanes do not count.
extern constinit thread_local std::uint64_t operations_of_thread;

// A texture as shaders see it. Row 0 is the bottom row; `channels` floats a texel (1, 2 or 4).
struct TextureView {
  const float* texels = nullptr;
  int width = 0;
  int height = 0;
  int channels = 4;
};

// Receives the labelled intermediate values that a shader text hands to TRACE (scalar build only).
struct TraceSink {
  virtual void record(const char* label, const float* values, int count) = 0;

 protected:
  ~TraceSink() = default;
};

// 16 vertices. Lanes beyond the draw's last vertex repeat it, so every lane holds sound data.
struct VertexBlock {
  const void* uniforms;
  const TextureView* textures;
  const float (*attributes)[kBlock];  // [component][lane]
  const std::int32_t* vertex_id;      // [lane]
  float (*position)[kBlock];          // [4][lane], clip space
  float* point_size;                  // [lane], pixels
  float (*varyings)[kBlock];          // [component][lane]
};

// 16 fragments. Unused lanes repeat a used one.
struct FragmentBlock {
  const void* uniforms;
  const TextureView* textures;
  const float* frag_x;  // [lane], window coordinates of the pixel centre
  const float* frag_y;
  const std::int32_t* front_facing;  // [lane], 0 or -1
  const std::int32_t* primitive_id;  // [lane], in the draw; 0 of points
  const float (*varyings)[kBlock];   // [component][lane]
  float (*outputs)[kBlock];          // [4 * location + channel][lane]
  std::int32_t* discarded;           // [lane], 0 or -1
  TraceSink* trace;                  // may be null
};

}  // namespace caustics
