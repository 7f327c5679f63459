// CAUSTICS_LANES lanes: the component types of the common subset over GCC and Clang vector
// extensions. Every operation works lane by lane and rounds as its scalar twin does, so the lane
// width never shows in a result. No include guard: see vectors.hpp.
inline constexpr int kLanes = CAUSTICS_LANES;

using FloatVector = float __attribute__((vector_size(4 * CAUSTICS_LANES)));
using IntVector = std::int32_t __attribute__((vector_size(4 * CAUSTICS_LANES)));

inline FloatVector broadcast(float s) { return s - FloatVector{}; }
inline IntVector broadcast(std::int32_t s) { return s - IntVector{}; }

struct Bool {
  IntVector v{};  // 0 or -1 a lane
  Bool() = default;
  Bool(IntVector m) : v(m) {}
  Bool(bool s) : v(broadcast(s ? -1 : 0)) {}
  friend Bool operator&&(Bool a, Bool b) { return a.v & b.v; }
  friend Bool operator||(Bool a, Bool b) { return a.v | b.v; }
  friend Bool operator!(Bool a) { return ~a.v; }
};

struct Int {
  IntVector v{};
  Int() = default;
  Int(IntVector m) : v(m) {}
  Int(int s) : v(broadcast(s)) {}
  explicit Int(const struct Float& f);
  friend Int operator+(Int a, Int b) { return a.v + b.v; }
  friend Int operator-(Int a, Int b) { return a.v - b.v; }
  friend Int operator*(Int a, Int b) { return a.v * b.v; }
  friend Int operator/(Int a, Int b) { return a.v / b.v; }
  friend Int operator-(Int a) { return -a.v; }
  friend Bool operator<(Int a, Int b) { return a.v < b.v; }
  friend Bool operator>(Int a, Int b) { return a.v > b.v; }
  friend Bool operator<=(Int a, Int b) { return a.v <= b.v; }
  friend Bool operator>=(Int a, Int b) { return a.v >= b.v; }
  friend Bool operator==(Int a, Int b) { return a.v == b.v; }
  friend Bool operator!=(Int a, Int b) { return a.v != b.v; }
};

struct Float {
  FloatVector v{};
  Float() = default;
  Float(FloatVector m) : v(m) {}
  Float(float s) : v(broadcast(s)) {}
  explicit Float(int s) : v(broadcast(static_cast<float>(s))) {}
  explicit Float(Int i) : v(__builtin_convertvector(i.v, FloatVector)) {}
  friend Float operator+(Float a, Float b) { return a.v + b.v; }
  friend Float operator-(Float a, Float b) { return a.v - b.v; }
  friend Float operator*(Float a, Float b) { return a.v * b.v; }
  friend Float operator/(Float a, Float b) { return a.v / b.v; }
  friend Float operator-(Float a) { return -a.v; }
  friend Bool operator<(Float a, Float b) { return a.v < b.v; }
  friend Bool operator>(Float a, Float b) { return a.v > b.v; }
  friend Bool operator<=(Float a, Float b) { return a.v <= b.v; }
  friend Bool operator>=(Float a, Float b) { return a.v >= b.v; }
  friend Bool operator==(Float a, Float b) { return a.v == b.v; }
  friend Bool operator!=(Float a, Float b) { return a.v != b.v; }
};
inline Int::Int(const Float& f) : v(__builtin_convertvector(f.v, IntVector)) {}

inline Float sel(Bool c, Float a, Float b) { return c.v ? a.v : b.v; }
inline Int sel(Bool c, Int a, Int b) { return c.v ? a.v : b.v; }
inline Bool sel(Bool c, Bool a, Bool b) { return (c.v & a.v) | (~c.v & b.v); }
inline float sel(bool c, float a, float b) { return c ? a : b; }
inline float sqrt(float a) { return __builtin_sqrtf(a); }

inline void load(const float* p, Float& f) { __builtin_memcpy(&f.v, p, sizeof f.v); }
inline void load(const std::int32_t* p, Int& i) { __builtin_memcpy(&i.v, p, sizeof i.v); }
inline void load_mask(const std::int32_t* p, Bool& b) { __builtin_memcpy(&b.v, p, sizeof b.v); }
inline void store(float* p, Float f) { __builtin_memcpy(p, &f.v, sizeof f.v); }
inline void store_mask(std::int32_t* p, Bool b) { __builtin_memcpy(p, &b.v, sizeof b.v); }

