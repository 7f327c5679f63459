// One triangle that covers every pixel: vertices (-1, -1), (3, -1), (-1, 3) from vertex ids 0, 1, 2.
void main() {
  Float x = sel(vertex_id() == 1, Float(3.0f), Float(-1.0f));
  Float y = sel(vertex_id() == 2, Float(3.0f), Float(-1.0f));
  set_position(Vec4(x, y, Float(0.0f), Float(1.0f)));
}
