// One triangle over the whole target that reads a texture of the same size, as the camera's passes do.
TEXTURE(0, places)

#ifdef VERTEX_STAGE
void main() {
  Int id = vertex_id();
  Float x = sel(id == 1, Float(3.0f), Float(-1.0f));
  Float y = sel(id == 2, Float(3.0f), Float(-1.0f));
  set_position(Vec4(x, y, Float(0.5f), Float(1.0f)));
}
#else
OUTPUT(0, Vec4, color)

void main() {
  Vec4 place = texel_fetch(places, Int(frag_x()), Int(frag_y()));
  color = Vec4(place.x * 2.0f, place.y + place.z, sqrt(place.w), Float(1.0f));
}
#endif
