// What the common subset is in GLSL 4.50. The backend puts `#version 450 core` and a definition of
// VERTEX_STAGE or FRAGMENT_STAGE in front, and marks every float operation of both as precise
// (gl_backend/precise_text.hpp). pipeline/shader/SUBSET.md is the manual.
#define Float float
#define Int int
#define Bool bool
#define Vec2 vec2
#define Vec3 vec3
#define Vec4 vec4
#define Texture sampler2D
#define IN(T) in T
#define OUT(T) precise out T
#define INOUT(T) precise inout T
#define TRACE(label, value)
#define any_lane(condition) (condition)
#define CONSTANT(name, value) const int name = value;

#define UNIFORMS_BEGIN layout(std140, binding = 0) uniform UniformBlock {
#define UNIFORMS_END } u;
#define CHOICE(name) int name;
#define STACK(name) int name[64];
#define stack_put(stack, depth, value) stack[depth] = value
#define stack_at(stack, depth) stack[depth]
#define TEXTURE(unit, name) layout(binding = unit) uniform sampler2D name;
#define texel_fetch(t, x, y) texelFetch(t, ivec2(x, y), 0)
#define table_fetch(t, i, k) texelFetch(t, ivec2(((i) + (k)) & 4095, ((i) + (k)) >> 12), 0)
#define texture_width(t) textureSize(t, 0).x
#define texture_height(t) textureSize(t, 0).y

#ifdef VERTEX_STAGE
#define ATTRIBUTE(component, T, name) in T name;
#define VARYING_SMOOTH(component, T, name) precise out T name;
#define VARYING_FLAT(component, T, name) flat precise out T name;
#define OUTPUT(location, T, name)
out gl_PerVertex { precise vec4 gl_Position; float gl_PointSize; };
#ifdef POINT_QUADS  // a point is an instance (gl_backend/point_quads.glsl)
#define vertex_id() gl_InstanceID
#define main point_main
#else
#define vertex_id() gl_VertexID
#endif
#define set_position(p) gl_Position = (p)
#define set_point_size(s) gl_PointSize = (s)
// A rectangle is two triangles.
#define rectangle_id() (gl_VertexID / 6)
#define set_rectangle(lower, upper) gl_Position = corner_of_rectangle(lower, upper)
vec4 corner_of_rectangle(vec2 lower, vec2 upper) {
  int corner = gl_VertexID % 6;
  bool to_right = corner == 1 || corner == 2 || corner == 4;
  bool upwards = corner == 2 || corner == 4 || corner == 5;
  vec2 a = clamp(lower, -1.0f, 1.0f);
  vec2 b = clamp(upper, -1.0f, 1.0f);
  bool seen = a.x < b.x && a.y < b.y;
  return seen ? vec4(to_right ? b.x : a.x, upwards ? b.y : a.y, 0.5f, 1.0f) : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
#else
#define ATTRIBUTE(component, T, name)
#define VARYING_SMOOTH(component, T, name) in T name;
#define VARYING_FLAT(component, T, name) flat in T name;
#define OUTPUT(loc, T, name) layout(location = loc) precise out T name;
#define frag_x() gl_FragCoord.x
#define frag_y() gl_FragCoord.y
#define front_facing() gl_FrontFacing
#define primitive_id() gl_PrimitiveID
#define discard_if(condition) if (exact_condition = (condition)) discard
#endif

// What is assigned to it is calculated as precisely as any variable: conditions bear no mark of their own.
precise bool exact_condition;

float sel(bool c, float a, float b) { return c ? a : b; }
int sel(bool c, int a, int b) { return c ? a : b; }
bool sel(bool c, bool a, bool b) { return c ? a : b; }
vec2 sel(bool c, vec2 a, vec2 b) { return c ? a : b; }
vec3 sel(bool c, vec3 a, vec3 b) { return c ? a : b; }
vec4 sel(bool c, vec4 a, vec4 b) { return c ? a : b; }
