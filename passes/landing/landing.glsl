// Where each grid vertex's light lands: bend it at the caster, find the exit, bend it again, find the
// receiver; and what happened to its flux on the way. landing.md explains.
UNIFORMS_BEGIN
#include "passes/landing/landing_uniforms.glsl"
#ifdef HAZE
#include "passes/medium/medium_uniforms.glsl"
#endif
UNIFORMS_END
TEXTURE(0, caster_position)
TEXTURE(1, caster_normal)
TEXTURE(2, caster_exit_position)
TEXTURE(3, caster_exit_normal)
TEXTURE(4, receiver_position)
TEXTURE(5, caster_materials)
TEXTURE(6, caster_tint)
TEXTURE(7, impostor_position)
TEXTURE(8, landed_before)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, landing)
OUTPUT(1, Vec4, landing_flux)
OUTPUT(2, Vec4, landing_fresnel)
OUTPUT(3, Vec4, landing_absorbed)
#ifdef HAZE
OUTPUT(4, Vec4, landing_medium)
OUTPUT(5, Vec4, landing_start)
OUTPUT(6, Vec4, landing_way)
OUTPUT(7, Vec4, landing_start_flux)
#endif
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/intersect.glsl"
#include "passes/shared/light_intensity.glsl"
#ifdef HAZE
#include "passes/medium/medium.glsl"
#endif

Hit find_surface(Texture positions, vec4 window, vec4 depth, Vec3 start, Vec3 direction,
                 bool beyond_is_behind) {
  Hit hit;
  if (u.method.y == 0) {
    hit = intersect_paper(positions, u.from_scene, window, depth, start, direction, Float(0.0f),
                          u.method.x);
  } else if (u.method.y == 2) {
    hit = intersect_newton(positions, u.from_scene, window, depth, start, direction, u.method.x);
  } else {
    hit = intersect_secant(positions, u.from_scene, window, depth, start, direction, u.method.x,
                           beyond_is_behind);
  }
  return hit;
}

// Where the light lands. Impostors are for this only: what a ray leaves a solid through is found by the secant.
Hit find_receiver(Vec3 start, Vec3 direction) {
  Hit hit;
  if (u.method.y == 3) {
    hit = intersect_impostor(impostor_position, u.impostor_from_scene, u.impostor_window, u.impostor_depth, start,
                             direction, Vec3(u.impostor_centre), u.method.x);
  } else {
    hit = find_surface(receiver_position, u.receiver_window, u.receiver_depth, start, direction, false);
  }
  return hit;
}

// The larger extent of a texel at view coordinates q, metres.
Float texel_extent(Texture t, Vec3 q, vec4 window, vec4 depth) {
  Float across = Float(1.0f / (window.x * float(texture_width(t))));
  Float along = Float(1.0f / (window.y * float(texture_height(t))));
  return view_w(q, depth) * max_of(across, along);
}

// The smooth normal where the ray leaves: interpolated where all four texels are covered and lean the same way. A
// mixture of the normals of two faces, shorter than either, is no face's own: light would leave by a crease where none goes.
Vec3 exit_normal_at(Vec3 p, Vec3 fallback) {
  Vec2 uv = view_uv(view_coordinates(u.from_scene, p), u.caster_window, u.caster_depth);
  Vec4 smooth_normal = fetch_bilinear(caster_exit_normal, uv.x, uv.y);
  Vec4 nearest = fetch_nearest(caster_exit_normal, uv.x, uv.y);
  Vec3 mixed = Vec3(smooth_normal);
  Vec3 chosen = sel(smooth_normal.w > 0.999f && dot3(mixed, mixed) > 0.95f, mixed, Vec3(nearest));
  return normalize_or(chosen, fallback);
}

Float angle_between(Vec3 a, Vec3 b) { return atan2_of(length3(cross3(a, b)), dot3(a, b)); }

// The way inside that Wyman (2005) takes: between the thickness along the light, d_V, and that along the normal,
// d_N, in the ratio of the angles of refraction and incidence. He finds d_N beforehand; here it is met in the exit map.
// d0: the light's direction; d1: inside; n: the normal against the light.
Hit thickness_of_wyman(Vec3 p, Vec3 q, Vec3 d0, Vec3 d1, Vec3 n, Float ior) {
  Vec2 uv = view_uv(q, u.caster_window, u.caster_depth);
  Vec4 behind = fetch_nearest(caster_exit_position, uv.x, uv.y);
  Hit hit = find_surface(caster_exit_position, u.caster_window, u.caster_depth, p, -n, true);
  Float incidence = angle_between(d0, -n);
  Float refraction = angle_between(d1, -n);
  Bool slanted = incidence > 1.0e-3f;
  Float ratio = sel(slanted, refraction / sel(slanted, incidence, Float(1.0f)), 1.0f / ior);
  Float along_light = max_of(dot3(Vec3(behind) - p, d0), 0.0f);
  hit.distance = along_light * ratio + max_of(hit.distance, 0.0f) * (1.0f - ratio);
  // An estimate, not a search: nothing to converge.
  hit.residual = sel(behind.w != 0.0f, Float(0.0f), Float(1.0e30f));
  return hit;
}

