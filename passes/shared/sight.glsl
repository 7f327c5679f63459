// The camera's rays, from the glass or metal that a pixel shows, from surface to surface. Needs
// caster_material.glsl, caster_triangles.glsl, dressed_meeting.glsl, absorption.glsl, position_texel.glsl,
// view_space.glsl, hierarchy.glsl, interface.glsl, surface.glsl, rough_surface.glsl, hit_texel.glsl, the
// textures picture_position, view_caster_position and view_caster_normal, the uniforms of
// sight_uniforms.glsl, and radiance_aside(), what comes by a way that is not followed, and beyond_panes().
// Where the macro ONE_WAY is defined, all comes by the stronger ways.

// A ray of sight on its way.
struct Sight {
  Ray ray;
  Float own;      // the triangle that it starts on
  Vec4 media;     // the bodies that it is in
  Vec3 through;   // what is left of the radiance from its end
  Vec3 aside;     // radiance by the ways that it has not taken
  Bool mirrored;
  Float blur;     // square of the width of the slopes by which rough surfaces spread it
  Float met;      // surfaces behind the first, but for panes and what is blended
  Bool under_way;
};

// The surface that stands for all that a ray of sight has passed which scatter a share of what comes: blended
// ones, and glass that lets only a share through.
struct Sheet {
  Vec4 hit;
  Ray ray;
  Vec3 through;  // what is left of the radiance of all of them; 0: there is none
};

// The end of a ray of sight: it lies on a receiver, or the ray leaves the scene.
struct SightEnd {
  Sight sight;
  Vec4 hit;
  Vec3 point;
  Bool lands;
  Sheet sheet;
  Sight weaker;  // of the ways that it has not taken, the one that has most
};

Sight chosen(Bool condition, IN(Sight) a, IN(Sight) b) {
  Sight sight;
  sight.ray = ray_from(sel(condition, a.ray.start, b.ray.start),
                       sel(condition, a.ray.direction, b.ray.direction));
  sight.own = sel(condition, a.own, b.own);
  sight.media = sel(condition, a.media, b.media);
  sight.through = sel(condition, a.through, b.through);
  sight.aside = sel(condition, a.aside, b.aside);
  sight.mirrored = sel(condition, a.mirrored, b.mirrored);
  sight.blur = sel(condition, a.blur, b.blur);
  sight.met = sel(condition, a.met, b.met);
  sight.under_way = sel(condition, a.under_way, b.under_way);
  return sight;
}

// How far a facet that leans by a slope turns what comes, by that slope: what it mirrors twice, and so what
// passes a rough wall; what it bends, once that is in air, n - 1 times.
Float blur_by(IN(Surface) surface, IN(Material) material, IN(Meeting) at, Bool back) {
  Float more = max_of(surface.eta, 1.0f / surface.eta) - 1.0f;
  Float turned = width_of_facets(material, at) * sel(back || material.thin, Float(2.0f), more);
  return sel(surface.both.passes, Float(0.0f), turned * turned);
}

Float sum_of(Vec3 v) { return v.x + v.y + v.z; }

#ifndef ONE_WAY
// The way that a ray does not take at a surface, as if all went there.
Sight way_aside(IN(Sight) sight, IN(Surface) surface, IN(Material) material, IN(Meeting) at, Bool back) {
  Vec3 before = sight.ray.direction;
  Sight way = sight;
  way.ray = ray_from(at.point, direction_behind(surface, before, back));
  way.own = at.number;
  way.media = sel(back, sight.media, surface.both.media);
  way.through = sight.through * color_behind(surface, material, back);
  way.aside = Vec3(0.0f);
  way.mirrored = sight.mirrored || back;
  if (u.has_rough != 0) way.blur = sight.blur + blur_by(surface, material, at, back);
  way.met = sight.met + sel(material.thin, Float(0.0f), Float(1.0f));
  way.under_way = !strays(way.ray.direction, at, before, back);
  return way;
}

