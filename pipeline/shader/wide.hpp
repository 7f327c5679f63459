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

inline Float intBitsToFloat(Int bits) { return (FloatVector)bits.v; }
inline Int floatBitsToInt(Float a) { return (IntVector)a.v; }

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

#if defined(__SSE2__)
// A texel of four channels each of lanes i, i + 4, i + 8 and i + 12, as far as there are so many.
template <class TexelOf>
[[gnu::always_inline]] inline FloatVector every_fourth(const TexelOf& texel, int i) {
#if CAUSTICS_LANES == 16
  __m512 four = _mm512_castps128_ps512(_mm_loadu_ps(texel(i)));
  four = _mm512_insertf32x4(four, _mm_loadu_ps(texel(i + 4)), 1);
  four = _mm512_insertf32x4(four, _mm_loadu_ps(texel(i + 8)), 2);
  return (FloatVector)_mm512_insertf32x4(four, _mm_loadu_ps(texel(i + 12)), 3);
#elif CAUSTICS_LANES == 8
  return (FloatVector)_mm256_set_m128(_mm_loadu_ps(texel(i + 4)), _mm_loadu_ps(texel(i)));
#else
  return (FloatVector)_mm_loadu_ps(texel(i));
#endif
}
// Of each 128 bits the lower two floats of a and b in turn, or the upper two.
inline FloatVector lower_in_turn(FloatVector a, FloatVector b) {
#if CAUSTICS_LANES == 16
  return (FloatVector)_mm512_unpacklo_ps((__m512)a, (__m512)b);
#elif CAUSTICS_LANES == 8
  return (FloatVector)_mm256_unpacklo_ps((__m256)a, (__m256)b);
#else
  return (FloatVector)_mm_unpacklo_ps((__m128)a, (__m128)b);
#endif
}
inline FloatVector upper_in_turn(FloatVector a, FloatVector b) {
#if CAUSTICS_LANES == 16
  return (FloatVector)_mm512_unpackhi_ps((__m512)a, (__m512)b);
#elif CAUSTICS_LANES == 8
  return (FloatVector)_mm256_unpackhi_ps((__m256)a, (__m256)b);
#else
  return (FloatVector)_mm_unpackhi_ps((__m128)a, (__m128)b);
#endif
}
#endif

// Fetches one texel of four channels a lane, whose values would pass through memory to a caller: loaded whole
// and transposed within each 128 bits.
template <class TexelOf>
[[gnu::always_inline]] inline void gather_whole_texels(const TexelOf& texel, Float out[4]) {
#if defined(__SSE2__)
  const FloatVector a = every_fourth(texel, 0), b = every_fourth(texel, 1), c = every_fourth(texel, 2),
                    d = every_fourth(texel, 3);
  const FloatVector red_green = lower_in_turn(a, c), red_green2 = lower_in_turn(b, d);
  const FloatVector blue_alpha = upper_in_turn(a, c), blue_alpha2 = upper_in_turn(b, d);
  out[0].v = lower_in_turn(red_green, red_green2);
  out[1].v = upper_in_turn(red_green, red_green2);
  out[2].v = lower_in_turn(blue_alpha, blue_alpha2);
  out[3].v = upper_in_turn(blue_alpha, blue_alpha2);
#else
  for (int lane = 0; lane < kLanes; ++lane)
    for (int channel = 0; channel < 4; ++channel) out[channel].v[lane] = texel(lane)[channel];
#endif
}

// Likewise of a table: texels in one row, offset by as many.
[[gnu::always_inline]] inline void gather_table(const TextureView& t, Int index, int offset, Float out[4]) {
  const float* const texels = t.texels + 4 * offset;
  gather_whole_texels(
      [&](int lane) { return texels + 4 * static_cast<std::ptrdiff_t>(lane_of(index, lane)); }, out);
}

// A texture has less than 2^29 texels.
[[gnu::always_inline]] inline void gather_texel(const TextureView& t, Int x, Int y, Float out[4]) {
  const Int index = y * Int(t.width) + x;
  if (t.channels == 4) {
    // Twice, because a processor's addresses take steps of eight bytes at most without a shift.
    const Int twice = index + index;
    gather_whole_texels(
        [&](int lane) { return t.texels + 2 * static_cast<std::ptrdiff_t>(lane_of(twice, lane)); }, out);
    return;
  }
  for (int channel = 0; channel < 4; ++channel) {
    if (channel >= t.channels) {
      out[channel] = Float(channel < 3 ? 0.0f : 1.0f);
      continue;
    }
    const float* const texels = t.texels + channel;
    for (int lane = 0; lane < kLanes; ++lane)
      out[channel].v[lane] = texels[static_cast<std::ptrdiff_t>(lane_of(index, lane)) * t.channels];
  }
}
