// Clip coordinates, colours and sizes as the test gives them; the colour once smooth and once flat.
VARYING_SMOOTH(0, Vec4, smooth_color)
VARYING_FLAT(4, Vec4, flat_color)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec4, position)
ATTRIBUTE(4, Vec4, color)
ATTRIBUTE(8, Float, size)

void main() {
  smooth_color = color;
  flat_color = color;
  set_position(position);
  set_point_size(size);
}
#endif
