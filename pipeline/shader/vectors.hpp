// Vectors and matrices of the common subset over any component type. No include guard on purpose:
// stage.hpp includes this inside a namespace of its lane width, so that no inline function compiled
// for one instruction set can stand in for another.
template <class F>
struct Vec2Of;
template <class F>
struct Vec3Of;
template <class F>
struct Vec4Of;

#define CAUSTICS_VECTOR_OPERATORS(V, EACH, EACH_SCALAR, NEGATED)           \
  friend V operator+(const V& a, const V& b) { return V(EACH(+)); }        \
  friend V operator-(const V& a, const V& b) { return V(EACH(-)); }        \
  friend V operator*(const V& a, const V& b) { return V(EACH(*)); }        \
  friend V operator/(const V& a, const V& b) { return V(EACH(/)); }        \
  friend V operator*(const V& a, const F& s) { return V(EACH_SCALAR(*)); } \
  friend V operator/(const V& a, const F& s) { return V(EACH_SCALAR(/)); } \
  friend V operator*(const F& s, const V& a) { return V(EACH_SCALAR(*)); } \
  friend V operator-(const V& a) { return V(NEGATED); }

template <class F>
struct Vec2Of {
  F x{}, y{};
  Vec2Of() = default;
  Vec2Of(F x_, F y_) : x(x_), y(y_) {}
  explicit Vec2Of(F s) : x(s), y(s) {}
  template <class G>
  Vec2Of(const Vec2Of<G>& v) : x(v.x), y(v.y) {}
  template <class G>
  explicit Vec2Of(const Vec3Of<G>& v) : x(v.x), y(v.y) {}
  template <class G>
  explicit Vec2Of(const Vec4Of<G>& v) : x(v.x), y(v.y) {}
#define EACH2(op) a.x op b.x, a.y op b.y
#define EACH2S(op) a.x op s, a.y op s
#define NEG2 -a.x, -a.y
  CAUSTICS_VECTOR_OPERATORS(Vec2Of, EACH2, EACH2S, NEG2)
};

template <class F>
struct Vec3Of {
  F x{}, y{}, z{};
  Vec3Of() = default;
  Vec3Of(F x_, F y_, F z_) : x(x_), y(y_), z(z_) {}
  explicit Vec3Of(F s) : x(s), y(s), z(s) {}
  Vec3Of(const Vec2Of<F>& v, F z_) : x(v.x), y(v.y), z(z_) {}
  template <class G>
  Vec3Of(const Vec3Of<G>& v) : x(v.x), y(v.y), z(v.z) {}
  template <class G>
  explicit Vec3Of(const Vec4Of<G>& v) : x(v.x), y(v.y), z(v.z) {}
#define EACH3(op) a.x op b.x, a.y op b.y, a.z op b.z
#define EACH3S(op) a.x op s, a.y op s, a.z op s
#define NEG3 -a.x, -a.y, -a.z
  CAUSTICS_VECTOR_OPERATORS(Vec3Of, EACH3, EACH3S, NEG3)
};

template <class F>
struct Vec4Of {
  F x{}, y{}, z{}, w{};
  Vec4Of() = default;
  Vec4Of(F x_, F y_, F z_, F w_) : x(x_), y(y_), z(z_), w(w_) {}
  explicit Vec4Of(F s) : x(s), y(s), z(s), w(s) {}
  Vec4Of(const Vec3Of<F>& v, F w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
  template <class G>
  Vec4Of(const Vec4Of<G>& v) : x(v.x), y(v.y), z(v.z), w(v.w) {}
#define EACH4(op) a.x op b.x, a.y op b.y, a.z op b.z, a.w op b.w
#define EACH4S(op) a.x op s, a.y op s, a.z op s, a.w op s
#define NEG4 -a.x, -a.y, -a.z, -a.w
  CAUSTICS_VECTOR_OPERATORS(Vec4Of, EACH4, EACH4S, NEG4)
};

#undef CAUSTICS_VECTOR_OPERATORS
#undef EACH2
#undef EACH2S
#undef NEG2
#undef EACH3
#undef EACH3S
#undef NEG3
#undef EACH4
#undef EACH4S
#undef NEG4

// Uniforms: the same on every lane.
// Aligned as std140 aligns them (std140.hpp).
using vec2 __attribute__((aligned(8))) = Vec2Of<float>;
using vec3 __attribute__((aligned(16))) = Vec3Of<float>;
using vec4 __attribute__((aligned(16))) = Vec4Of<float>;
struct IVec4 {
  int x{}, y{}, z{}, w{};
};
using ivec4 __attribute__((aligned(16))) = IVec4;
struct Mat4 {
  Vec4Of<float> columns[4];
  const Vec4Of<float>& operator[](int i) const { return columns[i]; }
};
using mat4 __attribute__((aligned(16))) = Mat4;

using Vec2 = Vec2Of<Float>;
using Vec3 = Vec3Of<Float>;
using Vec4 = Vec4Of<Float>;

inline Vec2 sel(Bool c, const Vec2& a, const Vec2& b) { return Vec2(sel(c, a.x, b.x), sel(c, a.y, b.y)); }
inline Vec3 sel(Bool c, const Vec3& a, const Vec3& b) {
  return Vec3(sel(c, a.x, b.x), sel(c, a.y, b.y), sel(c, a.z, b.z));
}
inline Vec4 sel(Bool c, const Vec4& a, const Vec4& b) {
  return Vec4(sel(c, a.x, b.x), sel(c, a.y, b.y), sel(c, a.z, b.z), sel(c, a.w, b.w));
}