// Of two ways that are not taken the one that has more is kept, the other brings the sky.
void keep_more(IN(Sight) way, Bool wanted, INOUT(Sight) weaker, INOUT(Sight) sight) {
  Bool more = wanted && sum_of(way.through) > sum_of(weaker.through);
  Sight left = chosen(more, weaker, way);
  Vec3 sky = left.through * radiance_aside(left.ray.direction, left.mirrored);
  sight.aside = sel(wanted, sight.aside + sky, sight.aside);
  weaker = chosen(more, way, weaker);
}
#endif

// The way that a ray takes at a surface: the stronger; after so many straight on. Returns what is left of the
// radiance of what the surface scatters.
Vec3 turn(INOUT(Sight) sight, INOUT(Sight) aside, IN(Meeting) meeting, IN(CasterTriangle) triangle,
          Bool wanted) {
  Meeting at = meeting;
  Bool straight = sight.met >= float(u.surfaces);
  Material material = fetch_material(caster_materials, triangle.row);
  if (u.has_textures != 0) put_on_textures(at, material, triangle, wanted, Bool(false));
  Interface both = interface_at(sight.media, at, triangle, material);
  both.passes = both.passes || straight;
  Vec3 before = sight.ray.direction;
  Surface surface = smooth_surface(before, at, both, material);
  Bool back = most_is_mirrored(surface, material, surface.mirrored > 0.5f);
  Float weaker = sel(surface.one_way, Float(0.0f), min_of(surface.mirrored, 1.0f - surface.mirrored));
#ifndef ONE_WAY
  Bool first = wanted && !material.thin && sight.met < 0.0f && !sight.mirrored;
  if (u.has_walls != 0) sight.aside = sel(first, sight.aside + sight.through * beyond_panes(), sight.aside);
  Bool parts = wanted && weaker > 0.0f;
  if (any_lane(parts)) {
    Sight way = way_aside(sight, surface, material, at, !back);
    way.through = way.through * weaker;
    keep_more(way, parts, aside, sight);
  }
#endif
  sight.ray = ray_from(at.point, direction_behind(surface, before, back));
  sight.own = at.number;
  sight.mirrored = sight.mirrored || back;
  sight.media = sel(back, sight.media, both.media);
  Bool scatters = both.tints && !back && !both.passes && !material.mirror;
  Float layer = sel(scatters, material.covers * (1.0f - material.transmitted), Float(0.0f));
  Vec3 scattered = sight.through * (layer * (1.0f - weaker));
  sight.through = sight.through * (color_behind(surface, material, back) * (1.0f - weaker));
  if (u.has_rough != 0) sight.blur = sight.blur + blur_by(surface, material, at, back);
  sight.met = sight.met + sel(material.thin && !straight, Float(0.0f), Float(1.0f));
  sight.under_way = sight.under_way && !strays(sight.ray.direction, at, before, back);
  return scattered;
}

// How much there is of a receiver where a ray meets it: nothing where an alpha mask has cut it out, or where
// it is not seen from behind; of a blended one the share that it covers.
Float share_there(IN(CasterTriangle) triangle, IN(Meeting) at, Bool wanted) {
  ReceiverMaterial receiver = fetch_receiver(caster_materials, triangle.row);
  Bool blended = receiver.blended && Bool(u.has_sheets != 0);
  Bool hole = receiver.one_sided && !at.front;
  Float opacity = receiver.opacity;
  if (u.has_textures != 0) {
    Dress dress = dress_at(at, triangle, wanted);
    hole = hole || (!blended && is_cut_out(dress, triangle.row, wanted));
    if (any_lane(blended)) {
      Float of_vertices = dress.tangent.w;
      opacity = opacity * fetch_picture(picture_at(triangle.row, 4), dress.uv, Bool(false)).w;
      opacity = sel(receiver.is_colored, opacity * of_vertices, opacity);
    }
  }
  Float covers = sel(blended && opacity < receiver.opaque_from, opacity, Float(1.0f));
  return sel(wanted && hole, Float(0.0f), covers);
}

Float fraction(Float x) { return x - floor(x); }

