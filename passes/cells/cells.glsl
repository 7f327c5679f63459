// Joins the landings of four neighbouring grid vertices to a cell, where one sheet of light reaches from
// each to each. cells.md explains.
UNIFORMS_BEGIN
#include "passes/cells/cells_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, landing)
TEXTURE(1, landing_flux)
TEXTURE(2, caster_normal)
TEXTURE(3, receiver_position)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, cell_near)
OUTPUT(1, Vec4, cell_far)
OUTPUT(2, Vec4, cell_flux)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/intersect.glsl"
#include "passes/cells/neighbours.glsl"

// A landing, with its place in the caustic map in texels.
struct Corner {
  Vec3 point;
  Vec2 texel;
  Bool landed;
};

// `face`: of a cube, which one's tile all corners of a cell lie in; those beyond the face in its guard.
Corner corner_at(Place where, Int face) {
  Vec4 place = fetch_clamped(landing, where.x, where.y);
  Vec3 q = view_coordinates(u.from_scene, Vec3(place));
  Vec2 uv = Vec2(Float(0.0f), Float(0.0f));
  if (u.caustic_depth.z > 1.5f) {
    uv = face_uv(q, face, u.caustic_window, u.caustic_depth);
  } else {
    uv = view_uv(q, u.caustic_window, u.caustic_depth);
  }
  Corner corner;
  corner.point = Vec3(place);
  corner.texel = Vec2(uv.x * float(u.grid.y), uv.y * float(u.grid.y));
  corner.landed = where.exists && place.w == 1.0f;
  // Behind a face there is no place in its tile.
  if (u.caustic_depth.z > 1.5f) corner.landed = corner.landed && in_face(q, face, u.caustic_depth).z > 0.0f;
  return corner;
}

// Where a cell's light lands, from the light, times the number of corners that exist.
Vec3 landing_direction(Place where) {
  Vec3 q = view_coordinates(u.from_scene, Vec3(fetch_clamped(landing, where.x, where.y)));
  return sel(where.exists, q, Vec3(0.0f));
}

// Does a corner lie in the face's tile, so far from its border that no light is laid beyond it?
Bool in_tile(Corner corner, Int face) {
  Vec2 middle = cube_middle(face);
  return abs(corner.texel.x - middle.x * (0.5f * u.tile.x)) <= 0.5f * u.tile.x - 1.0f &&
         abs(corner.texel.y - middle.y * (0.5f * u.tile.y)) <= 0.5f * u.tile.y - 1.0f;
}

// Distance of two landings in the map, along the axis on which they lie farther apart; 0 where one of them
// is none.
Float span(Corner a, Corner b) {
  Float distance = max_of(abs(b.texel.x - a.texel.x), abs(b.texel.y - a.texel.y));
  return sel(a.landed && b.landed, distance, Float(0.0f));
}

// Does the light go on without a jump from a to b? `before` and `after` are the next grid vertices on the
// line through both. A sheet's spacing changes little from one vertex to the next; where it leaps, a facet
// or another part of the caster begins, and no light falls between.
Bool goes_on(Corner before, Corner a, Corner b, Corner after) {
  Float usual = max_of(span(before, a), span(b, after));
  return span(a, b) <= max_of(Float(u.limits.x) * usual, Float(u.limits.y));
}

// view_w of a point in its face's coordinates.
Float along_face(Vec3 q) {
  Float w = Float(1.0f);
  if (u.receiver_depth.z > 0.5f) w = q.z;
  return w;
}

// Is the receiver between two landings one surface, and not a step with the landings on both its levels?
Bool one_surface(Corner a, Corner b, Int face) {
  Vec3 from = in_face(view_coordinates(u.from_scene, a.point), face, u.receiver_depth);
  Vec3 to = in_face(view_coordinates(u.from_scene, b.point), face, u.receiver_depth);
  Vec3 middle = (from + to) * 0.5f;
  Gap gap = gap_at(receiver_position, u.from_scene, u.receiver_window, u.receiver_depth,
                   (a.point + b.point) * 0.5f, along_face(middle), false);
  Float extent = along_face(middle) *
                 max_of(Float(1.0f / (u.receiver_window.x * float(texture_width(receiver_position)))),
                        Float(1.0f / (u.receiver_window.y * float(texture_height(receiver_position)))));
  Float across = max_of(abs(to.x - from.x), abs(to.y - from.y));
  Float allowed = 0.25f * (abs(to.z - from.z) + across) + u.limits.w * extent;
  return gap.covered && abs(gap.value) <= allowed;
}

Float material_at(Place where) { return fetch_clamped(caster_normal, where.x, where.y).w; }

Corner chosen(Bool condition, Corner p, Corner q) {
  Corner corner;
  corner.point = sel(condition, p.point, q.point);
  corner.texel = sel(condition, p.texel, q.texel);
  corner.landed = (condition && p.landed) || (!condition && q.landed);
  return corner;
}

// Around a corner of the cube three vertices are neighbours, one of each face: `own`, p and q; `back_x` and `back_y`
// lie behind `own` on its face. One sheet of light, by the rule of goes_on from one side?
Bool triangle_goes_on(Corner own, Corner p, Corner q, Corner back_x, Corner back_y) {
  Float usual = max_of(span(back_x, own), span(back_y, own));
  Float longest = max_of(span(p, q), max_of(span(own, p), span(own, q)));
  return own.landed && p.landed && q.landed &&
         longest <= min_of(max_of(Float(u.limits.x) * usual, Float(u.limits.y)), Float(u.limits.z));
}

