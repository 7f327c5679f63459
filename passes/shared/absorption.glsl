// What the body that light was last to enter leaves of it over a length in metres. `body`: its row in
// caster_materials plus 1; 0: none. Needs caster_material.glsl and optics.glsl.
Vec3 left_by(Float body, Float metres) {
  Material material = fetch_material(caster_materials, floor_to_int(body) - 1);
  return sel(body > 0.0f, transmittance(material.absorption, metres), Vec3(1.0f));
}