// Another number for each surface, by the golden ratio.
Float drawn_at(Float drawn, int surface) {
  Float number = drawn + float(surface) * 0.618033989f;
  return fraction(number);
}

// Past a surface that scatters. `drawn`: chooses among all of them by what is left of each, 0..1.
void pass_sheet(INOUT(Sheet) sheet, IN(Ray) ray, Vec4 hit, Vec3 through, Float drawn) {
  sheet.through = sheet.through + through;
  Float own = sum_of(through);
  Bool takes = own > 0.0f && drawn * sum_of(sheet.through) < own;
  sheet.hit = sel(takes, hit, sheet.hit);
  sheet.ray = ray_from(sel(takes, ray.start, sheet.ray.start),
                       sel(takes, ray.direction, sheet.ray.direction));
}

// A receiver that is not all there is passed, straight on.
Sight past_receiver(IN(Sight) sight, IN(Meeting) at, Float there) {
  Sight onward = sight;
  // From beyond a hole, where its neighbour on the same edge is not met again; what a sheet lies on is.
  Float beyond = sel(there > 0.0f, Float(0.0f), Float(u.touch * 2.0f));
  onward.ray.start = at.point + sight.ray.direction * beyond;
  onward.own = at.number;
  onward.through = sight.through * (1.0f - there);
  onward.met = sight.met + sel(there > 0.0f || sight.met < 0.0f, Float(0.0f), Float(1.0f));
  return onward;
}

#define MOST_SHEETS 16

// Follows a ray through all the surfaces that it meets. The last ones do not bend it any more, so that
// it ends on something. `drawn`: as pass_sheet() has it.
SightEnd end_of_sight(IN(Sight) from, Float drawn) {
  SightEnd end;
  end.sight = from;
  end.hit = Vec4(0.0f);
  end.point = from.ray.start;
  end.lands = Bool(false);
  end.sheet.hit = Vec4(0.0f);
  end.sheet.ray = from.ray;
  end.sheet.through = Vec3(0.0f);
  end.weaker = from;
  end.weaker.through = Vec3(0.0f);
  int more = (u.has_sheets | u.has_walls) * MOST_SHEETS;
  for (int k = 0; k < u.most_surfaces + more && any_lane(end.sight.under_way); k++) {
    Sight sight = end.sight;
    Vec4 hit = hit_ahead(sight.ray, sight.own, sight.media, sight.under_way);
    Bool caster = sight.under_way && is_on_caster(hit);
    Bool receiver = sight.under_way && is_surface(hit) && !caster;
    sight.through = sel(caster || receiver, sight.through * left_by(sight.media.x, hit.z), sight.through);
    Sight next = sight;
    if (any_lane(caster || receiver)) {
      CasterTriangle triangle = fetch_triangle(sel(caster || receiver, hit.w - 1.0f, Float(0.0f)));
      Meeting at = meeting_at(triangle, hit, sight.ray.direction);
      Vec3 scattered = Vec3(0.0f);
      if (any_lane(caster)) scattered = turn(next, end.weaker, at, triangle, caster);
      Float there = share_there(triangle, at, receiver);
      Bool passed = receiver && there < 1.0f;
      scattered = sel(caster, scattered, sel(passed, sight.through * there, Vec3(0.0f)));
      if (u.has_sheets != 0) pass_sheet(end.sheet, sight.ray, hit, scattered, drawn_at(drawn, k));
      next = chosen(passed, past_receiver(sight, at, there), next);
      caster = caster || passed;
      receiver = receiver && !passed;
    }
    end.hit = sel(receiver, hit, end.hit);
    end.point = sel(receiver, point_along(sight.ray, hit.z), end.point);
    end.lands = end.lands || receiver;
    end.sight = chosen(caster, next, sight);
    end.sight.under_way = end.sight.under_way && caster && next.met < float(u.most_surfaces);
  }
  return end;
}

// Does the picture show where the ray ends?
Bool is_shown(IN(SightEnd) end) { return end.lands && shows_point(picture_position, u.view, end.point); }

