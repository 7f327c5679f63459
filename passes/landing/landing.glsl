// Where each grid vertex's light lands: bend it at the caster, find the exit, bend it again, find the
// receiver; and what happened to its flux on the way. landing.md explains.
#include "passes/shared/light_cone.glsl"
#include "passes/shared/homogeneous_medium.glsl"
UNIFORMS_BEGIN
#include "passes/landing/landing_uniforms.glsl"
#ifdef HAZE
Medium medium;
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
TEXTURE(9, caster_flux)
TEXTURE(10, reaching)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, landing)
OUTPUT(1, Vec4, landing_flux)
OUTPUT(2, Vec4, landing_fresnel)
OUTPUT(3, Vec4, landing_absorbed)
#ifdef HAZE
OUTPUT(4, Vec4, landing_medium)
OUTPUT(5, Vec4, stretch_start)
OUTPUT(6, Vec4, stretch_way)
OUTPUT(7, Vec4, stretch_flux)
#endif
#include "passes/shared/caster_material.glsl"
#include "passes/shared/cone_falloff.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/landing_status.glsl"
#include "passes/shared/axes_across.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/meeting.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/refraction.glsl"
#include "passes/shared/surface.glsl"
#include "passes/shared/smooth_surface.glsl"
#include "passes/shared/view_space.glsl"
#ifdef HAZE
#include "passes/shared/medium_optics.glsl"
#endif
#include "passes/shared/grid_light.glsl"
#include "passes/shared/intersect.glsl"
#include "passes/shared/receivers_box.glsl"
#include "passes/shared/fly_to_receiver.glsl"

// Enter the caster: a grid vertex, the light's flux on its cell, the first surface.

struct Entry {
  Bool covered;     // there is a caster here, and its light is to be followed
  Meeting at;
  Material material;
  GridCell cell;
  Vec3 reaching;    // what panes and blended surfaces before it leave of the light
};

Entry entry_at(Int column, Int row) {
  Vec4 position = texel_fetch(caster_position, column, row);
  Entry entry;
  entry.at = meeting_in_view(position, Vec4(0.0f));
  entry.cell = cell_of(column, row, is_covered(position));
  entry.covered = entry.cell.covered;
  entry.reaching = Vec3(1.0f);
  if (u.is_tinted != 0) entry.reaching = Vec3(texel_fetch(reaching, column, row));
  if (u.only_unconverged != 0) {
    Vec4 before = texel_fetch(landed_before, column, row);
    entry.covered = entry.covered && has_status(before, STATUS_NOT_CONVERGED);
  }
  return entry;
}

// What the surface is like that the light enters by.
void find_surface_of(Int column, Int row, INOUT(Entry) entry) {
  Vec4 normal = texel_fetch(caster_normal, column, row);
  entry.at.outward = Vec3(normal);
  entry.material = fetch_material(caster_materials, material_row(normal));
  if (u.has_caster_tint != 0) entry.material.color = Vec3(texel_fetch(caster_tint, column, row));
  // What metal mirrors is the whole of its light, and followed as such.
  if (u.is_reflection != 0) {
    Bool outside = entry.at.front || entry.material.thin;
    entry.covered = entry.covered && !entry.material.mirror && outside;
  }
  entry.material.mirror = entry.material.mirror && u.has_mirrors != 0;
}

struct FirstSurface {
  Surface surface;
  Vec3 direction;     // of the light that goes on: refracted, or mirrored by metal
  Float flux;         // that this branch has of the light on the cell,
  Float reflectance;  // and how much of it the surface keeps off
  Bool blocked;       // total internal reflection
};

// Shah et al. 2007, eq. 6: (1/V) of the light onto all V grid vertices, whatever falls on this one.
Float equal_part(IN(Entry) entry) {
  Vec4 onto_casters = texel_fetch(caster_flux, Int(0), Int(0));
  Float mean = u.cell_area * (onto_casters.x / max_of(onto_casters.y, Float(1.0f)));
  return sel(entry.covered && !entry.cell.guard, mean, Float(0.0f));
}

