// Whether a point, in view coordinates, stands between the light and the casters: inside the column's window
// and nearer than the casters' nearest point. Needs view_space.glsl.
Bool stands_before_casters(IN(View) column, float casters_nearest, Vec3 q) {
  Bool before = Bool(false);
  if (column.kind == VIEW_CUBE) {
    // All around: nearer than any caster, whatever the direction.
    before = length3(q) < casters_nearest;
  } else {
    Vec2 uv = view_uv(column, q);
    before = inside_unit(uv.x, uv.y) && q.z < casters_nearest;
  }
  return before;
}
