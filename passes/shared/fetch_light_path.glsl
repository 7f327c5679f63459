// Light under way out of the ray textures (ray_state.glsl), which shaders have as path_start to path_spread.
// Needs axes_across.glsl and light_path.glsl.
Vec3 across_from(IN(AxesAcross) axes, Float x, Float y) { return axes.x * x + axes.y * y; }

LightPath fetch_light_path(Int column, Int row) {
  Vec4 start = texel_fetch(path_start, column, row);
  Vec4 direction = texel_fetch(path_direction, column, row);
  Vec4 flux = texel_fetch(path_flux, column, row);
  Vec4 width = texel_fetch(path_width, column, row);
  Vec4 spread = texel_fetch(path_spread, column, row);
  LightPath path;
  path.ray = ray_from(Vec3(start), Vec3(direction));
  AxesAcross axes = axes_across(path.ray.direction);
  path.path = direction.w;
  path.flux = Vec3(flux);
  path.whole = flux.w;
  path.media = texel_fetch(path_media, column, row);
  path.width_x = across_from(axes, width.x, width.y);
  path.width_y = across_from(axes, width.z, width.w);
  path.spread_x = across_from(axes, spread.x, spread.y);
  path.spread_y = across_from(axes, spread.z, spread.w);
  return path;
}
