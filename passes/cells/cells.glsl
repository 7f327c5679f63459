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
#include "passes/shared/frame_space.glsl"
#include "passes/shared/intersect.glsl"

// A landing, with its place in the caustic map in texels.
struct Corner {
  Vec3 point;
  Vec2 texel;
  Bool landed;
};

// `face`: of a cube, which one's tile all corners of a cell lie in; those beyond the face in its guard.
Corner corner_at(Int column, Int row, Int face) {
  Vec4 place = fetch_clamped(landing, column, row);
  Vec3 q = frame_coordinates(u.from_scene, Vec3(place));
  Vec2 uv = Vec2(Float(0.0f), Float(0.0f));
  if (u.caustic_depth.z > 1.5f) {
    uv = face_uv(q, face, u.caustic_window, u.caustic_depth);
  } else {
    uv = frame_uv(q, u.caustic_window, u.caustic_depth);
  }
  Corner corner;
  corner.point = Vec3(place);
  corner.texel = Vec2(uv.x * float(u.grid.y), uv.y * float(u.grid.y));
  Bool in_grid = column >= 0 && row >= 0 && column < u.grid.x && row < u.grid.x;
  corner.landed = in_grid && place.w == 1.0f;
  // Behind a face there is no place in its tile.
  if (u.caustic_depth.z > 1.5f) corner.landed = corner.landed && in_face(q, face, u.caustic_depth).z > 0.0f;
  return corner;
}

// The face of a cube that a cell's light lands on, by the sum of the directions to its corners.
Int cell_face(Int x, Int y) {
  Int face = Int(4);
  if (u.caustic_depth.z > 1.5f) {
    Vec3 low = frame_coordinates(u.from_scene, Vec3(fetch_clamped(landing, x, y))) +
               frame_coordinates(u.from_scene, Vec3(fetch_clamped(landing, x + 1, y)));
    Vec3 high = frame_coordinates(u.from_scene, Vec3(fetch_clamped(landing, x, y + 1))) +
                frame_coordinates(u.from_scene, Vec3(fetch_clamped(landing, x + 1, y + 1)));
    face = cube_face(low + high);
  }
  return face;
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

// frame_w of a point in its face's coordinates.
Float along_face(Vec3 q) {
  Float w = Float(1.0f);
  if (u.receiver_depth.z > 0.5f) w = q.z;
  return w;
}

// Is the receiver between two landings one surface, and not a step with the landings on both its levels?
Bool one_surface(Corner a, Corner b, Int face) {
  Vec3 from = in_face(frame_coordinates(u.from_scene, a.point), face, u.receiver_depth);
  Vec3 to = in_face(frame_coordinates(u.from_scene, b.point), face, u.receiver_depth);
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

void main() {
  Int x = floor_to_int(frag_x());
  Int y = floor_to_int(frag_y());
  Int face = cell_face(x, y);
  Corner a = corner_at(x, y, face);
  Corner b = corner_at(x + 1, y, face);
  Corner c = corner_at(x, y + 1, face);
  Corner d = corner_at(x + 1, y + 1, face);
  Bool whole = a.landed && b.landed && c.landed && d.landed;
  cell_near = Vec4(0.0f);
  cell_far = Vec4(0.0f);
  cell_flux = Vec4(0.0f);
  if (any_lane(whole)) {
    Float material = fetch_clamped(caster_normal, x, y).w;
    whole = whole && fetch_clamped(caster_normal, x + 1, y).w == material &&
            fetch_clamped(caster_normal, x, y + 1).w == material &&
            fetch_clamped(caster_normal, x + 1, y + 1).w == material;
    whole = whole && goes_on(corner_at(x - 1, y, face), a, b, corner_at(x + 2, y, face));
    whole = whole && goes_on(corner_at(x - 1, y + 1, face), c, d, corner_at(x + 2, y + 1, face));
    whole = whole && goes_on(corner_at(x, y - 1, face), a, c, corner_at(x, y + 2, face));
    whole = whole && goes_on(corner_at(x + 1, y - 1, face), b, d, corner_at(x + 1, y + 2, face));
    Float largest = max_of(max_of(span(a, d), span(b, c)), max_of(span(a, b), span(c, d)));
    whole = whole && largest <= u.limits.z;
    whole = whole && one_surface(a, d, face) && one_surface(b, c, face);
    // A quarter of each corner's flux: the other quarters belong to the three other cells around it.
    Vec3 sum = (Vec3(fetch_clamped(landing_flux, x, y)) + Vec3(fetch_clamped(landing_flux, x + 1, y))) +
               (Vec3(fetch_clamped(landing_flux, x, y + 1)) + Vec3(fetch_clamped(landing_flux, x + 1, y + 1)));
    if (u.caustic_depth.z > 1.5f) {
      // The guard vertices around a tile of the caster map carry nothing: between them there is no cell, and across
      // a border each of the two faces draws the half of the cell that its own vertices carry.
      whole = whole && max_of(max_of(sum.x, sum.y), sum.z) > 0.0f && in_tile(a, face) && in_tile(b, face) &&
              in_tile(c, face) && in_tile(d, face);
    }
    cell_near = sel(whole, Vec4(a.texel.x, a.texel.y, b.texel.x, b.texel.y), Vec4(0.0f));
    cell_far = sel(whole, Vec4(c.texel.x, c.texel.y, d.texel.x, d.texel.y), Vec4(0.0f));
    cell_flux = sel(whole, Vec4(sum * 0.25f, Float(1.0f)), Vec4(0.0f));
  }
}
#endif
