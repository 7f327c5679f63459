// A surface's textures where light or sight meets it. Needs caster_material.glsl,
// caster_triangles.glsl, material.glsl, tangent_space.glsl, the textures caster_materials, caster_texels and
// hierarchy_normals, and the uniform first_uv.

// One of a material's pictures, as three texels of its row in caster_materials tell.
struct Picture {
  Vec4 part;  // xy: its first texel in caster_texels, zw: its sides, texels; 0: there is none
  Vec4 u;     // KHR_texture_transform: u' = u.xyz . (u, v, 1); w: how it goes on beyond its sides
  Vec4 v;     // likewise v'; and 4 more where it is not interpolated
};

Bool is_there(IN(Picture) picture) {
  Float width = picture.part.z;
  return width > 0.0f;
}

Picture picture_at(Int row, int column) {
  Picture picture;
  picture.part = fetch_clamped(caster_materials, Int(column), row);
  picture.u = fetch_clamped(caster_materials, Int(column + 1), row);
  picture.v = fetch_clamped(caster_materials, Int(column + 2), row);
  return picture;
}

// A picture that is not there is white.
Vec4 fetch_picture(IN(Picture) picture, Vec2 uv, Bool finest) {
  Int wrap_u = floor_to_int(picture.u.w);
  Int how = floor_to_int(picture.v.w);
  Bool nearest = how > 3;
  Int wrap_v = how - sel(nearest, Int(4), Int(0));
  Float u = picture.u.x * uv.x + picture.u.y * uv.y + picture.u.z;
  Float v = picture.v.x * uv.x + picture.v.y * uv.y + picture.v.z;
  TexelPair columns = texels_around(floor_to_int(picture.part.z), wrapped_along(u, wrap_u), wrap_u);
  TexelPair rows = texels_around(floor_to_int(picture.part.w), wrapped_along(v, wrap_v), wrap_v);
  Bool one = nearest || finest;
  columns.between = sel(one, floor(columns.between + 0.5f), columns.between);
  rows.between = sel(one, floor(rows.between + 0.5f), rows.between);
  Vec4 texel =
      fetch_around(caster_texels, columns, rows, floor_to_int(picture.part.x), floor_to_int(picture.part.y));
  return sel(is_there(picture), texel, Vec4(1.0f));
}

// A place's texture coordinates and tangent.
struct Dress {
  Vec2 uv;
  Vec4 tangent;
};

Dress dress_at(IN(Meeting) at, IN(CasterTriangle) triangle, Bool wanted) {
  Vec2 w = weights_at(triangle, at.point - triangle.corner);
  Float first = 1.0f - w.x - w.y;
  Int texel = u.first_uv + Int(sel(wanted, at.number, Float(0.0f))) * 5;
  Vec4 ab = table_fetch(hierarchy_normals, texel, 0);
  Vec4 c = table_fetch(hierarchy_normals, texel, 1);
  Dress dress;
  dress.uv = Vec2(ab.x * first + ab.z * w.x + c.x * w.y, ab.y * first + ab.w * w.x + c.y * w.y);
  dress.tangent = table_fetch(hierarchy_normals, texel, 2) * first +
                  table_fetch(hierarchy_normals, texel, 3) * w.x +
                  table_fetch(hierarchy_normals, texel, 4) * w.y;
  return dress;
}

// The normal as its texture leans it (textured_surface.glsl).
Vec3 dressed_normal(Vec3 n, IN(Dress) dress, Int row) {
  Picture picture = picture_at(row, 10);
  Vec3 local = tangent_space_normal(fetch_picture(picture, dress.uv, Bool(false)),
                                    fetch_clamped(caster_materials, Int(3), row).y);
  local.z = max_of(local.z, 0.01f);
  return sel(is_there(picture), leaned_normal(n, dress.tangent, local), n);
}

// Has an alpha mask cut the surface out there?
Bool is_cut_out(IN(Dress) dress, Int row, Bool wanted) {
  Vec4 of_surface = fetch_clamped(caster_materials, Int(3), row);
  Float opacity = of_surface.z;
  Float cutoff = of_surface.w;
  Bool masked = wanted && cutoff > 0.0f;
  Bool hole = Bool(false);
  if (any_lane(masked))
    hole = masked && fetch_picture(picture_at(row, 4), dress.uv, Bool(true)).w * opacity < cutoff;
  return hole;
}

// Colour, transmission, holes and normal at a place. `wanted`: there is a caster; `is_drawn`: it is what the
// caster map shows there, whose normal leans already, and where there is no hole.
void put_on_textures(INOUT(Meeting) at, INOUT(Material) material, IN(CasterTriangle) triangle,
                     Bool wanted, Bool is_drawn) {
  Int row = triangle.row;
  Dress dress = dress_at(at, triangle, wanted);
  Picture base = picture_at(row, 4);
  Vec3 grey = Vec3(sel(material.mirror, material.transmitted, Float(0.0f)));
  Vec4 texel = fetch_picture(base, dress.uv, Bool(false));
  material.color = grey + (material.color - grey) * Vec3(texel);
  material.covers = sel(material.blended, material.covers * texel.w, material.covers);
  material.transmitted =
      material.transmitted * fetch_picture(picture_at(row, 7), dress.uv, Bool(false)).x;
  at.hole = at.hole || is_cut_out(dress, row, wanted && !is_drawn);
  if (any_lane(!is_drawn)) at.outward = sel(is_drawn, at.outward, dressed_normal(at.outward, dress, row));
}
