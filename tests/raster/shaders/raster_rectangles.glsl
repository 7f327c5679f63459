// Rectangles as the texels of a row give them: two corners in clip coordinates. Each adds its number plus 1.
TEXTURE(0, rectangles)
VARYING_FLAT(0, Float, number)

#ifdef VERTEX_STAGE
void main() {
  Vec4 corners = texel_fetch(rectangles, rectangle_id(), Int(0));
  number = Float(rectangle_id()) + 1.0f;
  set_rectangle(Vec2(corners.x, corners.y), Vec2(corners.z, corners.w));
}
#else
OUTPUT(0, Vec4, numbers)

void main() { numbers = Vec4(number, Float(1.0f), Float(0.0f), Float(0.0f)); }
#endif