// A surface of one body alone, with air around it.
Interface skin_of(IN(Material) material, Bool from_inside) {
  Float ior = material.ior + material.dispersion * u.bend;
  Interface skin;
  skin.before = sel(from_inside, ior, Float(1.0f));
  skin.behind = sel(from_inside, Float(1.0f), ior);
  skin.media = Vec4(0.0f);
  skin.passes = Bool(false);
  skin.overflow = Bool(false);
  skin.tints = Bool(true);
  return skin;
}

FirstSurface enter_caster(IN(Entry) entry, IN(Incident) light) {
  Interface skin = skin_of(entry.material, !entry.at.front);
  FirstSurface first;
  first.surface = smooth_surface(light.direction, entry.at, skin, entry.material);
  first.direction =
      direction_behind(first.surface, light.direction, entry.material.mirror || u.is_reflection != 0);
  first.flux = light.flux;
  first.blocked = first.surface.total;
  first.reflectance = sel(first.blocked || entry.material.mirror, Float(0.0f), first.surface.mirrored);
  if (u.is_reflection != 0) {
    first.flux = light.flux * first.reflectance;
    first.blocked = Bool(false);
    first.reflectance = Float(0.0f);
  }
  TRACE(entry_normal, first.surface.normal);
  TRACE(inside_direction, first.direction);
  TRACE(entry_reflectance, first.reflectance);
  return first;
}

// Cross the caster: the way inside, the second surface.

Float angle_between(Vec3 a, Vec3 b) { return atan2_of(length3(cross3(a, b)), dot3(a, b)); }

// The way inside that Wyman (2005) takes: between the thickness along the light, d_V, and that along the
// normal, d_N, in the ratio of the angles of refraction and incidence. He finds d_N beforehand, exactly; here
// the secant finds it in the exit map, whatever estimator lands the light.
Hit thickness_of_wyman(Vec3 p, Vec3 light_direction, IN(FirstSurface) first) {
  Vec2 uv = view_uv(u.caster, view_coordinates(u.caster, p));
  Vec4 behind = fetch_nearest(caster_exit_position, uv.x, uv.y);
  Search search = search_along(u.caster, ray_from(p, -first.surface.normal), u.iterations, true);
  Hit hit = intersect_secant(caster_exit_position, u.caster, search);
  Float incidence = angle_between(light_direction, -first.surface.normal);
  Float refraction = angle_between(first.direction, -first.surface.normal);
  Bool slanted = incidence > 1.0e-3f;
  Float inverse = 1.0f / first.surface.both.behind;
  Float ratio = sel(slanted, refraction / sel(slanted, incidence, Float(1.0f)), inverse);
  Float along_light = max_of(dot3(Vec3(behind) - p, light_direction), 0.0f);
  hit.distance = along_light * ratio + max_of(hit.distance, 0.0f) * (1.0f - ratio);
  // An estimate, not a search: nothing to converge.
  hit.residual = sel(is_covered(behind), Float(0.0f), lost_residual());
  return hit;
}

Hit find_exit(IN(Entry) entry, Vec3 light_direction, IN(FirstSurface) first) {
  Hit hit;
  if (u.wyman_thickness != 0) {
    hit = thickness_of_wyman(entry.at.point, light_direction, first);
  } else {
    Ray ray = ray_from(entry.at.point, first.direction);
    hit = find_surface(caster_exit_position, u.caster, search_along(u.caster, ray, u.iterations, true));
  }
  return hit;
}

// The smooth normal where the ray leaves: interpolated where all four texels are covered and lean the same
// way. A mixture of the normals of two faces, shorter than either, is no face's own: light would leave by a
// crease where none goes.
Vec3 exit_normal_at(Vec3 p, Vec3 fallback) {
  Vec2 uv = view_uv(u.caster, view_coordinates(u.caster, p));
  Vec4 smooth_normal = fetch_bilinear(caster_exit_normal, uv.x, uv.y);
  Vec4 nearest = fetch_nearest(caster_exit_normal, uv.x, uv.y);
  Vec3 mixed = Vec3(smooth_normal);
  Vec3 chosen = sel(is_fully_covered(smooth_normal) && dot3(mixed, mixed) > 0.95f, mixed, Vec3(nearest));
  return normalize_or(chosen, fallback);
}

