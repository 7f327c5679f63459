// Light under way, as a texel of the ray textures holds it (ray_state.glsl). Needs ray.glsl.
struct LightPath {
  Ray ray;
  Float path;     // what it has met: the same number for the same sequence of bodies and events
  Vec3 flux;
  Float whole;    // the light's flux on the grid vertex's cell
  Vec4 media;
  Vec3 width_x;   // of its differential (Igehy 1999): how its start moves along the grid's rows and columns,
  Vec3 width_y;
  Vec3 spread_x;  // and how its direction turns
  Vec3 spread_y;
};

// A texel of a differential, which each grazing surface may widen a thousandfold: it stays finite.
Vec4 bounded(Float x, Float y, Float z, Float w) {
  Float most = Float(1.0e6f);
  return Vec4(clamp_to(x, -most, most), clamp_to(y, -most, most), clamp_to(z, -most, most),
              clamp_to(w, -most, most));
}