// Whether the condition holds on any lane; only for skipping work whose results no other lane uses.
#if CAUSTICS_LANES == 16
inline bool any_lane(Bool c) { return _mm512_test_epi32_mask((__m512i)c.v, (__m512i)c.v) != 0; }
#elif CAUSTICS_LANES == 8
inline bool any_lane(Bool c) { return _mm256_movemask_ps((__m256)c.v) != 0; }
#elif defined(__SSE2__)
inline bool any_lane(Bool c) { return _mm_movemask_ps((__m128)c.v) != 0; }
#else
inline bool any_lane(Bool c) {
  bool any = false;
  for (int i = 0; i < kLanes; ++i) any |= c.v[i] != 0;
  return any;
}
#endif

inline Float abs(Float a) { return sel(a < 0.0f, -a, a.v + 0.0f); }

#if CAUSTICS_LANES == 16
inline Float sqrt(Float a) { return (FloatVector)_mm512_sqrt_ps((__m512)a.v); }
inline Float floor(Float a) {
  return (FloatVector)_mm512_roundscale_ps((__m512)a.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
#elif CAUSTICS_LANES == 8
inline Float sqrt(Float a) { return (FloatVector)_mm256_sqrt_ps((__m256)a.v); }
inline Float floor(Float a) { return (FloatVector)_mm256_floor_ps((__m256)a.v); }
#elif defined(__SSE4_1__)
inline Float sqrt(Float a) { return (FloatVector)_mm_sqrt_ps((__m128)a.v); }
inline Float floor(Float a) { return (FloatVector)_mm_floor_ps((__m128)a.v); }
#else
inline Float sqrt(Float a) {
  Float r;
  for (int i = 0; i < kLanes; ++i) r.v[i] = __builtin_sqrtf(a.v[i]);
  return r;
}
inline Float floor(Float a) {
  Float r;
  for (int i = 0; i < kLanes; ++i) r.v[i] = __builtin_floorf(a.v[i]);
  return r;
}
#endif

inline std::int32_t lane_of(Int v, int lane) { return v.v[lane]; }

// Of each lane a stack of 64 numbers. Its elements are not set before they are put.
struct Stack {
  std::int32_t values[64][kLanes];
};
inline void stack_put(Stack& stack, Int depth, Int value) {
  for (int lane = 0; lane < kLanes; ++lane) stack.values[depth.v[lane]][lane] = value.v[lane];
}
inline Int stack_at(const Stack& stack, Int depth) {
  Int value;
  for (int lane = 0; lane < kLanes; ++lane) value.v[lane] = stack.values[depth.v[lane]][lane];
  return value;
}

// Fetches one texel a lane. Four-channel texels are loaded whole and transposed, which beats gathers.
template <class TexelOf>
void gather_texels(const TexelOf& texel, int channels, Float out[4]) {
#if defined(__SSE2__)
  if (channels == 4) {
    __m128 part[4][kLanes / 4];
    for (int group = 0; group < kLanes / 4; ++group) {
      __m128 a = _mm_loadu_ps(texel(4 * group)), b = _mm_loadu_ps(texel(4 * group + 1));
      __m128 c = _mm_loadu_ps(texel(4 * group + 2)), d = _mm_loadu_ps(texel(4 * group + 3));
      _MM_TRANSPOSE4_PS(a, b, c, d);
      part[0][group] = a;
      part[1][group] = b;
      part[2][group] = c;
      part[3][group] = d;
    }
    for (int channel = 0; channel < 4; ++channel) {
#if CAUSTICS_LANES == 16
      __m512 whole = _mm512_castps128_ps512(part[channel][0]);
      whole = _mm512_insertf32x4(whole, part[channel][1], 1);
      whole = _mm512_insertf32x4(whole, part[channel][2], 2);
      out[channel].v = (FloatVector)_mm512_insertf32x4(whole, part[channel][3], 3);
#elif CAUSTICS_LANES == 8
      out[channel].v = (FloatVector)_mm256_set_m128(part[channel][1], part[channel][0]);
#else
      out[channel].v = (FloatVector)part[channel][0];
#endif
    }
    return;
  }
#endif
  alignas(64) float value[4][kLanes];
  for (int channel = 0; channel < 4; ++channel) {
    if (channel >= channels) {
      out[channel] = Float(channel < 3 ? 0.0f : 1.0f);
      continue;
    }
    for (int lane = 0; lane < kLanes; ++lane) value[channel][lane] = texel(lane)[channel];
    load(value[channel], out[channel]);
  }
}

// A texture has less than 2^31 texels.
inline void gather_texel(const TextureView& t, Int x, Int y, Float out[4]) {
  const Int index = y * Int(t.width) + x;
  gather_texels(
      [&](int lane) { return t.texels + static_cast<std::ptrdiff_t>(lane_of(index, lane)) * t.channels; },
      t.channels, out);
}
