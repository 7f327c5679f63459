// The two triangles (a, b, c) and (d, c, b) that a quadrilateral is laid into a map as: its corners in texels
// for overlap.glsl.
VARYING_FLAT(0, Vec4, near)
VARYING_FLAT(4, Vec4, far)
VARYING_FLAT(8, Vec3, flux)

#ifdef VERTEX_STAGE
// In the map's first row and column corners are rounded to 2^-23 texel, as they are elsewhere by themselves:
// sums and differences of such numbers between 0 and 1 are exact, and texels beside a quadrilateral get 0.
Float on_lattice(Float x) { return sel(abs(x) < 1.0f, (x + 1.0f) - 1.0f, x); }
Vec4 on_lattice(Vec4 v) { return Vec4(on_lattice(v.x), on_lattice(v.y), on_lattice(v.z), on_lattice(v.w)); }

// Draws the rectangle of texels that the quadrilateral touches.
void lay_quad(Vec4 a_and_b, Vec4 c_and_d, Float map_side, Bool drawn) {
  near = on_lattice(a_and_b);
  far = on_lattice(c_and_d);
  Float left = floor(min_of(min_of(near.x, near.z), min_of(far.x, far.z)));
  Float bottom = floor(min_of(min_of(near.y, near.w), min_of(far.y, far.w)));
  Float right = floor(max_of(max_of(near.x, near.z), max_of(far.x, far.z))) + 1.0f;
  Float top = floor(max_of(max_of(near.y, near.w), max_of(far.y, far.w))) + 1.0f;
  Vec2 lower = Vec2(left * 2.0f / map_side - 1.0f, bottom * 2.0f / map_side - 1.0f);
  Vec2 upper = Vec2(right * 2.0f / map_side - 1.0f, top * 2.0f / map_side - 1.0f);
  set_rectangle(lower, sel(drawn, upper, lower));
}
#endif
