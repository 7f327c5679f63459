// What changes where a ray meets a caster's surface. Needs caster_material.glsl, caster_triangles.glsl,
// media.glsl, meeting.glsl, and the uniform bend.

Interface interface_at(Vec4 media, IN(Meeting) at, IN(CasterTriangle) triangle, IN(Material) material) {
  Float ior = material.ior + material.dispersion * u.bend;
  Bool within = is_in_body(media, triangle.body);
  Vec4 left = without_body(media, triangle.body);
  Vec4 entered = sel(within, with_body_again(media, triangle.body), with_body(media, triangle.body));
  Interface both;
  Bool stays = at.hole || material.thin;
  both.media = sel(stays, media, sel(at.front, entered, left));
  both.passes = at.hole || (within && (at.front || is_in_body(left, triangle.body)));
  both.overflow = at.front && !within && !stays && is_full(media);
  both.tints = at.front || !within;
  Float here = index_of(media);
  // Light that comes from inside without having entered began there.
  Float there = sel(at.front || !within, here, index_of(both.media));
  both.before = sel(!at.front && !within, absolute_index(ior, there), here);
  both.behind = sel(at.front, absolute_index(ior, here), there);
  return both;
}
