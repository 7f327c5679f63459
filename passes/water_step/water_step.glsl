// One step of the wave equation on a grid of heights. water_step.md explains.
UNIFORMS_BEGIN
#include "passes/water_step/water_step_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, water_before)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, water_after)

// What this step's part of a plop adds to the height, metres: a bump with a ring around it that takes
// away as much water.
Float plop_at(Float column, Float row) {
  Float x = (column - Float(u.plop_middle.x)) * Float(u.plop_scale.x);
  Float z = (row - Float(u.plop_middle.y)) * Float(u.plop_scale.y);
  Float q = x * x + z * z;
  Float rest = max_of(1.0f - q, Float(0.0f));
  Float bump = (rest * rest) * rest;
  return (bump * (1.0f - q * Float(u.plop_ring))) * Float(u.plop_height);
}

// Ahead of a wave's front heights fall off by powers, until they are denormal: some machines keep such
// numbers and others take them for 0. What no picture can show is at rest on all of them.
Float settled(Float x) {
  return sel(abs(x) < 1e-20f, Float(0.0f), x);
}

void main() {
  Int x = floor_to_int(frag_x());
  Int y = floor_to_int(frag_y());
  Vec4 here = fetch_clamped(water_before, x, y);
  Float h = here.x;
  Float rises = here.y;
  // Beyond a wall stands the cell before it, so that nothing flows there: the slope at the wall is 0.
  Float east = fetch_clamped(water_before, x + 1, y).x - h;
  Float west = h - fetch_clamped(water_before, x - 1, y).x;
  Float north = fetch_clamped(water_before, x, y + 1).x - h;
  Float south = h - fetch_clamped(water_before, x, y - 1).x;
  Float pull = (east - west) * Float(u.pull_x) + (north - south) * Float(u.pull_z);
  Float rate = (rises + pull) * Float(u.damping);
  Float height = h + rate * Float(u.time_step);
  water_after = Vec4(settled(height + plop_at(frag_x(), frag_y())), settled(rate), Float(0.0f), Float(0.0f));
}
#endif
