// Where a ray meets a caster's surface, and what lies on both sides. Needs position_texel.glsl.
struct Meeting {
  Vec3 point;
  Vec3 outward;   // the surface's smooth normal, unit
  Vec3 plane;     // the triangle's own, unit
  Bool front;     // the ray comes from outside
  Float number;   // of the triangle
  Float stretch;  // metres since the last surface
  Bool hole;      // an alpha mask has cut the surface out here
};

// What a texel of a view shows: position and normal of the caster, whose triangle is not asked for.
Meeting meeting_in_view(Vec4 position, Vec4 normal) {
  Meeting at;
  at.point = Vec3(position);
  at.outward = Vec3(normal);
  at.plane = at.outward;
  at.front = !is_back_face(position);
  at.number = Float(-1.0f);
  at.stretch = Float(0.0f);
  at.hole = Bool(false);
  return at;
}

// The indices of refraction on both sides, and the bodies that light is in behind the surface.
struct Interface {
  Float before;
  Float behind;
  Vec4 media;
  Bool passes;    // nothing bends it: a second skin of a body that the light is in, or a hole
  Bool overflow;  // it enters more bodies than are remembered
  Bool tints;     // light that crosses here has the body's colour from now on
};

// Does interpolation send a ray to the wrong side of its own surface?
Bool strays(Vec3 direction, IN(Meeting) at, Vec3 before, Bool is_mirrored) {
  Bool onward = dot3(direction, at.plane) * dot3(before, at.plane) > 0.0f;
  return (onward && is_mirrored) || (!onward && !is_mirrored);
}
