// A row of the texture caster_materials (pipeline/effects/ray_tables.cpp fills it), which `w` in a
// texture of casters' normals points to.
struct Material {
  Float ior;         // n_d
  Float dispersion;  // n_F - n_C
  Float fresnel;     // factor of what Fresnel's equations mirror
  Bool mirror;       // metal, which lets nothing in
  Bool thin;         // a rough wall: it mirrors by its index, but bends nothing
  Bool solid;        // closed: what enters leaves by a second surface
  Vec3 absorption;   // per metre
  Float roughness;
  Vec3 color;        // what is left of what glass lets through; what metal mirrors at normal incidence
  Float transmitted; // share of what glass does not mirror that goes through it; of what metal mirrors at
                     // normal incidence that its base colour does not tint
  Bool blended;      // a pane that is there in part,
  Float covers;      // and how much: a share of what lies behind
};

Int material_row(Vec4 normal_texel) { return floor_to_int(normal_texel.w + 0.5f); }

Material fetch_material(Texture materials, Int row) {
  Vec4 interface_texel = fetch_clamped(materials, Int(0), row);
  Vec4 inside_texel = fetch_clamped(materials, Int(1), row);
  Material material;
  material.ior = interface_texel.x;
  material.dispersion = interface_texel.y;
  material.fresnel = 1.0f - interface_texel.z;
  material.mirror = interface_texel.w > 0.5f;
  material.thin = interface_texel.w < -0.5f;
  material.solid = inside_texel.w > 0.5f;
  material.absorption = Vec3(inside_texel);
  Vec4 color_texel = fetch_clamped(materials, Int(2), row);
  material.color = Vec3(color_texel);
  material.roughness = color_texel.w;
  Vec4 share_texel = fetch_clamped(materials, Int(3), row);
  material.transmitted = share_texel.x;
  material.blended = share_texel.w < -0.5f;
  material.covers = sel(material.blended, share_texel.z, Float(1.0f));
  return material;
}

// A receiver's row has other meanings.
struct ReceiverMaterial {
  Vec3 emission;     // nit
  Bool one_sided;    // it is not seen from behind
  Vec3 albedo;       // of all that it sends back
  Vec3 fade_centre;  // from all of it to none, by the distance from here
  Float fade_from;
  Float fade_to;     // 0: it does not fade
  Bool is_colored;   // its vertices have colours, which stand in the place of their tangents
  Bool blended;      // it covers a share of what lies behind,
  Float opacity;     // this one, times its texture's
  Float opaque_from; // opacity from which it is opaque, and a mask leaves no hole
};

ReceiverMaterial fetch_receiver(Texture materials, Int row) {
  Vec4 fade_texel = fetch_clamped(materials, Int(1), row);
  ReceiverMaterial receiver;
  Vec4 emission_texel = fetch_clamped(materials, Int(0), row);
  receiver.emission = Vec3(emission_texel);
  receiver.one_sided = emission_texel.w > 0.5f;
  Vec4 cover_texel = fetch_clamped(materials, Int(3), row);
  receiver.blended = cover_texel.x > 1.5f;
  receiver.is_colored = cover_texel.x - sel(receiver.blended, Float(2.0f), Float(0.0f)) > 0.5f;
  receiver.opacity = cover_texel.z;
  receiver.opaque_from = cover_texel.w;
  receiver.albedo = Vec3(fetch_clamped(materials, Int(2), row));
  receiver.fade_centre = Vec3(fade_texel);
  receiver.fade_from = fade_texel.w;
  receiver.fade_to = fetch_clamped(materials, Int(2), row).w;
  return receiver;
}
