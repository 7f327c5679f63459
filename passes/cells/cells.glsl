// Joins the landings of four neighbouring grid vertices to a cell, where one sheet of light reaches from
// each to each. WALKED: light that was followed from surface to surface. cells.md explains.
UNIFORMS_BEGIN
#include "passes/cells/cells_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, landing)
TEXTURE(1, landing_flux)
TEXTURE(2, caster_normal)
TEXTURE(3, receiver_position)
#ifdef WALKED
TEXTURE(4, landing_path)
TEXTURE(5, landing_footprint)
#endif

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, cell_near)
OUTPUT(1, Vec4, cell_far)
OUTPUT(2, Vec4, cell_flux)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/landing_status.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/intersect.glsl"
#include "passes/cells/neighbours.glsl"

// Four neighbouring grid vertices from (x, y) on: a and b in one row, c and d in the next.
struct Square {
  Int x;
  Int y;
  Place a;
  Place b;
  Place c;
  Place d;
};

Square square_at(Int x, Int y) {
  Square at;
  at.x = x;
  at.y = y;
  at.a = place_at(x, y, x, y);
  at.b = place_at(x + 1, y, x, y);
  at.c = place_at(x, y + 1, x, y);
  at.d = place_at(x + 1, y + 1, x, y);
  return at;
}

// Where a cell's light lands, from the light, times the number of corners that exist.
Vec3 landing_direction(Place where) {
  Vec3 q = view_coordinates(u.caustic, Vec3(fetch_clamped(landing, where.x, where.y)));
  return sel(where.exists, q, Vec3(0.0f));
}

// Of a cube: in which face's tile all corners of a cell lie, those beyond the face in its guard.
Int face_of(IN(Square) at) {
  Int face = Int(FACE_FORWARD);
  if (u.caustic.kind == VIEW_CUBE) {
    // A row of cells that straddles an edge evenly, as undeviated light does, must lie in one tile all along:
    // z is preferred to x and x to y by more than rounding.
    Vec3 towards = (landing_direction(at.a) + landing_direction(at.d)) +
                   (landing_direction(at.b) + landing_direction(at.c));
    face = cube_face(Vec3(towards.x, towards.y * 0.9998f, towards.z * 1.0002f));
  }
  return face;
}

// A landing, with its place in the caustic map in texels.
struct Corner {
  Vec3 point;
  Vec2 texel;
  Bool landed;
};

Corner chosen(Bool condition, IN(Corner) p, IN(Corner) q) {
  Corner corner;
  corner.point = sel(condition, p.point, q.point);
  corner.texel = sel(condition, p.texel, q.texel);
  corner.landed = sel(condition, p.landed, q.landed);
  return corner;
}

Corner corner_at(Place where, Int face) {
  Vec4 place = fetch_clamped(landing, where.x, where.y);
  Vec3 q = view_coordinates(u.caustic, Vec3(place));
  Vec2 uv = Vec2(Float(0.0f), Float(0.0f));
  if (u.caustic.kind == VIEW_CUBE) {
    uv = face_uv(u.caustic, q, face);
  } else {
    uv = view_uv(u.caustic, q);
  }
  Corner corner;
  corner.point = Vec3(place);
  corner.texel = Vec2(uv.x * float(u.map_side), uv.y * float(u.map_side));
  Bool drawn = has_status(place, STATUS_LANDED) || has_status(place, STATUS_STOPPED);
  corner.landed = where.exists && drawn;
  // Behind a face there is no place in its tile.
  if (u.caustic.kind == VIEW_CUBE) corner.landed = corner.landed && in_face(u.caustic, q, face).z > 0.0f;
  return corner;
}

// The landing of the vertex (dx, dy) away from a square's first.
Corner corner_from(IN(Square) at, int dx, int dy, Int face) {
  return corner_at(place_at(at.x + dx, at.y + dy, at.x, at.y), face);
}

struct Cell {
  Corner a;
  Corner b;
  Corner c;
  Corner d;
  Bool whole;  // one sheet of light reaches from each corner to each
  Float part;  // of the flux that four vertices give to a cell
};

