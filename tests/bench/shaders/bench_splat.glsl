// Point splats at places read from a texture, weighted by a Gaussian of the distance from the centre.
UNIFORMS_BEGIN
vec4 splat;  // size in pixels, exponent per squared pixel, grid columns, target width in pixels
UNIFORMS_END
TEXTURE(0, places)
VARYING_FLAT(0, Vec3, flux)
VARYING_FLAT(3, Vec2, centre)

#ifdef VERTEX_STAGE
void main() {
  Int id = vertex_id();
  Int row = id / Int(u.splat.z);
  Vec4 place = texel_fetch(places, id - row * Int(u.splat.z), row);
  flux = Vec3(place.z, place.z * 0.5f, place.z * 0.25f);
  centre = Vec2((place.x * 0.5f + 0.5f) * u.splat.w, (place.y * 0.5f + 0.5f) * u.splat.w);
  set_position(Vec4(place.x, place.y, Float(0.5f), Float(1.0f)));
  set_point_size(Float(u.splat.x));
}
#else
OUTPUT(0, Vec4, map)

void main() {
  Float x = frag_x() - centre.x;
  Float y = frag_y() - centre.y;
  Float weight = exp_of((x * x + y * y) * u.splat.y);
  map = Vec4(flux.x * weight, flux.y * weight, flux.z * weight, weight);
}
#endif