// The caster that a pixel shows.
struct Front {
  Meeting at;
  CasterTriangle triangle;
  Material material;
  Vec3 highlight;  // radiance that it mirrors of the lights
};

// Water whose light is not followed is in no hierarchy: what the view shows of it is all that there is.
void be_no_triangle(INOUT(CasterTriangle) triangle, Bool is_none, Int row) {
  Vec3 none = Vec3(0.0f);
  triangle.edge1 = sel(is_none, none, triangle.edge1);
  triangle.edge2 = sel(is_none, none, triangle.edge2);
  triangle.turn1 = sel(is_none, none, triangle.turn1);
  triangle.turn2 = sel(is_none, none, triangle.turn2);
  triangle.row = sel(is_none, row, triangle.row);
  triangle.body = sel(is_none, Float(row + 1), triangle.body);
}

Front front_at(Vec4 position, Int column, Int row) {
  Vec4 normal = texel_fetch(view_caster_normal, column, row);
  Float number = triangle_number(position);
  Front front;
  front.triangle = fetch_triangle(max_of(number, 0.0f));
  if (any_lane(number < 0.0f)) be_no_triangle(front.triangle, number < 0.0f, material_row(normal));
  front.material = fetch_material(caster_materials, material_row(normal));
  front.at = meeting_in_view(position, normal);
  front.at.plane = plane_of(front.triangle, front.at.outward);
  front.at.number = number;
  front.highlight = Vec3(0.0f);
  return front;
}

// Does the pixel show that, and nothing before it?
Bool shows_front(Vec4 caster, Int column, Int row) {
  Vec4 surface = texel_fetch(picture_position, column, row);
  Float z = view_coordinates(u.view, Vec3(caster)).z;
  Float surface_z = view_coordinates(u.view, Vec3(surface)).z;
  return is_covered(caster) && (!is_covered(surface) || z < surface_z);
}

Vec3 sight_to(Vec3 p) {
  Vec3 sight = Vec3(u.forward);
  if (u.view.kind != VIEW_PARALLEL) sight = normalize_or(p - Vec3(u.eye), Vec3(u.forward));
  return sight;
}

// At the first surface both ways are followed, what it lets through and what it mirrors.
struct Ways {
  Sight behind;
  Sight mirrored;
};

Ways ways_from(IN(Front) drawn, Bool seen) {
  Front front = drawn;
  if (u.has_textures != 0) put_on_textures(front.at, front.material, front.triangle, seen, Bool(true));
  Vec3 sight = sight_to(front.at.point);
  Interface both = interface_at(Vec4(u.eye_media), front.at, front.triangle, front.material);
  Surface surface = smooth_surface(sight, front.at, both, front.material);
  Sight back;
  back.ray = ray_from(front.at.point, direction_behind(surface, sight, Bool(true)));
  back.own = front.at.number;
  back.media = Vec4(u.eye_media);
  back.aside = front.highlight * front.material.covers;
  back.mirrored = Bool(true);
  Vec3 color = color_behind(surface, front.material, Bool(true));
  back.through = sel(front.material.mirror, color, Vec3(surface.mirrored));
  back.blur = Float(0.0f);
  if (u.has_rough != 0) back.blur = blur_by(surface, front.material, front.at, Bool(true));
  back.met = sel(front.material.thin, Float(-1.0f), Float(0.0f));
  back.under_way = seen;
  Sight on = back;
  on.aside = Vec3(0.0f);
  on.ray = ray_from(front.at.point, surface.bent.direction);
  on.media = both.media;
  on.mirrored = Bool(false);
  on.through = color_behind(surface, front.material, Bool(false)) * (1.0f - surface.mirrored);
  on.through = sel(surface.one_way, Vec3(0.0f), on.through);
  if (u.has_rough != 0) on.blur = blur_by(surface, front.material, front.at, Bool(false));
  on.under_way = seen && !surface.one_way;
  Ways ways;
  ways.behind = on;
  ways.mirrored = back;
  return ways;
}
