// Points: what they carry is flat, as the rules of the common subset ask.
UNIFORMS_BEGIN
vec4 limits;  // x: fragments whose flat red lies below it are discarded
UNIFORMS_END
VARYING_FLAT(0, Vec4, flat_color)
VARYING_FLAT(4, Vec2, centre)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec4, position)
ATTRIBUTE(4, Vec4, color)
ATTRIBUTE(8, Float, size)

void main() {
  flat_color = color;
  centre = Vec2(position.x, position.y);
  set_position(position);
  set_point_size(size);
}
#else
OUTPUT(0, Vec4, smooth_out)
OUTPUT(1, Vec4, flat_out)

void main() {
  discard_if(flat_color.x < u.limits.x);
  smooth_out = flat_color;
  flat_out = Vec4(frag_x() - centre.x, frag_y() - centre.y, exp_of(flat_color.y), flat_color.w);
}
#endif
