// Light under way between two surfaces. Needs axes_across.glsl and ray.glsl.
struct LightPath {
  Ray ray;
  Float own;      // number of the triangle that it starts on
  Bool aside;     // of the branch that draws: it has been mirrored where others go both ways,
  Bool parted;    // and it is not where another branch's light goes; so is what other branches follow
  Float path;     // what it has met: the same number for the same sequence of bodies and events
  Vec3 flux;      // relative to the light's intensity
  Float whole;    // the light's flux on the grid vertex's cell
  Vec4 media;     // the bodies that it is in, the last one entered first, as media.glsl has them
  Vec3 width_x;   // of its differential (Igehy 1999): how its start moves along the grid's rows and columns,
  Vec3 width_y;
  Vec3 spread_x;  // and how its direction turns
  Vec3 spread_y;
};

// Keeps finite what each grazing surface may widen a thousandfold.
Float bounded(Float x) { return clamp_to(x, -1.0e6f, 1.0e6f); }

// The part of a differential that lies across the ray.
Vec3 across(IN(AxesAcross) axes, Vec3 v) {
  return axes.x * bounded(dot3(v, axes.x)) + axes.y * bounded(dot3(v, axes.y));
}

void keep_across(INOUT(LightPath) path) {
  AxesAcross axes = axes_across(path.ray.direction);
  path.width_x = across(axes, path.width_x);
  path.width_y = across(axes, path.width_y);
  path.spread_x = across(axes, path.spread_x);
  path.spread_y = across(axes, path.spread_y);
}
