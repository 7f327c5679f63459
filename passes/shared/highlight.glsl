// The mirror image of a light without a size, spread by a surface's roughness: glTF 2.0's BRDF (appendix B.3;
// the distribution of Trowbridge and Reitz, Smith's shadowing), without Fresnel's factor. A smooth surface
// counts as LEAST_ROUGHNESS, so that what it shows of a light is some pixels wide.
#define LEAST_ROUGHNESS 0.2f

// Over the irradiance, per steradian. v, l: unit, from the surface to camera and light; n: its normal.
// `size`: half_width() of the light (incidence.glsl).
Float highlight_lobe(Vec3 n, Vec3 v, Vec3 l, Float roughness, Float size) {
  Float least = max_of(roughness, LEAST_ROUGHNESS);
  Float alpha = min_of(least * least + size, Float(1.0f));
  Float squared = alpha * alpha;
  Vec3 h = normalize_or(v + l, n);
  Float nl = clamp_to(dot3(n, l), 0.0f, 1.0f);
  Float nv = clamp_to(dot3(n, v), 0.0f, 1.0f);
  Float nh = clamp_to(dot3(n, h), 0.0f, 1.0f);
  // (n.h)^2 (alpha^2 - 1) + 1, by the sine, which does not cancel.
  Vec3 across = cross3(n, h);
  Float spread = max_of(squared * (nh * nh) + dot3(across, across), squared * squared);
  Float density = (squared * 0.318309886f) / (spread * spread);
  Float before = (nl + sqrt(squared + (1.0f - squared) * (nl * nl))) *
                 (nv + sqrt(squared + (1.0f - squared) * (nv * nv)));
  return sel(nl > 0.0f && nv > 0.0f, density / before, Float(0.0f));
}

// The cosine that Fresnel's factor takes.
Float highlight_cosine(Vec3 v, Vec3 l) {
  return clamp_to(dot3(v, normalize_or(v + l, v)), 0.0f, 1.0f);
}