Float inverse(Float x) { return sel(abs(x) > 1.0e-20f, 1.0f / sel(x != 0.0f, x, Float(1.0f)), Float(1.0e20f)); }

// Does the ray, from its start on, meet the box around all receivers? (Slabs: Kay and Kajiya 1986.)
Bool meets_receivers(Vec3 start, Vec3 direction) {
  Vec3 per = Vec3(inverse(direction.x), inverse(direction.y), inverse(direction.z));
  Vec3 a = (Vec3(u.receivers_lower) - start) * per;
  Vec3 b = (Vec3(u.receivers_upper) - start) * per;
  Float enters = max_of(max_of(min_of(a.x, b.x), min_of(a.y, b.y)), min_of(a.z, b.z));
  Float leaves = min_of(min_of(max_of(a.x, b.x), max_of(a.y, b.y)), max_of(a.z, b.z));
  return leaves >= max_of(enters, Float(0.0f));
}

Float largest(Vec3 v) { return max_of(max_of(v.x, v.y), v.z); }

// The light's flux on a grid vertex's cell at view coordinates q, seen by `face`, relative to its intensity: the
// solid angle from a point, by the midpoint form.
Float solid_angle(Vec3 q, Int face, Bool covered) {
  Vec3 t = in_face(q, face, u.caster_depth);
  Float w = sel(covered, t.z, Float(1.0f));
  Float x = t.x / w;
  Float y = t.y / w;
  Float squared = 1.0f + x * x + y * y;
  return u.cell.x / (squared * sqrt(squared));
}