// The light as it leaves the caster.
struct Exit {
  Ray ray;
  Float inside_length;  // metres
  Float reflectance;    // of the second surface
  Bool blocked;         // total internal reflection, at either surface
  Bool unknown;         // no second surface was met
  Bool stopped;         // nor was it, but the light goes on from where the search stopped
  Bool sent;            // light leaves, and it is known where
};

// The light that leaves where it has entered: by an open surface, or mirrored.
Exit straight_exit(IN(Entry) entry, IN(FirstSurface) first) {
  Exit exit;
  exit.ray = ray_from(entry.at.point, first.direction);
  exit.inside_length = Float(0.0f);
  exit.reflectance = Float(0.0f);
  exit.blocked = first.blocked;
  exit.unknown = Bool(false);
  exit.stopped = Bool(false);
  return exit;
}

// Light that comes into a solid caster from outside leaves it by a second surface.
Exit cross_caster(IN(Entry) entry, Vec3 light_direction, IN(FirstSurface) first) {
  Exit exit = straight_exit(entry, first);
  if (u.has_exit_maps != 0 && u.is_reflection == 0) {
    Bool solid = entry.material.solid && entry.at.front && !first.blocked;
    Hit hit = find_exit(entry, light_direction, first);
    Float length = max_of(hit.distance, 0.0f);
    exit.inside_length = sel(solid, length, Float(0.0f));
    exit.ray.start = sel(solid, point_along(exit.ray, length), entry.at.point);
    Vec3 outward = exit_normal_at(exit.ray.start, -first.direction);
    Float tolerance = u.exit_tolerance * texel_extent_at(caster_exit_position, u.caster, entry.at.point);
    // Along the light a gap is longer than across the surface. What leans by more than 83 degrees may be the
    // edge of a layer that hides the exit.
    Float leaning = max_of(abs(dot3(outward, light_direction)), 0.125f);
    exit.unknown = solid && !(hit.residual * leaning <= tolerance);
    if (u.draws_unconverged != 0) {
      exit.stopped = exit.unknown && is_found(hit);
      exit.unknown = exit.unknown && !exit.stopped;
    }
    Meeting at = meeting_in_view(Vec4(exit.ray.start, Float(-1.0f)), Vec4(outward, Float(0.0f)));
    Interface skin = skin_of(entry.material, Bool(true));
    Surface last = smooth_surface(first.direction, at, skin, entry.material);
    Refraction bent = last.bent;
    exit.blocked = first.blocked || (solid && bent.total && !exit.unknown);
    exit.ray.direction = sel(solid, bent.direction, first.direction);
    exit.reflectance = sel(solid && !bent.total, last.mirrored, Float(0.0f));
    TRACE(exit_point, exit.ray.start);
    TRACE(exit_residual, hit.residual);
    TRACE(exit_normal, last.normal);
    TRACE(exit_reflectance, exit.reflectance);
  }
  exit.sent = entry.covered && !exit.blocked && !exit.unknown;
  TRACE(outside_direction, exit.ray.direction);
  return exit;
}

// Book the flux.

struct Account {
  Float entered;   // on the cell
  Vec3 mirrored;   // at the surfaces
  Vec3 absorbed;   // in the material
  Vec3 leaving;    // from the caster
  Vec3 carried;    // to the landing
#ifdef HAZE
  Vec3 taken;      // by the air, before the caster and after it,
  Float air_way;   // along which it goes so far, metres
#endif
};

