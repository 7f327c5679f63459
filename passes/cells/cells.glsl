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

Corner corner_at(Int column, Int row) {
  Vec4 place = fetch_clamped(landing, column, row);
  Vec2 uv = frame_uv(frame_coordinates(u.from_scene, Vec3(place)), u.caustic_window, u.caustic_depth);
  Corner corner;
  corner.point = Vec3(place);
  corner.texel = Vec2(uv.x * float(u.grid.y), uv.y * float(u.grid.y));
  Bool in_grid = column >= 0 && row >= 0 && column < u.grid.x && row < u.grid.x;
  corner.landed = in_grid && place.w == 1.0f;
  return corner;
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

// Is the receiver between two landings one surface, and not a step with the landings on both its levels?
Bool one_surface(Corner a, Corner b) {
  Vec3 from = frame_coordinates(u.from_scene, a.point);
  Vec3 to = frame_coordinates(u.from_scene, b.point);
  Vec3 middle = (from + to) * 0.5f;
  Gap gap = gap_at(receiver_position, u.from_scene, u.receiver_window, u.receiver_depth,
                   (a.point + b.point) * 0.5f, frame_w(middle, u.receiver_depth), false);
  Float extent = frame_w(middle, u.receiver_depth) *
                 max_of(Float(1.0f / (u.receiver_window.x * float(texture_width(receiver_position)))),
                        Float(1.0f / (u.receiver_window.y * float(texture_height(receiver_position)))));
  Float across = max_of(abs(to.x - from.x), abs(to.y - from.y));
  Float allowed = 0.25f * (abs(to.z - from.z) + across) + u.limits.w * extent;
  return gap.covered && abs(gap.value) <= allowed;
}

void main() {
  Int x = floor_to_int(frag_x());
  Int y = floor_to_int(frag_y());
  Corner a = corner_at(x, y);
  Corner b = corner_at(x + 1, y);
  Corner c = corner_at(x, y + 1);
  Corner d = corner_at(x + 1, y + 1);
  Bool whole = a.landed && b.landed && c.landed && d.landed;
  cell_near = Vec4(0.0f);
  cell_far = Vec4(0.0f);
  cell_flux = Vec4(0.0f);
  if (any_lane(whole)) {
    Float material = fetch_clamped(caster_normal, x, y).w;
    whole = whole && fetch_clamped(caster_normal, x + 1, y).w == material &&
            fetch_clamped(caster_normal, x, y + 1).w == material &&
            fetch_clamped(caster_normal, x + 1, y + 1).w == material;
    whole = whole && goes_on(corner_at(x - 1, y), a, b, corner_at(x + 2, y));
    whole = whole && goes_on(corner_at(x - 1, y + 1), c, d, corner_at(x + 2, y + 1));
    whole = whole && goes_on(corner_at(x, y - 1), a, c, corner_at(x, y + 2));
    whole = whole && goes_on(corner_at(x + 1, y - 1), b, d, corner_at(x + 1, y + 2));
    Float largest = max_of(max_of(span(a, d), span(b, c)), max_of(span(a, b), span(c, d)));
    whole = whole && largest <= u.limits.z;
    whole = whole && one_surface(a, d) && one_surface(b, c);
    // A quarter of each corner's flux: the other quarters belong to the three other cells around it.
    Vec3 sum = (Vec3(fetch_clamped(landing_flux, x, y)) + Vec3(fetch_clamped(landing_flux, x + 1, y))) +
               (Vec3(fetch_clamped(landing_flux, x, y + 1)) + Vec3(fetch_clamped(landing_flux, x + 1, y + 1)));
    cell_near = sel(whole, Vec4(a.texel.x, a.texel.y, b.texel.x, b.texel.y), Vec4(0.0f));
    cell_far = sel(whole, Vec4(c.texel.x, c.texel.y, d.texel.x, d.texel.y), Vec4(0.0f));
    cell_flux = sel(whole, Vec4(sum * 0.25f, Float(1.0f)), Vec4(0.0f));
  }
}
#endif