// Follows the light of the grid vertices that a caster covers; the others stay as they are, zeros. `face` and
// `guard` of a cube's caster map: whose tile the vertex is in, and whether beyond that face, where it belongs to
// another and carries no flux.
void follow(Vec4 entry, Vec4 entry_normal, Bool covered, Int face, Bool guard) {
  Bool from_inside = entry.w < 0.0f;
  Vec3 p1 = Vec3(entry);
  Int material = floor_to_int(entry_normal.w + 0.5f);
  Vec4 indices = fetch_clamped(caster_materials, Int(0), material);
  Vec4 absorption = fetch_clamped(caster_materials, Int(1), material);
  Bool mirrors = u.cell.w > 0.5f && indices.w > 0.5f;
  if (u.variant.x == 1) covered = covered && indices.w < 0.5f && !from_inside;
  TRACE(entry_point, p1);

  // Flux onto the cell, relative to the light's intensity: its area across parallel light; its solid
  // angle (midpoint form) from a point, times the cone's falloff.
  Vec3 q1 = view_coordinates(u.from_scene, p1);
  Vec3 d0 = Vec3(u.light);
  Float entered = Float(u.cell.x);
  if (u.caster_depth.z > 0.5f) {
    d0 = normalize_or(p1 - Vec3(u.light), Vec3(u.cone_axis));
    entered = solid_angle(q1, face, covered) * cone_falloff(d0);
  }
  entered = sel(covered && !guard, entered, Float(0.0f));
  TRACE(light_direction, d0);

  // First interface.
  Vec3 n1 = facing_normal(Vec3(entry_normal), d0, from_inside);
  Float ior = indices.x + indices.y * u.branch.w;
  Float eta1 = sel(from_inside, ior, 1.0f / ior);
  Float ci1 = clamp_to(-dot3(d0, n1), 0.0f, 1.0f);
  Float ct1_squared = transmitted_cosine_squared(eta1, ci1);
  Bool blocked1 = !mirrors && ct1_squared < 0.0f;
  Float ct1 = sqrt(max_of(ct1_squared, 0.0f));
  Vec3 d1 = refracted(d0, n1, eta1, ci1, ct1);
  Float r1 = sel(blocked1 || mirrors, Float(0.0f), fresnel_reflectance(eta1, ci1, ct1));
  d1 = sel(mirrors, reflected(d0, n1, ci1), d1);
  if (u.variant.x == 1) {
    entered = entered * r1;
    d1 = reflected(d0, n1, ci1);
    blocked1 = Bool(false);
    r1 = Float(0.0f);
  }
  TRACE(entry_normal, n1);
  TRACE(inside_direction, d1);
  TRACE(entry_reflectance, r1);

  // Second interface, where the caster is solid and the light comes from outside.
  Vec3 p2 = p1;
  Vec3 d2 = d1;
  Float r2 = Float(0.0f);
  Float inside_length = Float(0.0f);
  Bool blocked2 = Bool(false);
  Bool exit_unknown = Bool(false);
  if (u.method.w == 1 && u.variant.x == 0) {
    Bool solid = absorption.w > 0.5f && !from_inside && !blocked1;
    Hit exit;
    if (u.variant.y == 1) {
      exit = thickness_of_wyman(p1, q1, d0, d1, n1, ior);
    } else {
      exit = find_surface(caster_exit_position, u.caster_window, u.caster_depth, p1, d1, true);
    }
    Float length = max_of(exit.distance, 0.0f);
    p2 = sel(solid, p1 + d1 * length, p1);
    inside_length = sel(solid, length, Float(0.0f));
    Float tolerance =
        u.cell.y * texel_extent(caster_exit_position, q1, u.caster_window, u.caster_depth);
    exit_unknown = solid && !(exit.residual <= tolerance);
    Vec3 n2 = facing_normal(exit_normal_at(p2, -d1), d1, Bool(true));
    Float ci2 = clamp_to(-dot3(d1, n2), 0.0f, 1.0f);
    Float ct2_squared = transmitted_cosine_squared(ior, ci2);
    blocked2 = solid && ct2_squared < 0.0f;
    Float ct2 = sqrt(max_of(ct2_squared, 0.0f));
    d2 = sel(solid, refracted(d1, n2, ior, ci2, ct2), d1);
    r2 = sel(solid && !blocked2, fresnel_reflectance(ior, ci2, ct2), Float(0.0f));
    TRACE(exit_point, p2);
    TRACE(exit_residual, exit.residual);
    TRACE(exit_normal, n2);
    TRACE(exit_reflectance, r2);
  }
  TRACE(outside_direction, d2);

  Hit hit = find_receiver(p2, d2);
  Float flight = max_of(hit.distance, 0.0f);
  Vec3 p3 = p2 + d2 * flight;
  Vec3 q3 = view_coordinates(u.from_scene, p3);
  Vec2 uv3 = view_uv(q3, u.caustic_window, u.caustic_depth);
  Float tolerance =
      u.cell.z * texel_extent(receiver_position, q3, u.receiver_window, u.receiver_depth);
  if (u.method.y == 3) {
    Vec3 around = view_coordinates(u.impostor_from_scene, p3);
    tolerance = u.cell.z * texel_extent(impostor_position, around, u.impostor_window, u.impostor_depth);
  }
  Bool converged = hit.residual <= tolerance;
  TRACE(landing_point, p3);
  TRACE(landing_residual, hit.residual);

  // Through one interface only, the medium reaches down to the receiver (water on its bed).
  Bool lands = covered && !blocked1 && !blocked2 && !exit_unknown && hit.covered && converged;
  Bool open_medium = absorption.w < 0.5f && !from_inside && !mirrors && u.variant.x == 0;
  Float absorbing_length = sel(open_medium, sel(lands, flight, Float(0.0f)), inside_length);
  Vec3 passed = transmittance(Vec3(absorption), absorbing_length);
  // The base colour tints what glass lets through (KHR_materials_transmission); what metal does not mirror it
  // absorbs. What glass mirrors has no colour.
  if (u.variant.x == 0) {
    Vec3 color = Vec3(fetch_clamped(caster_materials, Int(2), material));
    if (u.variant.z == 1) color = Vec3(texel_fetch(caster_tint, floor_to_int(frag_x()), floor_to_int(frag_y())));
    passed = passed * sel(blocked1, Vec3(1.0f), color);
    if (u.cell.w > 0.5f) passed = sel(mirrors, metal_reflectance(color, ci1), passed);
  }

  // Shah et al. 2007, eq. 6 with (1/V) of the flux onto all V texels: N.L of the cell's own flux.
  Float weight = Float(1.0f);
  if (u.method.z == 1) {
    weight = ci1;
    r1 = Float(0.0f);
    r2 = Float(0.0f);
  }
  entered = entered * weight;
  Float refracted_in = entered * (1.0f - r1);
  Vec3 after_medium = passed * refracted_in;
  Vec3 carried = after_medium * (1.0f - r2);
  Vec3 absorbed = Vec3(refracted_in) - after_medium;
  Vec3 mirrored = Vec3(entered * r1) + after_medium * r2;
#ifdef HAZE
  // What the air takes before the caster; then on the way from it to the landing, or out of the medium.
  bool positional = u.caster_depth.z > 0.5f;
  Vec3 arriving = transmittance(Vec3(u.extinction), light_way(p1, d0, Vec3(u.light), positional));
  Vec3 taken = Vec3(entered) - arriving * entered;
  mirrored = mirrored * arriving;
  absorbed = absorbed * arriving;
  // What is mirrored off a dielectric came with the light that is let in, and has been booked there: what it lost
  // before is not Fresnel's.
  if (u.variant.x == 1) {
    mirrored = taken;
    taken = Vec3(0.0f);
  }
  Vec3 leaving = carried * arriving;
  Float way_out = medium_exit(p2, d2);
  Bool meets = hit.inside && hit.covered && converged;
  Bool sent = covered && !blocked1 && !blocked2 && !exit_unknown;
  Float way = sel(sent, sel(meets, min_of(flight, way_out), way_out), Float(0.0f));
  carried = leaving * transmittance(Vec3(u.extinction), way);
  taken = taken + (leaving - carried);
#endif
  Bool exhausted = !guard && largest(carried) <= entered * 1.0e-6f;

  Float status = Float(1.0f);
  status = sel(!inside_unit(uv3.x, uv3.y), Float(3.0f), status);
  status = sel(exhausted, Float(5.0f), status);
  status = sel(!converged, Float(6.0f), status);
  status = sel(!hit.covered, Float(2.0f), status);
  // What leaves the window where no receiver could be has missed them all.
  Bool strays = !hit.inside || (hit.left && !converged);
  if (any_lane(covered && strays)) {
    status = sel(strays, sel(meets_receivers(p2, d2), Float(3.0f), Float(2.0f)), status);
  }
  status = sel(exit_unknown, Float(6.0f), status);
  status = sel(blocked1 || blocked2, Float(4.0f), status);
  status = sel(covered, status, Float(0.0f));
  TRACE(status, status);

  landing = sel(covered, Vec4(p3, status), Vec4(0.0f));
  Vec3 share = Vec3(u.branch);
  landing_flux = sel(covered, Vec4(carried * share, hit.residual), Vec4(0.0f));
  landing_fresnel = sel(covered, Vec4(mirrored * share, entered), Vec4(0.0f));
  landing_absorbed = sel(covered, Vec4(absorbed * share, inside_length), Vec4(0.0f));
#ifdef HAZE
  landing_medium = sel(covered, Vec4(taken * share, Float(0.0f)), Vec4(0.0f));
  landing_start = sel(sent, Vec4(p2, way), Vec4(0.0f));
  landing_way = sel(sent, Vec4(d2, Float(1.0f)), Vec4(0.0f));
  landing_start_flux = sel(sent, Vec4(leaving * share, Float(0.0f)), Vec4(0.0f));
#endif
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 entry = texel_fetch(caster_position, column, row);
  Bool covered = entry.w != 0.0f;
  landing = Vec4(0.0f);
  landing_flux = Vec4(0.0f);
  landing_fresnel = Vec4(0.0f);
  landing_absorbed = Vec4(0.0f);
#ifdef HAZE
  landing_medium = Vec4(0.0f);
  landing_start = Vec4(0.0f);
  landing_way = Vec4(0.0f);
  landing_start_flux = Vec4(0.0f);
#endif
  if (u.variant.w == 1) covered = covered && texel_fetch(landed_before, column, row).w == 6.0f;
  Int face = Int(4);
  Bool guard = Bool(false);
  if (u.tile.w > 0.5f) {
    Float tile_column = floor((Float(column) + 0.5f) / u.tile.x);
    Float tile_row = floor((Float(row) + 0.5f) / u.tile.y);
    Float x = Float(column) - tile_column * u.tile.x;
    Float y = Float(row) - tile_row * u.tile.y;
    face = floor_to_int(tile_row * 3.0f + tile_column);
    guard = x < u.tile.z || x >= u.tile.x - u.tile.z || y < u.tile.z || y >= u.tile.y - u.tile.z;
    // What is left over at the texture's edge is no tile.
    covered = covered && tile_column < 2.5f && tile_row < 1.5f;
  }
  if (any_lane(covered)) follow(entry, texel_fetch(caster_normal, column, row), covered, face, guard);
}
#endif
