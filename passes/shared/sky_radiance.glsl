// Radiance of the environment along a unit direction, nit. Expects the texture environment.

// Equirectangular: unless it is turned the picture's middle looks along -z, +x lies to the right of it.
Vec3 image_radiance(IN(Sky) sky, Vec3 d) {
  Float right = d.x * sky.turn.x - d.z * sky.turn.y;
  Float back = d.z * sky.turn.x + d.x * sky.turn.y;
  Float turn = atan2_of(right, -back) * 0.159154943f + 0.5f;
  Float rise = atan2_of(d.y, sqrt(d.x * d.x + d.z * d.z)) * 0.318309886f + 0.5f;
  Float width = Float(texture_width(environment));
  Float x = turn * width - 0.5f;
  Float y = rise * Float(texture_height(environment)) - 0.5f;
  Int x0 = floor_to_int(x);
  Int y0 = floor_to_int(y);
  Float fx = clamp_to(x - Float(x0), 0.0f, 1.0f);
  Float fy = clamp_to(y - Float(y0), 0.0f, 1.0f);
  Int columns = Int(texture_width(environment));
  Int xa = sel(x0 < 0, x0 + columns, x0);
  Int xb = sel(xa + 1 >= columns, Int(0), xa + 1);
  Vec4 low = fetch_clamped(environment, xa, y0) * (1.0f - fx) +
             fetch_clamped(environment, xb, y0) * fx;
  Vec4 high = fetch_clamped(environment, xa, y0 + 1) * (1.0f - fx) +
              fetch_clamped(environment, xb, y0 + 1) * fx;
  return Vec3(low * (1.0f - fy) + high * fy);
}

// Without an image: from the horizon up a linear ramp of the height, below it a quick one to `ground`.
Vec3 gradient_radiance(IN(Sky) sky, Vec3 ground, Vec3 d) {
  Float up = clamp_to(d.y, 0.0f, 1.0f);
  Float below = clamp_to(d.y * -5.0f, 0.0f, 1.0f);
  Vec3 horizon = Vec3(sky.horizon);
  return horizon + (Vec3(sky.zenith) - horizon) * up + (ground - horizon) * below;
}

// 1 within 0.7 of half a side, smooth to 0 at its end.
Float box_edge(Float x, float side) {
  Float t = clamp_to((side - abs(x)) / (0.3f * side), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// Radiance of a soft box along d, all channels.
Float box_radiance(IN(SoftBox) box, Vec3 d) {
  Float along = dot3(d, Vec3(box.middle));
  Bool ahead = along > 0.0f;
  Float w = sel(ahead, along, Float(1.0f));
  Float x = box_edge(dot3(d, Vec3(box.across)) / w, box.half_width);
  Float y = box_edge(dot3(d, Vec3(box.upward)) / w, box.half_height);
  return sel(ahead, box.radiance * (x * y), Float(0.0f));
}

Vec3 sky_over(IN(Sky) sky, Vec3 ground, Vec3 d) {
  Vec3 color = gradient_radiance(sky, ground, d);
  if (sky.has_boxes != 0)
    color = color + Vec3(box_radiance(sky.key, d) + box_radiance(sky.rim, d) + box_radiance(sky.fill, d));
  if (sky.has_image != 0) color = image_radiance(sky, d);
  return color;
}

// As it is mirrored.
Vec3 sky_radiance(IN(Sky) sky, Vec3 d) { return sky_over(sky, Vec3(sky.ground), d); }

// As glass shows it: below the horizon clear glass is as bright as what is seen beside it.
Vec3 sky_in_glass(IN(Sky) sky, Vec3 d, Bool mirrored) {
  return sky_over(sky, sel(mirrored, Vec3(sky.ground), Vec3(sky.backdrop)), d);
}

// As it is seen directly: without soft boxes.
Vec3 backdrop_radiance(IN(Sky) sky, Vec3 d) {
  Vec3 color = gradient_radiance(sky, Vec3(sky.backdrop), d);
  if (sky.has_image != 0) color = image_radiance(sky, d);
  return color;
}
