// Vertices without a mesh make one large triangle; every pixel gets a texel of each texture and a uniform,
// or what is less than nothing by these.
TEXTURE(0, first)
TEXTURE(1, second)

UNIFORMS_BEGIN
vec4 tint;
CHOICE(negative)
UNIFORMS_END

#ifdef VERTEX_STAGE
void main() {
  Int i = vertex_id();
  set_position(Vec4(sel(i == 1, Float(3.0f), Float(-1.0f)), sel(i == 2, Float(3.0f), Float(-1.0f)),
                    Float(0.5f), Float(1.0f)));
  set_point_size(Float(1.0f));
}
#else
OUTPUT(0, Vec4, sum)

void main() {
  Vec4 a = fetch_clamped(first, Int(frag_x()), Int(frag_y()));
  Vec4 b = fetch_clamped(second, Int(frag_x()), Int(frag_y()));
  sum = a + b + Vec4(Float(u.tint.x), Float(u.tint.y), Float(u.tint.z), Float(u.tint.w));
  if (u.negative != 0) sum = -sum;
}
#endif