// What the material lets through: by its length, and by its colour, which tints what glass lets through
// (KHR_materials_transmission); what metal does not mirror it absorbs. What glass mirrors has no colour.
Vec3 let_through(IN(Entry) entry, IN(FirstSurface) first, IN(Exit) exit, Float absorbing_length) {
  Vec3 passed = transmittance(entry.material.absorption, absorbing_length);
  if (u.is_reflection == 0) {
    Vec3 color = entry.material.color;
    Vec3 tint = color * entry.material.transmitted;
    // A closed body of walls tints what passes at both of them; solid glass once.
    if (u.has_walls != 0)
      tint = sel(entry.material.thin && entry.material.solid && entry.at.front, tint * tint, tint);
    passed = passed * sel(first.blocked, Vec3(1.0f), tint);
    if (u.has_mirrors != 0)
      passed = sel(entry.material.mirror, metal_reflectance(color, first.surface.bent.cosine), passed);
  }
  return passed;
}

// Is there one interface only, and water behind it, not air?
Bool is_open(IN(Entry) entry) {
  return !entry.material.solid && entry.at.front && !entry.material.mirror && u.is_reflection == 0;
}

Account book_caster(IN(Entry) entry, IN(FirstSurface) first, IN(Exit) exit, IN(Landing) end) {
  // Through one interface only, the material reaches down to the receiver (water on its bed).
  Bool lands = exit.sent && end.hit.covered && end.lands;
  Bool open = is_open(entry);
  Float absorbing_length = sel(open, sel(lands, end.flight, Float(0.0f)), exit.inside_length);
  Vec3 passed = let_through(entry, first, exit, absorbing_length);
  // Shah et al. 2007, eq. 6 and 7: N.L of it, and no Fresnel.
  Float weight = Float(1.0f);
  Float reflectance1 = first.reflectance;
  Float reflectance2 = exit.reflectance;
  if (u.paper_weights != 0) {
    weight = first.surface.bent.cosine;
    reflectance1 = Float(0.0f);
    reflectance2 = Float(0.0f);
  }
  Account account;
  account.entered = first.flux * weight;
  Float let_in = account.entered * (1.0f - reflectance1);
  Vec3 inside = passed * let_in;
  account.leaving = inside * (1.0f - reflectance2);
  account.absorbed = Vec3(let_in) - inside;
  account.mirrored = Vec3(account.entered * reflectance1) + inside * reflectance2;
  account.carried = account.leaving;
  return account;
}

#ifdef HAZE
// What the air takes before the caster; then on the way from it to the landing, or out of the medium.
void book_air(IN(Entry) entry, Vec3 from, IN(Exit) exit, IN(Landing) end, INOUT(Account) account) {
  Vec3 arriving = transmittance(Vec3(u.medium.extinction), air_before(entry.at.point, from));
  Vec3 taken = Vec3(account.entered) - arriving * account.entered;
  account.mirrored = account.mirrored * arriving;
  account.absorbed = account.absorbed * arriving;
  // What is mirrored off a dielectric came with the light that is let in, and has been booked there: what it
  // lost before is not Fresnel's.
  if (u.is_reflection != 0) {
    account.mirrored = taken;
    taken = Vec3(0.0f);
  }
  account.leaving = account.leaving * arriving;
  Float way_out = medium_exit(u.medium, exit.ray);
  Bool meets = end.hit.inside && end.hit.covered && end.lands;
  Bool in_air = exit.sent && !is_open(entry);
  account.air_way = sel(in_air, sel(meets, min_of(end.flight, way_out), way_out), Float(0.0f));
  account.carried = account.leaving * transmittance(Vec3(u.medium.extinction), account.air_way);
  account.taken = taken + (account.leaving - account.carried);
}
#endif

// Decide the status.

Float largest(Vec3 v) { return max_of(max_of(v.x, v.y), v.z); }

