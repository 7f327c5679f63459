// One stretch of the way that a grid vertex' light takes through the air, which stands for all of them: each
// is drawn in proportion to its light and its length, and shown as much brighter (stretches.md). Needs
// absorption.glsl, light_path.glsl, medium_optics.glsl and way_draw.glsl.
struct Record {
  Ray ray;
  Float metres;
  Vec3 flux;
  Float weight;  // its light times its length; 0: there is none
  Float all;     // likewise of all stretches so far
  Float draw;
};

// The vertices of a beam draw alike, so that their stretches lie side by side.
Record empty_record(Int column, Int row) {
  Record record;
  record.ray = ray_from(Vec3(0.0f), Vec3(0.0f));
  record.metres = Float(0.0f);
  record.flux = Vec3(0.0f);
  record.weight = Float(0.0f);
  record.all = Float(0.0f);
  Float inverse = Float(1.0f) / Float(float(u.vertices_per_beam));
  Float draw = first_draw(floor((Float(column) + 0.5f) * inverse), floor((Float(row) + 0.5f) * inverse));
  record.draw = below_4093(draw * 1237.0f);  // other numbers than those by which light parts
  return record;
}

Bool is_discarded(IN(Record) record) { return Bool(false); }

// The next stretch, as long as the medium reaches. `wanted`: it is this branch's, and another one's not.
void record_stretch(INOUT(Record) record, IN(LightPath) path, Float metres, Bool wanted) {
  Float in_air = min_of(metres, medium_exit(u.medium, path.ray));
  Float most = max_of(max_of(path.flux.x, path.flux.y), path.flux.z);
  Float weight = sel(wanted && is_in_air(path.media.x), most * in_air, Float(0.0f));
  Bool counts = weight > 0.0f;
  record.all = record.all + weight;
  record.draw = sel(counts, next_draw(record.draw), record.draw);
  Bool takes = counts && drawn_share(record.draw) * record.all < weight;
  record.ray = ray_from(sel(takes, path.ray.start, record.ray.start),
                        sel(takes, path.ray.direction, record.ray.direction));
  record.metres = sel(takes, in_air, record.metres);
  record.flux = sel(takes, path.flux, record.flux);
  record.weight = sel(takes, weight, record.weight);
}

void record_end(INOUT(Record) record, IN(LightPath) path, Vec4 hit, Bool was_ended, Bool ends) {
  record_stretch(record, path, sel(is_surface(hit), hit.z, Float(1.0e30f)), ends && !was_ended);
}

// The walk books these besides; they are no stretches.
void record_entry(INOUT(Record) record, Vec3 by_panes, Vec3 by_air) {}
void record_surface(INOUT(Record) record, IN(BentLight) bent, Bool goes) {}
void record_hit(Vec4 hit) {}

void write(IN(Record) record, Float entered) {
  Bool any = record.weight > 0.0f;
  Vec3 flux = record.flux * (record.all / sel(any, record.weight, Float(1.0f)));
  stretch_start = sel(any, Vec4(record.ray.start, record.metres), Vec4(0.0f));
  stretch_way = sel(any, Vec4(record.ray.direction, Float(1.0f)), Vec4(0.0f));
  stretch_flux = sel(any, Vec4(flux * Vec3(u.channel_share), Float(0.0f)), Vec4(0.0f));
}