Cell cell_at(IN(Square) at, Int face) {
  Cell cell;
  cell.a = corner_at(at.a, face);
  cell.b = corner_at(at.b, face);
  cell.c = corner_at(at.c, face);
  cell.d = corner_at(at.d, face);
  cell.whole = cell.a.landed && cell.b.landed && cell.c.landed && cell.d.landed;
  cell.part = Float(1.0f);
  return cell;
}

// Distance of two landings in the map, along the axis on which they lie farther apart; 0 where one of them
// is none.
Float span(IN(Corner) a, IN(Corner) b) {
  Float distance = max_of(abs(b.texel.x - a.texel.x), abs(b.texel.y - a.texel.y));
  return sel(a.landed && b.landed, distance, Float(0.0f));
}

// How long an edge may be next to others of the length `usual`.
Float longest_beside(Float usual) { return max_of(Float(u.jump) * usual, Float(u.smallest_jump)); }

// Does the light go on without a jump from a to b? `before` and `after` are the next grid vertices on the
// line through both. A sheet's spacing changes little from one vertex to the next; where it leaps, a facet
// or another part of the caster begins, and no light falls between.
Bool goes_on(IN(Corner) before, IN(Corner) a, IN(Corner) b, IN(Corner) after) {
  Float usual = max_of(span(before, a), span(b, after));
  return span(a, b) <= longest_beside(usual);
}

// view_w of a point in its face's coordinates.
Float along_face(Vec3 q) {
  Float w = Float(1.0f);
  if (u.receiver.kind != VIEW_PARALLEL) w = q.z;
  return w;
}

// Is the receiver between two landings one surface, and not a step with the landings on both its levels?
Bool one_surface(Vec3 a, Vec3 b, Int face) {
  Vec3 from = in_face(u.receiver, view_coordinates(u.receiver, a), face);
  Vec3 to = in_face(u.receiver, view_coordinates(u.receiver, b), face);
  Vec3 middle = (from + to) * 0.5f;
  Gap gap = gap_at(receiver_position, u.receiver, (a + b) * 0.5f, along_face(middle), false);
  Float extent = along_face(middle) * texel_extent(receiver_position, u.receiver);
  Float across = max_of(abs(to.x - from.x), abs(to.y - from.y));
  Float allowed = 0.25f * (abs(to.z - from.z) + across) + u.gap * extent;
  return gap.covered && abs(gap.value) <= allowed;
}

// The row of a vertex's material.
Float material_at(Place where) { return fetch_clamped(caster_normal, where.x, where.y).w; }

#ifdef WALKED
// What a vertex's light has met.
Float path_at(Place where) { return fetch_clamped(landing_path, where.x, where.y).x; }

// Does b lie where the differentials of both expect it: a mean step away from a?
Bool is_expected(Vec2 a, Vec2 b, Vec2 step_a, Vec2 step_b) {
  float side = float(u.map_side);
  Vec2 step = (step_a + step_b) * (0.5f * side);
  Vec2 off = (b - a) - step;
  Float longest_a = max_of(abs(step_a.x), abs(step_a.y)) * side;
  Float longest_b = max_of(abs(step_b.x), abs(step_b.y)) * side;
  Float allowed = u.expected * max_of(longest_a, longest_b) + u.smallest_jump;
  return max_of(abs(off.x), abs(off.y)) <= allowed;
}

Bool goes_on_across(Place a, Place b, IN(Corner) from, IN(Corner) to) {
  Vec4 step_a = fetch_clamped(landing_footprint, a.x, a.y);
  Vec4 step_b = fetch_clamped(landing_footprint, b.x, b.y);
  return is_expected(from.texel, to.texel, Vec2(step_a.x, step_a.y), Vec2(step_b.x, step_b.y));
}

