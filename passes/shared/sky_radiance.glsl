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

Vec3 sky_radiance(IN(Sky) sky, Vec3 d) {
  // Without an image: from the horizon up a linear ramp of the height, below it a quick one to the ground.
  Float up = clamp_to(d.y, 0.0f, 1.0f);
  Float below = clamp_to(d.y * -5.0f, 0.0f, 1.0f);
  Vec3 horizon = Vec3(sky.horizon);
  Vec3 color = horizon + (Vec3(sky.zenith) - horizon) * up + (Vec3(sky.ground) - horizon) * below;
  if (sky.has_image != 0) color = image_radiance(sky, d);
  return color;
}