void main() {
  Int x = floor_to_int(frag_x());
  Int y = floor_to_int(frag_y());
  Place at_a = place_at(x, y, x, y);
  Place at_b = place_at(x + 1, y, x, y);
  Place at_c = place_at(x, y + 1, x, y);
  Place at_d = place_at(x + 1, y + 1, x, y);
  Int face = Int(4);
  if (u.caustic_depth.z > 1.5f) {
    // A row of cells that straddles an edge evenly, as undeviated light does, must lie in one tile all along: z is
    // preferred to x and x to y by more than rounding.
    Vec3 towards = (landing_direction(at_a) + landing_direction(at_d)) +
                   (landing_direction(at_b) + landing_direction(at_c));
    face = cube_face(Vec3(towards.x, towards.y * 0.9998f, towards.z * 1.0002f));
  }
  Corner a = corner_at(at_a, face);
  Corner b = corner_at(at_b, face);
  Corner c = corner_at(at_c, face);
  Corner d = corner_at(at_d, face);
  Bool whole = a.landed && b.landed && c.landed && d.landed;
  cell_near = Vec4(0.0f);
  cell_far = Vec4(0.0f);
  cell_flux = Vec4(0.0f);
  Float part = Float(1.0f);
  if (any_lane(whole)) {
    Float material = material_at(at_a);
    whole = whole && material_at(at_b) == material && material_at(at_c) == material && material_at(at_d) == material;
    whole = whole && goes_on(corner_at(place_at(x - 1, y, x, y), face), a, b,
                             corner_at(place_at(x + 2, y, x, y), face));
    whole = whole && goes_on(corner_at(place_at(x - 1, y + 1, x, y), face), c, d,
                             corner_at(place_at(x + 2, y + 1, x, y), face));
    whole = whole && goes_on(corner_at(place_at(x, y - 1, x, y), face), a, c,
                             corner_at(place_at(x, y + 2, x, y), face));
    whole = whole && goes_on(corner_at(place_at(x + 1, y - 1, x, y), face), b, d,
                             corner_at(place_at(x + 1, y + 2, x, y), face));
    Float largest = max_of(max_of(span(a, d), span(b, c)), max_of(span(a, b), span(c, d)));
    whole = whole && largest <= u.limits.z;
    whole = whole && one_surface(a, d, face) && one_surface(b, c, face);
  }
  if (u.caustic_depth.z > 1.5f) {
    // At a cube's corner the triangle of three vertices is cut into two of one area, as a cell is.
    Bool by_left = !at_a.exists || !at_c.exists;
    Bool none = !at_a.exists && !at_b.exists && !at_c.exists && !at_d.exists;
    Bool triangle = !none && (!at_a.exists || !at_b.exists || !at_c.exists || !at_d.exists);
    if (any_lane(triangle)) {
      // The vertex across from the missing one is this face's own.
      Corner own = chosen(!at_a.exists, d, chosen(!at_d.exists, a, chosen(!at_b.exists, c, b)));
      Bool beside = !at_a.exists || !at_d.exists;
      Corner p = chosen(beside, b, a);
      Corner q = chosen(beside, c, d);
      Int own_x = sel(by_left, x + 1, x);
      Int own_y = sel(!at_a.exists || !at_b.exists, y + 1, y);
      Int back = sel(by_left, own_x + 1, own_x - 1);
      Int below = sel(!at_a.exists || !at_b.exists, own_y + 1, own_y - 1);
      Bool joined = triangle_goes_on(own, p, q, corner_at(place_at(back, own_y, x, y), face),
                                     corner_at(place_at(own_x, below, x, y), face)) &&
                    one_surface(p, q, face);
      Corner middle = own;
      middle.point = (p.point + q.point) * 0.5f;
      middle.texel = (p.texel + q.texel) * 0.5f;
      whole = (triangle && joined) || (!triangle && whole);
      a = chosen(triangle, p, a);
      b = chosen(triangle, own, b);
      c = chosen(triangle, middle, c);
      d = chosen(triangle, q, d);
      // As the light sees it the triangle is half as large as three quarters of cells: the sides from face to face are
      // bent away from it at the edges, drawn straight. So it takes an eighth of each
      // vertex's flux; the other eighth is left to a point.
      part = sel(triangle, Float(0.5f), part);
    }
  }
  if (any_lane(whole)) {
    // A quarter of each corner's flux: the other quarters belong to the three other cells around it.
    Vec3 sum = (Vec3(fetch_clamped(landing_flux, x, y)) + Vec3(fetch_clamped(landing_flux, x + 1, y))) +
          (Vec3(fetch_clamped(landing_flux, x, y + 1)) + Vec3(fetch_clamped(landing_flux, x + 1, y + 1)));
    if (u.caustic_depth.z > 1.5f) {
      // Only the face's own vertices give here: across a border each of the two faces draws the same cell with the
      // half of its flux that its own vertices carry. The guard's carry nothing.
      whole = whole && max_of(max_of(sum.x, sum.y), sum.z) > 0.0f && in_tile(a, face) && in_tile(b, face) &&
              in_tile(c, face) && in_tile(d, face);
    }
    cell_near = sel(whole, Vec4(a.texel.x, a.texel.y, b.texel.x, b.texel.y), Vec4(0.0f));
    cell_far = sel(whole, Vec4(c.texel.x, c.texel.y, d.texel.x, d.texel.y), Vec4(0.0f));
    cell_flux = sel(whole, Vec4(sum * (0.25f * part), part), Vec4(0.0f));
  }
}
#endif
