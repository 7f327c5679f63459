// One lane: the component types of the common subset as plain C++. No include guard: see vectors.hpp.
using Float = float;
using Int = int;
using Bool = bool;
inline constexpr int kLanes = 1;

inline float sel(bool c, float a, float b) { return c ? a : b; }
inline int sel(bool c, int a, int b) { return c ? a : b; }
inline bool sel(bool c, bool a, bool b) { return c ? a : b; }
inline float sqrt(float a) { return __builtin_sqrtf(a); }
inline float floor(float a) { return __builtin_floorf(a); }
inline float abs(float a) { return __builtin_fabsf(a); }
inline float intBitsToFloat(int bits) { return __builtin_bit_cast(float, bits); }
inline int floatBitsToInt(float a) { return __builtin_bit_cast(int, a); }

inline bool any_lane(bool c) { return c; }

inline void load(const float* p, float& v) { v = *p; }
inline void load(const std::int32_t* p, int& v) { v = *p; }
inline void load_mask(const std::int32_t* p, bool& v) { v = *p != 0; }
inline void store(float* p, float v) { *p = v; }
inline void store_mask(std::int32_t* p, bool v) { *p = v ? -1 : 0; }

inline int lane_of(int v, int) { return v; }

// Of each lane a stack of 64 numbers. Its elements are not set before they are put.
struct Stack {
  int values[64];
};
inline void stack_put(Stack& stack, int depth, int value) { stack.values[depth] = value; }
inline int stack_at(const Stack& stack, int depth) { return stack.values[depth]; }

// The channels of one texel; missing ones read 0, 0, 1 as GL's swizzle has it.
inline void gather_texel(const TextureView& t, int x, int y, float out[4]) {
  const float* p = t.texels + (static_cast<std::size_t>(y) * static_cast<std::size_t>(t.width) +
                               static_cast<std::size_t>(x)) *
                                  static_cast<std::size_t>(t.channels);
  out[0] = p[0];
  out[1] = t.channels > 1 ? p[1] : 0.0f;
  out[2] = t.channels > 2 ? p[2] : 0.0f;
  out[3] = t.channels > 3 ? p[3] : 1.0f;
}
// Of a table, four channels: texels in one row, offset by as many.
inline void gather_table(const TextureView& t, int index, int offset, float out[4]) {
  const float* p = t.texels + 4 * (static_cast<std::ptrdiff_t>(index) + offset);
  for (int channel = 0; channel < 4; ++channel) out[channel] = p[channel];
}