Bool goes_on_upward(Place a, Place b, IN(Corner) from, IN(Corner) to) {
  Vec4 step_a = fetch_clamped(landing_footprint, a.x, a.y);
  Vec4 step_b = fetch_clamped(landing_footprint, b.x, b.y);
  return is_expected(from.texel, to.texel, Vec2(step_a.z, step_a.w), Vec2(step_b.z, step_b.w));
}

// Did all four meet the same surfaces in the same way, and are their landings neighbours?
Bool goes_on_around(IN(Square) at, IN(Cell) cell) {
  Float path = path_at(at.a);
  Bool same = path_at(at.b) == path && path_at(at.c) == path && path_at(at.d) == path;
  return same && goes_on_across(at.a, at.b, cell.a, cell.b) && goes_on_across(at.c, at.d, cell.c, cell.d) &&
         goes_on_upward(at.a, at.c, cell.a, cell.c) && goes_on_upward(at.b, at.d, cell.b, cell.d);
}
#else
// Are the four on one caster, and does no edge leap?
Bool goes_on_around(IN(Square) at, IN(Cell) cell, Int face) {
  Float material = material_at(at.a);
  Bool whole = material_at(at.b) == material && material_at(at.c) == material &&
               material_at(at.d) == material;
  whole = whole && goes_on(corner_from(at, -1, 0, face), cell.a, cell.b, corner_from(at, 2, 0, face));
  whole = whole && goes_on(corner_from(at, -1, 1, face), cell.c, cell.d, corner_from(at, 2, 1, face));
  whole = whole && goes_on(corner_from(at, 0, -1, face), cell.a, cell.c, corner_from(at, 0, 2, face));
  whole = whole && goes_on(corner_from(at, 1, -1, face), cell.b, cell.d, corner_from(at, 1, 2, face));
  return whole;
}
#endif

// Are the four landings of one sheet of light, on one surface?
Bool one_sheet(IN(Square) at, IN(Cell) cell, Int face) {
#ifdef WALKED
  Bool whole = goes_on_around(at, cell);
#else
  Bool whole = goes_on_around(at, cell, face);
#endif
  Float largest = max_of(max_of(span(cell.a, cell.d), span(cell.b, cell.c)),
                         max_of(span(cell.a, cell.b), span(cell.c, cell.d)));
  return whole && largest <= u.largest && one_surface(cell.a.point, cell.d.point, face) &&
         one_surface(cell.b.point, cell.c.point, face);
}

// Around a corner of the cube three vertices are neighbours, one of each face.
struct Triangle {
  Corner own;  // of this face: the vertex across from the missing one
  Corner p;
  Corner q;
  Corner back_x;  // behind `own` on its face
  Corner back_y;
  Bool landed;
};

Triangle triangle_at(IN(Square) at, IN(Cell) cell, Int face) {
  Bool beside = !at.a.exists || !at.d.exists;
  Bool by_left = !at.a.exists || !at.c.exists;
  Bool below = !at.a.exists || !at.b.exists;
  Triangle t;
  t.own = chosen(!at.a.exists, cell.d, chosen(!at.d.exists, cell.a, chosen(!at.b.exists, cell.c, cell.b)));
  t.p = chosen(beside, cell.b, cell.a);
  t.q = chosen(beside, cell.c, cell.d);
  Int own_x = sel(by_left, at.x + 1, at.x);
  Int own_y = sel(below, at.y + 1, at.y);
  Int back_x = sel(by_left, own_x + 1, own_x - 1);
  Int back_y = sel(below, own_y + 1, own_y - 1);
  t.back_x = corner_at(place_at(back_x, own_y, at.x, at.y), face);
  t.back_y = corner_at(place_at(own_x, back_y, at.x, at.y), face);
  t.landed = t.own.landed && t.p.landed && t.q.landed;
  return t;
}

// One sheet of light, by the rule of goes_on from one side?
Bool triangle_goes_on(IN(Triangle) t) {
  Float usual = max_of(span(t.back_x, t.own), span(t.back_y, t.own));
  Float longest = max_of(span(t.p, t.q), max_of(span(t.own, t.p), span(t.own, t.q)));
  return t.landed && longest <= min_of(longest_beside(usual), Float(u.largest));
}

