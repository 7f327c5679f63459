// What a shader text stands on when C++ compiles it: the component types of one lane width, and the
// vertex and fragment stages that the text becomes the body of. The including file defines
// CAUSTICS_LANES (1, 4, 8, 16) and CAUSTICS_LANE_NAMESPACE; each width lives in a namespace of its own.
#pragma once
#include <cstddef>
#include <cstdint>

// The narrowest header that does: <immintrin.h> takes GCC longer than most shaders.
#if defined(__SSE2__) && CAUSTICS_LANES >= 8
#include <immintrin.h>
#elif defined(__SSE4_1__)
#include <smmintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "pipeline/shader/kernel.hpp"
#include "pipeline/shader/std140_check.hpp"

#if defined(__FAST_MATH__)
#error "caustics promises exact arithmetic: build without -ffast-math"
#endif

namespace caustics::CAUSTICS_LANE_NAMESPACE {

#if CAUSTICS_LANES == 1
#include "pipeline/shader/scalar.hpp"
#else
#include "pipeline/shader/wide.hpp"
#endif
#include "pipeline/shader/vectors.hpp"

using Texture = const TextureView&;

[[gnu::always_inline]] inline Vec4 texel_fetch(const TextureView& t, Int x, Int y) {
  Float c[4];
  gather_texel(t, x, y, c);
  return Vec4(c[0], c[1], c[2], c[3]);
}
[[gnu::always_inline]] inline Vec4 table_fetch(const TextureView& t, Int index, int offset) {
  Float c[4];
  gather_table(t, index, offset, c);
  return Vec4(c[0], c[1], c[2], c[3]);
}
inline int texture_width(const TextureView& t) { return t.width; }
inline int texture_height(const TextureView& t) { return t.height; }

// Components of a Float, Vec2, Vec3 or Vec4 in and out of a [component][lane] block.
inline void load_rows(const float (*rows)[kBlock], int lane, Float& v) { load(rows[0] + lane, v); }
inline void load_rows(const float (*rows)[kBlock], int lane, Vec2& v) {
  load(rows[0] + lane, v.x);
  load(rows[1] + lane, v.y);
}
inline void load_rows(const float (*rows)[kBlock], int lane, Vec3& v) {
  load(rows[0] + lane, v.x);
  load(rows[1] + lane, v.y);
  load(rows[2] + lane, v.z);
}
inline void load_rows(const float (*rows)[kBlock], int lane, Vec4& v) {
  load(rows[0] + lane, v.x);
  load(rows[1] + lane, v.y);
  load(rows[2] + lane, v.z);
  load(rows[3] + lane, v.w);
}
inline void store_rows(float (*rows)[kBlock], int lane, const Float& v) { store(rows[0] + lane, v); }
inline void store_rows(float (*rows)[kBlock], int lane, const Vec2& v) {
  store(rows[0] + lane, v.x);
  store(rows[1] + lane, v.y);
}
inline void store_rows(float (*rows)[kBlock], int lane, const Vec3& v) {
  store(rows[0] + lane, v.x);
  store(rows[1] + lane, v.y);
  store(rows[2] + lane, v.z);
}
inline void store_rows(float (*rows)[kBlock], int lane, const Vec4& v) {
  store(rows[0] + lane, v.x);
  store(rows[1] + lane, v.y);
  store(rows[2] + lane, v.z);
  store(rows[3] + lane, v.w);
}

// Writes a stage's variable into its block when the stage object ends its life.
template <class T>
struct StoreAtEnd {
  float (*rows)[kBlock];
  int lane;
  const T& value;
  ~StoreAtEnd() { store_rows(rows, lane, value); }
};

struct VertexStage {
  const VertexBlock& block;
  int lane;
  VertexStage(const VertexBlock& b, int first_lane) : block(b), lane(first_lane) {}
  const void* uniforms() const { return block.uniforms; }
  const TextureView& texture_of(int unit) const { return block.textures[unit]; }
  template <class T>
  T attribute(int component) const {
    T v;
    load_rows(block.attributes + component, lane, v);
    return v;
  }
  template <class T>
  StoreAtEnd<T> varying(int component, const T& v) const {
    return {block.varyings + component, lane, v};
  }
  Int vertex_id() const {
    Int v;
    load(block.vertex_id + lane, v);
    return v;
  }
  void set_position(const Vec4& p) const { store_rows(block.position, lane, p); }
  void set_point_size(const Float& s) const { store(block.point_size + lane, s); }
  Int rectangle_id() const { return vertex_id(); }
  void set_rectangle(const Vec2& lower, const Vec2& upper) const {
    set_position(Vec4(lower.x, lower.y, upper.x, upper.y));
  }
};

struct FragmentStage {
  const FragmentBlock& block;
  int lane;
  FragmentStage(const FragmentBlock& b, int first_lane) : block(b), lane(first_lane) {}
  const void* uniforms() const { return block.uniforms; }
  const TextureView& texture_of(int unit) const { return block.textures[unit]; }
  template <class T>
  T varying(int component) const {
    T v;
    load_rows(block.varyings + component, lane, v);
    return v;
  }
  template <class T>
  StoreAtEnd<T> output(int location, const T& v) const {
    return {block.outputs + 4 * location, lane, v};
  }
  Float frag_x() const {
    Float v;
    load(block.frag_x + lane, v);
    return v;
  }
  Float frag_y() const {
    Float v;
    load(block.frag_y + lane, v);
    return v;
  }
  Bool front_facing() const {
    Bool v;
    load_mask(block.front_facing + lane, v);
    return v;
  }
  Int primitive_id() const {
    Int v;
    load(block.primitive_id + lane, v);
    return v;
  }
  void discard_if(Bool condition) const {
    Bool before;
    load_mask(block.discarded + lane, before);
    store_mask(block.discarded + lane, before || condition);
  }
#if CAUSTICS_LANES == 1
  void trace(const char* label, Float v) const {
    if (block.trace) block.trace->record(label, &v.v, 1);
  }
  void trace(const char* label, const Vec2& v) const {
    if (block.trace) block.trace->record(label, &v.x.v, 2);
  }
  void trace(const char* label, const Vec3& v) const {
    if (block.trace) block.trace->record(label, &v.x.v, 3);
  }
  void trace(const char* label, const Vec4& v) const {
    if (block.trace) block.trace->record(label, &v.x.v, 4);
  }
#endif
};

}  // namespace caustics::CAUSTICS_LANE_NAMESPACE

#define CONSTANT(name, value) static constexpr int name = value;
#define IN(T) const T&
#define OUT(T) T&
#define INOUT(T) T&
// As long as std140 has it: a multiple of 16 bytes.
#define UNIFORMS_BEGIN struct alignas(16) UniformBlock {
#define UNIFORMS_END \
  }                  \
  ;                  \
  const UniformBlock& u = *static_cast<const UniformBlock*>(this->uniforms());
#define CHOICE(name) int name = 0;
#define STACK(name) Stack name;
#define TEXTURE(unit, name) const TextureView& name = this->texture_of(unit);
