// A thin pane that does not let all light through: what it keeps is a diffuse layer in the same place.
struct PaneLayer {
  Float there;        // coverage: the share of the surface that there is
  Float transmitted;  // share of what is not mirrored that goes through
};

// Least share that counts as let through, so that what is divided by it stays finite.
#define LEAST_TRANSMITTED 1.0e-3f

// The layer at this point, whose base colour has this opacity. Needs material.glsl, transformed_uv.glsl, the
// varying surface_uv, the texture transmission_texture and the uniforms of a pane.
PaneLayer layer_here(Float opacity) {
  PaneLayer layer;
  layer.there = Float(1.0f);
  if (u.is_covering != 0) layer.there = opacity;
  layer.transmitted = Float(u.transmitted);
  if (u.has_transmission != 0) {
    Vec2 at = transformed_uv(u.transmission_uv, surface_uv);
    layer.transmitted = layer.transmitted * fetch_wrapped(transmission_texture, u.transmission_uv, at).x;
  }
  layer.transmitted = max_of(layer.transmitted, LEAST_TRANSMITTED);
  return layer;
}

// The share of what lies behind that the layer leaves.
Float layer_passes(IN(PaneLayer) layer) { return 1.0f - layer.there * (1.0f - layer.transmitted); }

// Reflectance of one of a pane's two faces, for light of 1 as a whole. Needs optics.glsl.
Float pane_reflectance(Float cosine, float ior) {
  Float eta = Float(1.0f / ior);
  return fresnel_reflectance(eta, cosine, sqrt(max_of(transmitted_cosine_squared(eta, cosine), 0.0f)));
}

// The share of each channel that goes straight through. Between two parallel faces of reflectance r
// the reflections add up to (1 - r) / (1 + r), whatever the pane's thickness; the colour counts once.
Vec3 pane_passes(IN(PaneLayer) layer, Vec3 color, Float r) {
  Vec3 through = color * (layer.transmitted * ((1.0f - r) / (1.0f + r)));
  return Vec3(1.0f - layer.there) + through * layer.there;
}