// At a cube's corner the triangle of three vertices is cut into two of one area, as a cell is.
void join_triangle(IN(Square) at, Int face, INOUT(Cell) cell) {
  Bool none = !at.a.exists && !at.b.exists && !at.c.exists && !at.d.exists;
  Bool triangle = !none && (!at.a.exists || !at.b.exists || !at.c.exists || !at.d.exists);
  if (any_lane(triangle)) {
    Triangle t = triangle_at(at, cell, face);
    Bool joined = triangle_goes_on(t) && one_surface(t.p.point, t.q.point, face);
    Corner middle = t.own;
    middle.point = (t.p.point + t.q.point) * 0.5f;
    middle.texel = (t.p.texel + t.q.texel) * 0.5f;
    cell.whole = sel(triangle, joined, cell.whole);
    cell.a = chosen(triangle, t.p, cell.a);
    cell.b = chosen(triangle, t.own, cell.b);
    cell.c = chosen(triangle, middle, cell.c);
    cell.d = chosen(triangle, t.q, cell.d);
    // As the light sees it the triangle is half as large as three quarters of cells: the sides from face to
    // face are bent away from it at the edges, drawn straight. So it takes an eighth of each vertex's flux;
    // the other eighth is left to a point.
    cell.part = sel(triangle, Float(0.5f), cell.part);
  }
}

// Does a corner lie in the face's tile, so far from its border that no light is laid beyond it?
Bool in_tile(IN(Corner) corner, Int face) {
  Vec2 middle = cube_middle(face);
  return abs(corner.texel.x - middle.x * (0.5f * u.tile_width)) <= 0.5f * u.tile_width - 1.0f &&
         abs(corner.texel.y - middle.y * (0.5f * u.tile_height)) <= 0.5f * u.tile_height - 1.0f;
}

// The flux of the vertices that lie where the square counts them: of a cube, those of its own face and guard.
Vec3 flux_around(Int x, Int y) {
  return (Vec3(fetch_clamped(landing_flux, x, y)) + Vec3(fetch_clamped(landing_flux, x + 1, y))) +
         (Vec3(fetch_clamped(landing_flux, x, y + 1)) + Vec3(fetch_clamped(landing_flux, x + 1, y + 1)));
}

void write_cell(IN(Cell) cell, Vec3 flux, Int face) {
  Bool whole = cell.whole;
  if (u.caustic.kind == VIEW_CUBE) {
    // Only the face's own vertices give here: across a border each of the two faces draws the same cell with
    // the half of its flux that its own vertices carry. The guard's carry nothing.
    whole = whole && max_of(max_of(flux.x, flux.y), flux.z) > 0.0f && in_tile(cell.a, face) &&
            in_tile(cell.b, face) && in_tile(cell.c, face) && in_tile(cell.d, face);
  }
  cell_near = sel(whole, Vec4(cell.a.texel.x, cell.a.texel.y, cell.b.texel.x, cell.b.texel.y), Vec4(0.0f));
  cell_far = sel(whole, Vec4(cell.c.texel.x, cell.c.texel.y, cell.d.texel.x, cell.d.texel.y), Vec4(0.0f));
  // A quarter of each corner's flux: the other quarters belong to the three other cells around it.
  cell_flux = sel(whole, Vec4(flux * (0.25f * cell.part), cell.part), Vec4(0.0f));
}

void main() {
  Square at = square_at(floor_to_int(frag_x()), floor_to_int(frag_y()));
  Int face = face_of(at);
  Cell cell = cell_at(at, face);
  cell_near = Vec4(0.0f);
  cell_far = Vec4(0.0f);
  cell_flux = Vec4(0.0f);
  if (any_lane(cell.whole)) cell.whole = cell.whole && one_sheet(at, cell, face);
  if (u.caustic.kind == VIEW_CUBE) join_triangle(at, face, cell);
  if (any_lane(cell.whole)) write_cell(cell, flux_around(at.x, at.y), face);
}
#endif
