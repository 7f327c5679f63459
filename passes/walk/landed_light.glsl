// What is kept of a vertex' light: where it lands, and what is booked on the way. In `stretches` other things
// are kept of the same walk (passes/stretches/drawn_stretch.glsl).
struct Record {
  LandedLight landed;
  Bool ended;
};

Record empty_record(Int column, Int row) {
  Record record;
  record.landed = nothing_landed();
  record.ended = Bool(false);
  second_hit = Vec4(0.0f);
  return record;
}

Bool is_discarded(IN(Record) record) { return !record.ended; }

// Of a light's branches one books what is taken before the caster: by panes, of all channels but the
// brightest, and by the air.
void record_entry(INOUT(Record) record, Vec3 by_panes, Vec3 by_air) {
  Vec3 share = sel(Bool(u.mirrored_at == 0 && u.draws == 0), Vec3(u.channel_share), Vec3(0.0f));
  if (u.is_tinted != 0) record.landed.absorbed = by_panes * share;
#ifdef HAZE
  record.landed.taken_by_air = by_air * share;
#endif
}

void record_stretch(INOUT(Record) record, IN(LightPath) path, Float metres, Bool wanted) {}

// Books what stays at a surface. Before a branch parts from another, that other one does.
void record_surface(INOUT(Record) record, IN(BentLight) bent, Bool goes) {
  Vec3 share = Vec3(u.channel_share);
  LandedLight landed = record.landed;
  landed.fresnel = sel(goes, bent.booked * share + landed.fresnel, landed.fresnel);
  landed.absorbed = sel(goes, bent.absorbed * share + landed.absorbed, landed.absorbed);
#ifdef HAZE
  landed.taken_by_air = sel(goes, bent.taken_by_air * share + landed.taken_by_air, landed.taken_by_air);
#endif
  record.landed = landed;
}

void record_hit(Vec4 hit) { second_hit = hit; }

void record_end(INOUT(Record) record, IN(LightPath) path, Vec4 hit, Bool was_ended, Bool ends) {
  land_light(path, hit, was_ended, ends, record.landed);
  record.ended = record.ended || ends;
}

void write(IN(Record) record, Float entered) {
  LandedLight landed = record.landed;
  landing = landed.at;
  landing_flux = Vec4(landed.flux, Float(0.0f));
  landing_fresnel = Vec4(landed.fresnel, sel(Bool(u.mirrored_at == 0 && u.draws == 0), entered, Float(0.0f)));
  landing_absorbed = Vec4(landed.absorbed, Float(0.0f));
  landing_path = Vec4(landed.path, Float(1.0f), Float(0.0f), Float(0.0f));
  landing_footprint = landed.footprint;
#ifdef HAZE
  landing_medium = Vec4(landed.taken_by_air, Float(0.0f));
#endif
}
