// Light from a source with a size, at a grid vertex: from a point of it that is the vertex' own. Needs
// axes_across.glsl, cone_falloff.glsl, grid_light.glsl, light_path.glsl, microfacets.glsl, refraction.glsl,
// way_draw.glsl, the texture hierarchy_normals, and the uniforms light_middle, light_width, light_height,
// light_radius, light_points and light_shape.

// A point of a disk of radius 1.
Vec2 on_disk(Float share, Float turn) {
  Vec2 way = Vec2(wave(turn + 0.25f), wave(turn));
  return way * sqrt(share / dot2(way, way));
}

// The point of a ball, which looks like a disk from everywhere, or of a rectangle, where the light starts
// that meets p. Near a ball that shines as a Lambertian surface its outline is wider than the ball is.
Vec3 drawn_origin(Vec3 p, Vec2 drawn) {
  Vec3 origin = Vec3(u.light_middle) + Vec3(u.light_width) * (drawn.x - 0.5f) +
                Vec3(u.light_height) * (drawn.y - 0.5f);
  if (u.light_shape == 1 || u.light_shape == 4) {
    Vec3 way = p - Vec3(u.light_middle);
    AxesAcross axes = axes_across(normalize_or(way, Vec3(0.0f, 0.0f, 1.0f)));
    Vec2 at = on_disk(drawn.x, drawn.y) * Float(u.light_radius);
    if (u.light_shape == 4)
      at = at / sqrt(max_of(1.0f - dot2(at, at) / max_of(dot3(way, way), 1.0e-20f), 1.0e-4f));
    origin = Vec3(u.light_middle) + (axes.x * at.x + axes.y * at.y);
  }
  return origin;
}

// The point of a light near by that sends light to p.
struct Start {
  Vec3 point;
  Vec3 direction;  // to p
  Float toward;    // how much of it the light sends that way, of the most
};

// `number` is the whole number that the vertex has drawn: of a mesh that is neither ball nor rectangle the
// place of a point in its list.
Start start_of(Vec3 p, Float number, Vec2 drawn, Vec3 otherwise) {
  Start start;
  if (u.light_shape == 5) {
    Int texel = u.light_points + Int(number) * 2;
    start.point = Vec3(table_fetch(hierarchy_normals, texel, 0));
    start.direction = normalize_or(p - start.point, otherwise);
    start.toward = max_of(dot3(Vec3(table_fetch(hierarchy_normals, texel, 1)), start.direction), 0.0f);
  } else {
    start.point = drawn_origin(p, drawn);
    start.direction = normalize_or(p - start.point, otherwise);
    start.toward = cone_falloff(u.cone, start.direction);
  }
  return start;
}

// As light_from_view, which is from the point that shows the light's view the vertex: the cell's part of the
// surface is the same, but the light falls onto it from elsewhere. `plane`: the triangle's normal.
Incident light_of_size(IN(GridCell) cell, Vec3 p, Vec3 plane, Float number) {
  Vec2 drawn = Vec2(drawn_share(number), drawn_share(next_facet_draw(number)));
  Incident middle = light_from_view(cell, p);
  Incident light = middle;
  Float nearer = Float(1.0f);
  if (u.light_shape == 3) {
    AxesAcross axes = axes_across(Vec3(u.light_middle));
    Vec2 at = on_disk(drawn.x, drawn.y) * Float(u.light_radius);
    light.direction = normalize_or(Vec3(u.light_middle) + (axes.x * at.x + axes.y * at.y), middle.direction);
    light.from = light.direction;
  } else {
    Start start = start_of(p, number, drawn, middle.direction);
    Vec3 way = p - start.point;
    Vec3 from_middle = p - Vec3(u.light);
    light.from = start.point;
    light.direction = start.direction;
    nearer = dot3(from_middle, from_middle) / max_of(dot3(way, way), 1.0e-20f);
    if (u.light_shape == 4) {
      Vec3 to_ball = p - Vec3(u.light_middle);
      Float along = max_of(dot3(to_ball, to_ball), 1.0e-20f);
      nearer = dot3(from_middle, from_middle) / along * sqrt(dot3(way, way) / along);
    }
    light.flux = solid_angle(view_coordinates(u.caster, p), cell.face, cell.covered) * start.toward;
    light.flux = sel(cell.covered && !cell.guard, light.flux, Float(0.0f));
  }
  Float before = dot3(middle.direction, plane);
  Float facing = dot3(light.direction, plane) / sel(abs(before) > 0.02f, before, Float(0.02f));
  light.flux = light.flux * (nearer * clamp_to(facing, 0.0f, 16.0f));
  TRACE(light_direction, light.direction);
  return light;
}

// Widens each footprint by a quarter of the light's radius, so that those of neighbours overlie each other;
// the width is added along the axes in which the light is wide already.
void spread_by_size(INOUT(LightPath) path) {
  Float radius = Float(u.light_radius);
  if (u.light_shape != 3)
    radius = radius / max_of(length3(path.ray.start - Vec3(u.light_middle)), 1.0e-20f);
  Vec3 d = path.ray.direction;
  AxesAcross axes = axes_across(d);
  Vec3 x = normalize_or(path.width_x - d * dot3(path.width_x, d), axes.x);
  Vec3 y = cross3(d, x);
  path.spread_x = path.spread_x + x * (radius * 0.25f);
  path.spread_y = path.spread_y + sel(dot3(y, path.width_y) < 0.0f, -y, y) * (radius * 0.25f);
}