// From the last step of the way to the first: what ends the light earlier overrides what would have happened
// later.
Float status_of(IN(Entry) entry, IN(Exit) exit, IN(Landing) end, IN(Account) account) {
  Vec2 uv = view_uv(u.caustic, view_coordinates(u.caustic, end.point));
  Bool exhausted = !entry.cell.guard && largest(account.carried) <= account.entered * 1.0e-6f;
  Bool on_map = inside_unit(uv.x, uv.y);
  Float status = Float(STATUS_LANDED);
  status = sel(!on_map, Float(STATUS_OUTSIDE), status);
  status = sel(exhausted, Float(STATUS_ABSORBED), status);
  Float unconverged = Float(STATUS_NOT_CONVERGED);
  if (u.draws_unconverged != 0) unconverged = sel(end.lands && on_map, Float(STATUS_STOPPED), unconverged);
  status = sel(!end.converged || (exit.stopped && on_map), unconverged, status);
  status = sel(!end.hit.covered, Float(STATUS_MISSED), status);
  Bool strays = !end.hit.inside || (end.hit.left && !end.converged);
  status = sel(strays, Float(STATUS_OUTSIDE), status);
  status = sel(!end.possible && (strays || !end.lands), Float(STATUS_MISSED), status);
  status = sel(exit.unknown, Float(STATUS_EXIT_NOT_FOUND), status);
  status = sel(exit.blocked, Float(STATUS_TOTAL_REFLECTION), status);
  status = sel(entry.covered, status, Float(STATUS_EMPTY));
  TRACE(status, status);
  return status;
}

void clear_outputs() {
  landing = Vec4(0.0f);
  landing_flux = Vec4(0.0f);
  landing_fresnel = Vec4(0.0f);
  landing_absorbed = Vec4(0.0f);
#ifdef HAZE
  landing_medium = Vec4(0.0f);
  stretch_start = Vec4(0.0f);
  stretch_way = Vec4(0.0f);
  stretch_flux = Vec4(0.0f);
#endif
}

// Follows the light of the grid vertices that a caster covers; the others stay as they are, zeros.
void follow(IN(Entry) entry) {
  TRACE(entry_point, entry.at.point);
  Incident light = light_onto(entry.cell, entry.at.point);
  Float most = Float(1.0f);
  if (u.is_tinted != 0) {
    most = max_of(max_of(entry.reaching.x, entry.reaching.y), entry.reaching.z);
    light.flux = light.flux * most;
  }
  if (u.paper_weights != 0) light.flux = equal_part(entry);
  FirstSurface first = enter_caster(entry, light);
  Exit exit = cross_caster(entry, light.direction, first);
  Landing end = fly_to_receiver(exit.ray);
  Account account = book_caster(entry, first, exit, end);
  if (u.is_tinted != 0) {
    Vec3 left = account.carried * (entry.reaching * (1.0f / max_of(most, 1.0e-6f)));
    account.absorbed = account.absorbed + (account.carried - left);
    account.carried = left;
  }
#ifdef HAZE
  book_air(entry, light.from, exit, end, account);
#endif
  Float status = status_of(entry, exit, end, account);

  Vec3 share = Vec3(u.channel_share);
  landing = sel(entry.covered, Vec4(end.point, status), Vec4(0.0f));
  landing_flux = sel(entry.covered, Vec4(account.carried * share, end.hit.residual), Vec4(0.0f));
  landing_fresnel = sel(entry.covered, Vec4(account.mirrored * share, account.entered), Vec4(0.0f));
  landing_absorbed = sel(entry.covered, Vec4(account.absorbed * share, exit.inside_length), Vec4(0.0f));
#ifdef HAZE
  landing_medium = sel(entry.covered, Vec4(account.taken * share, Float(0.0f)), Vec4(0.0f));
  stretch_start = sel(exit.sent, Vec4(exit.ray.start, account.air_way), Vec4(0.0f));
  stretch_way = sel(exit.sent, Vec4(exit.ray.direction, Float(1.0f)), Vec4(0.0f));
  stretch_flux = sel(exit.sent, Vec4(account.leaving * share, Float(0.0f)), Vec4(0.0f));
#endif
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  clear_outputs();
  Entry entry = entry_at(column, row);
  if (any_lane(entry.covered)) {
    find_surface_of(column, row, entry);
    if (any_lane(entry.covered)) follow(entry);
  }
}
#endif
