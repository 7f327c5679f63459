// The bodies that light is in. They may overlap; the one that was entered last counts. A body is known by the
// row of its material in caster_materials, plus 1. Needs ray.glsl and caster_material.glsl.
Bool is_full(Vec4 media) { return media.w != 0.0f; }
Vec4 with_body(Vec4 media, Float body) { return Vec4(body, media.x, media.y, media.z); }
Bool is_none(Float body) { return body == 0.0f; }
// Once more, where there is room, below all others: what counts stays so.
Vec4 with_body_again(Vec4 media, Float body) {
  Bool y = is_none(media.y);
  Bool z = !y && is_none(media.z);
  Bool w = !y && !z && is_none(media.w);
  return Vec4(media.x, sel(y, body, media.y), sel(z, body, media.z), sel(w, body, media.w));
}
Vec4 without_body(Vec4 media, Float body) {
  Bool x = media.x == body;
  Bool y = x || media.y == body;
  Bool z = y || media.z == body;
  Bool w = z || media.w == body;
  return Vec4(sel(x, media.y, media.x), sel(y, media.z, media.y), sel(z, media.w, media.z),
              sel(w, Float(0.0f), media.w));
}

// Of a body in what surrounds it: an index below 1 is relative to that, as of a bubble; others are absolute.
Float absolute_index(Float ior, Float around) { return sel(ior < 1.0f, ior * around, ior); }

Float index_in(Float body, Float around) {
  Material material = fetch_material(caster_materials, floor_to_int(body) - 1);
  Float index = absolute_index(material.ior + material.dispersion * u.bend, around);
  return sel(body > 0.0f, index, around);
}
Float index_of(Vec4 media) {
  Float index = Float(1.0f);
  if (any_lane(media.y > 0.0f)) index = index_in(media.y, index_in(media.z, index_in(media.w, index)));
  return index_in(media.x, index);
}
