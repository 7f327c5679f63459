// Whether a point, in view coordinates, stands between the light and the casters: inside the column's
// window and nearer than the casters' nearest point. Expects the uniforms column (window) and
// column_depth (depth; w: the casters' nearest z).
Bool stands_before_casters(Vec3 q) {
  Bool before = Bool(false);
  if (u.column_depth.z > 1.5f) {
    // All around: nearer than any caster, whatever the direction.
    before = length3(q) < u.column_depth.w;
  } else {
    Vec2 uv = view_uv(q, u.column, u.column_depth);
    before = inside_unit(uv.x, uv.y) && q.z < u.column_depth.w;
  }
  return before;
}
