// One triangle over the whole target that copies a texture of the same size.
TEXTURE(0, source)

#ifdef VERTEX_STAGE
void main() {
  Int id = vertex_id();
  Float x = sel(id == 1, Float(3.0f), Float(-1.0f));
  Float y = sel(id == 2, Float(3.0f), Float(-1.0f));
  set_position(Vec4(x, y, Float(0.5f), Float(1.0f)));
}
#else
OUTPUT(0, Vec4, color)

void main() { color = texel_fetch(source, Int(frag_x()), Int(frag_y())); }
#endif
