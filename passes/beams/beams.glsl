// Joins the light of neighbouring grid vertices, from the caster to its landing, to beams. beams.md explains.
UNIFORMS_BEGIN
#include "passes/beams/beams_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, stretch_start)
TEXTURE(1, stretch_way)
TEXTURE(2, stretch_flux)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, beam_start)
OUTPUT(1, Vec4, beam_way)
OUTPUT(2, Vec4, beam_flux)
#include "passes/shared/way_draw.glsl"

// Does light leave the caster here?
Bool is_sent(Vec4 way_texel) { return way_texel.w != 0.0f; }

void main() {
  Int x = floor_to_int(frag_x()) * Int(u.vertices_per_beam);
  Int y = floor_to_int(frag_y()) * Int(u.vertices_per_beam);
  Vec4 start = Vec4(0.0f);
  Vec3 way = Vec3(0.0f);
  Vec3 flux = Vec3(0.0f);
  Float sum = Float(0.0f);
  Float draw = first_draw(Float(x), Float(y));
  for (int j = 0; j < u.vertices_per_beam; j++) {
    for (int i = 0; i < u.vertices_per_beam; i++) {
      Bool in_grid = x + i < u.grid_side && y + j < u.grid_side;
      Vec4 heading = fetch_clamped(stretch_way, x + i, y + j);
      Vec3 carried = Vec3(fetch_clamped(stretch_flux, x + i, y + j));
      Float weight = sel(in_grid && is_sent(heading), carried.x + carried.y + carried.z, Float(0.0f));
      Bool counts = weight > 0.0f;
      flux = flux + sel(counts, carried, Vec3(0.0f));
      sum = sum + weight;
      // This vertex' way replaces the one that was drawn so far, or is added to the mean.
      draw = next_draw(draw);
      Bool replaces = u.draws != 0 && counts && drawn_share(draw) * sum < weight;
      Float share = sel(Bool(u.draws != 0), sel(replaces, Float(1.0f), Float(0.0f)), weight);
      Vec4 from = sel(counts, fetch_clamped(stretch_start, x + i, y + j), Vec4(0.0f));
      start = sel(replaces, Vec4(0.0f), start) + from * share;
      way = sel(replaces, Vec3(0.0f), way) + sel(counts, Vec3(heading), Vec3(0.0f)) * share;
    }
  }
  Vec3 mean_way = normalize_or(way / sel(sum > 0.0f, sum, Float(1.0f)), Vec3(0.0f));
  Bool any = sum > 0.0f && dot3(mean_way, mean_way) > 0.5f;
  Float all = sel(Bool(u.draws != 0), Float(1.0f), sum);
  beam_start = sel(any, start / sel(any, all, Float(1.0f)), Vec4(0.0f));
  beam_way = sel(any, Vec4(mean_way, Float(1.0f)), Vec4(0.0f));
  beam_flux = sel(any, Vec4(flux, Float(0.0f)), Vec4(0.0f));
}
#endif
