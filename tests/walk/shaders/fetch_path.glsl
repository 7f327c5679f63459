// Light under way out of textures of one texel, which a test has filled.
Vec3 from_axes(IN(AxesAcross) axes, Float x, Float y) { return axes.x * x + axes.y * y; }

LightPath path_before() {
  Vec4 start = texel_fetch(start_before, Int(0), Int(0));
  Vec4 direction = texel_fetch(direction_before, Int(0), Int(0));
  Vec4 flux = texel_fetch(flux_before, Int(0), Int(0));
  Vec4 width = texel_fetch(width_before, Int(0), Int(0));
  Vec4 spread = texel_fetch(spread_before, Int(0), Int(0));
  LightPath path;
  path.ray = ray_from(Vec3(start), Vec3(direction));
  AxesAcross axes = axes_across(path.ray.direction);
  path.own = start.w - 1.0f;
  path.aside = Bool(false);
  path.parted = Bool(u.draws == 0);
  path.path = direction.w;
  path.flux = Vec3(flux);
  path.whole = flux.w;
  path.media = texel_fetch(media_before, Int(0), Int(0));
  path.width_x = from_axes(axes, width.x, width.y);
  path.width_y = from_axes(axes, width.z, width.w);
  path.spread_x = from_axes(axes, spread.x, spread.y);
  path.spread_y = from_axes(axes, spread.z, spread.w);
  return path;
}
