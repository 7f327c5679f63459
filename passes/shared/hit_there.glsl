// The next surface on a ray that is there: alpha masks have cut holes into receivers. Needs
// dressed_meeting.glsl, hierarchy.glsl, hit_texel.glsl, and the uniforms has_cut_outs and touch.

#define MOST_HOLES 8

// As hit_ahead.
Vec4 hit_there(IN(Ray) ray, Float own, Vec4 media, Bool walks) {
  Vec4 hit = Vec4(0.0f);
  Ray onward = ray;
  Float from = own;
  Float way = Float(0.0f);
  Bool searches = walks;
  for (int k = 0; k <= u.has_cut_outs * MOST_HOLES && any_lane(searches); k++) {
    Vec4 ahead = hit_ahead(onward, from, media, searches);
    hit = sel(searches, Vec4(ahead.x, ahead.y, ahead.z + way, ahead.w), hit);
    searches = searches && u.has_cut_outs != 0 && is_surface(ahead) && !is_on_caster(ahead);
    if (any_lane(searches)) {
      CasterTriangle triangle = fetch_triangle(sel(searches, ahead.w - 1.0f, Float(0.0f)));
      Meeting at = meeting_at(triangle, ahead, ray.direction);
      searches = is_cut_out(dress_at(at, triangle, searches), triangle.row, searches);
      // From beyond it, where its neighbour on the same edge is not met again.
      Float beyond = Float(u.touch * 2.0f);
      onward = ray_from(at.point + ray.direction * beyond, ray.direction);
      from = at.number;
      way = way + (ahead.z + beyond);
    }
  }
  return hit;
}
