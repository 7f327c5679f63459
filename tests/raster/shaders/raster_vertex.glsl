ATTRIBUTE(0, Vec4, position)
ATTRIBUTE(4, Vec4, color)
ATTRIBUTE(8, Float, size)

void main() {
  smooth_color = color;
  flat_color = color;
  set_position(position);
  set_point_size(size);
}
