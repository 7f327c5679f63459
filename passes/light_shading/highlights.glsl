// What surfaces in view mirror of the light. Needs tangent_plane.glsl, shadows.glsl,
// highlight.glsl, caster_material.glsl, optics.glsl.

// Where the camera's ray to a point comes from.
Vec3 towards_camera(Vec3 p) {
  Vec3 sight = Vec3(u.forward);
  if (u.is_perspective != 0) sight = normalize_or(p - Vec3(u.eye), sight);
  return -sight;
}

Float depth_of(Vec3 p) { return dot3(p - Vec3(u.eye), Vec3(u.forward)); }

// Of a diffuse surface's coat or of rough metal, for its irradiance. A caustic's counts as if it came
// straight from the light: maps hold no directions.
Vec3 receiver_highlight(IN(SurfacePoint) surface, Vec3 irradiance) {
  // One texel of zeros where no picture is wanted of the frame.
  Vec4 specular = fetch_clamped(view_specular, surface.column, surface.row);
  Incidence light = incidence_of(u.light, surface.position, surface.normal);
  Vec3 l = -light.travel;
  Vec3 v = towards_camera(surface.position);
  Float lobe = highlight_lobe(surface.normal, v, l, specular.w, half_width(u.light, light));
  Float grazing = grazing_reflectance(max_of(max_of(specular.x, specular.y), specular.z));
  return irradiance * schlick_reflectance(Vec3(specular), grazing, highlight_cosine(v, l)) * lobe;
}

// Reflectance of a caster at normal incidence.
Vec3 facing_reflectance(IN(Material) material) {
  Float r = (material.ior - 1.0f) / (material.ior + 1.0f);
  return sel(material.mirror, material.color, Vec3(r * r * material.fresnel));
}

// A caster's point, its normal on the camera's side.
Vec3 highlight_of_caster(IN(SurfacePoint) caster, IN(Material) material) {
  Incidence light = incidence_of(u.light, caster.position, caster.normal);
  TangentPlane p = tangent_plane(u.shadow_view, caster.position, caster.normal);
  Float lit = Float(1.0f);
  if (u.has_shadow_map != 0) lit = 1.0f - shadow_share(p);
  Vec3 v = towards_camera(caster.position);
  Float grazing = sel(material.mirror, Float(1.0f), material.fresnel);
  Vec3 reflectance =
      schlick_reflectance(facing_reflectance(material), grazing, highlight_cosine(v, -light.travel));
  Vec3 tint = tint_at(caster, p);
  if (u.has_walls != 0) {
    // A pane takes nothing from itself; what others before it take is not known apart.
    tint = sel(material.thin, Vec3(1.0f), tint);
    Vec3 both_faces = reflectance * 2.0f / (reflectance + Vec3(1.0f));
    reflectance = sel(material.thin, both_faces, reflectance);
  }
  Float size = half_width(u.light, light);
  Float lobe = highlight_lobe(caster.normal, v, -light.travel, material.roughness, size);
  return irradiance_by(light, tint, lit) * reflectance * lobe;
}

// Of glass and metal before the surface: none on surfaces seen from inside, which panes are not.
Vec3 first_caster_highlight(IN(SurfacePoint) surface) {
  Vec4 position = fetch_clamped(view_caster_position, surface.column, surface.row);
  Vec4 normal = fetch_clamped(view_caster_normal, surface.column, surface.row);
  Bool before = is_covered(position) &&
                (!surface.visible || depth_of(Vec3(position)) < depth_of(surface.position));
  Bool shines = before && (!is_back_face(position) || Bool(u.has_walls != 0));
  Vec3 result = Vec3(0.0f);
  if (any_lane(shines)) {
    SurfacePoint caster = surface;
    caster.position = Vec3(position);
    Material material = fetch_material(caster_materials, material_row(normal));
    Bool inside = is_back_face(position);
    caster.normal = facing_normal(Vec3(normal), -towards_camera(caster.position), inside);
    shines = shines && (!inside || material.thin);
    result = sel(shines, highlight_of_caster(caster, material), result);
  }
  return result;
}
