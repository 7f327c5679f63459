// From radiance to what a screen shows: exposure, a tone curve that keeps colours, the sRGB curve.
UNIFORMS_BEGIN
#include "passes/tone_map/tone_map_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, beauty)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, picture)

// The Khronos PBR Neutral tone mapper (github.com/KhronosGroup/ToneMapping, PBR_Neutral, 2024): colours stay
// as they are up to 0.8, what is brighter is compressed towards 1 and, far beyond, towards white.
Vec3 neutral(Vec3 c) {
  Float least = min_of(c.x, min_of(c.y, c.z));
  Float offset = sel(least < 0.08f, least - 6.25f * least * least, Float(0.04f));
  Vec3 shifted = c - Vec3(offset);
  Float peak = max_of(shifted.x, max_of(shifted.y, shifted.z));
  float start = 0.76f;
  float room = 1.0f - start;
  Float pressed = 1.0f - room * room / (max_of(peak, start) + room - start);
  Vec3 scaled = shifted * (pressed / max_of(peak, start));
  Float towards_white = 1.0f - 1.0f / (0.15f * (max_of(peak, start) - pressed) + 1.0f);
  Vec3 bright = scaled * (1.0f - towards_white) + Vec3(pressed) * towards_white;
  return sel(peak < start, shifted, bright);
}

// IEC 61966-2-1.
Float encoded(Float linear_value) {
  Float v = clamp_to(linear_value, 0.0f, 1.0f);
  return sel(v <= 0.0031308f, v * 12.92f, 1.055f * pow_of(v, Float(1.0f / 2.4f)) - 0.055f);
}

void main() {
  Vec4 radiance = texel_fetch(beauty, floor_to_int(frag_x()), floor_to_int(frag_y()));
  Vec3 exposed = Vec3(clamp_to(radiance.x * u.exposure, 0.0f, 1.0e6f),
                      clamp_to(radiance.y * u.exposure, 0.0f, 1.0e6f),
                      clamp_to(radiance.z * u.exposure, 0.0f, 1.0e6f));
  // As film has it: brighter or darker than a mid grey by a power, the colour as it is. Shadows and dark
  // glass get less of it, so that they do not turn black.
  float middle = 0.31f;
  if (u.contrast > 1.0f) {
    Float peak = max_of(exposed.x, max_of(exposed.y, exposed.z));
    Float more = sel(peak < middle, Float(u.contrast_in_dark), Float(u.contrast)) - 1.0f;
    exposed = exposed * pow_of(peak / middle, more);
  }
  Vec3 toned = exposed;
  if (u.is_linear == 0) toned = neutral(exposed);
  picture = Vec4(encoded(toned.x), encoded(toned.y), encoded(toned.z), Float(1.0f));
}
#endif
