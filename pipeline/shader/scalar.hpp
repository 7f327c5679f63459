// One lane: the component types of the common subset as plain C++, whose operations on floats are counted. No
// include guard: see vectors.hpp.
using Int = int;
using Bool = bool;
inline constexpr int kLanes = 1;

struct Float {
  float v = 0.0f;
  Float() = default;
  Float(float s) : v(s) {}
  explicit Float(int i) : v(static_cast<float>(i)) {}
  explicit operator int() const { return static_cast<int>(v); }
  friend Float operator+(Float a, Float b) { return counted(a.v + b.v); }
  friend Float operator-(Float a, Float b) { return counted(a.v - b.v); }
  friend Float operator*(Float a, Float b) { return counted(a.v * b.v); }
  friend Float operator/(Float a, Float b) { return counted(a.v / b.v); }
  friend Float operator-(Float a) { return counted(-a.v); }
  friend bool operator<(Float a, Float b) { return counted(a.v < b.v); }
  friend bool operator>(Float a, Float b) { return counted(a.v > b.v); }
  friend bool operator<=(Float a, Float b) { return counted(a.v <= b.v); }
  friend bool operator>=(Float a, Float b) { return counted(a.v >= b.v); }
  friend bool operator==(Float a, Float b) { return counted(a.v == b.v); }
  friend bool operator!=(Float a, Float b) { return counted(a.v != b.v); }

  template <class T>
  static T counted(T result) {
    ++operations_of_thread;
    return result;
  }
};

inline Float sel(bool c, Float a, Float b) { return Float::counted(c ? a : b); }
inline float sel(bool c, float a, float b) { return c ? a : b; }
inline int sel(bool c, int a, int b) { return c ? a : b; }
inline bool sel(bool c, bool a, bool b) { return c ? a : b; }
inline float sqrt(float a) { return __builtin_sqrtf(a); }
inline Float sqrt(Float a) { return Float::counted(__builtin_sqrtf(a.v)); }
inline Float floor(Float a) { return Float::counted(__builtin_floorf(a.v)); }
inline Float abs(Float a) { return Float::counted(__builtin_fabsf(a.v)); }
inline Float intBitsToFloat(int bits) { return __builtin_bit_cast(float, bits); }
inline int floatBitsToInt(Float a) { return __builtin_bit_cast(int, a.v); }

inline bool any_lane(bool c) { return c; }

inline void load(const float* p, Float& f) { f.v = *p; }
inline void load(const std::int32_t* p, int& v) { v = *p; }
inline void load_mask(const std::int32_t* p, bool& v) { v = *p != 0; }
inline void store(float* p, Float f) { *p = f.v; }
inline void store_mask(std::int32_t* p, bool v) { *p = v ? -1 : 0; }

inline int lane_of(int v, int) { return v; }

// Of each lane a stack of 64 numbers. Its elements are not set before they are put.
struct Stack {
  int values[64];
};
inline void stack_put(Stack& stack, int depth, int value) { stack.values[depth] = value; }
inline int stack_at(const Stack& stack, int depth) { return stack.values[depth]; }

// The channels of one texel; missing ones read 0, 0, 1 as GL's swizzle has it.
inline void gather_texel(const TextureView& t, int x, int y, Float out[4]) {
  const float* p = t.texels + (static_cast<std::size_t>(y) * static_cast<std::size_t>(t.width) +
                               static_cast<std::size_t>(x)) *
                                  static_cast<std::size_t>(t.channels);
  out[0] = p[0];
  out[1] = t.channels > 1 ? p[1] : 0.0f;
  out[2] = t.channels > 2 ? p[2] : 0.0f;
  out[3] = t.channels > 3 ? p[3] : 1.0f;
}
// Of a table, four channels: texels in one row, offset by as many.
inline void gather_table(const TextureView& t, int index, int offset, Float out[4]) {
  const float* p = t.texels + 4 * (static_cast<std::ptrdiff_t>(index) + offset);
  for (int channel = 0; channel < 4; ++channel) out[channel] = p[channel];
}
