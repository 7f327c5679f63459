// What the camera sees without the glass: diffuse surfaces under all their light, before the sky.
#include "passes/shared/sky_model.glsl"
#include "passes/shared/camera_rays.glsl"
UNIFORMS_BEGIN
#include "passes/compose/compose_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, view_position)
TEXTURE(1, view_normal)
TEXTURE(2, view_albedo)
TEXTURE(3, view_emission)
TEXTURE(4, direct)
TEXTURE(5, caustic)
TEXTURE(6, environment)
TEXTURE(7, highlight)
TEXTURE(8, view_specular)
TEXTURE(9, view_ambient)
TEXTURE(10, layers)
TEXTURE(11, first_layer)
TEXTURE(12, ambient_occlusion)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, scene_color)
#include "passes/shared/directional_albedo.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/same_surface.glsl"
#include "passes/shared/sky_radiance.glsl"

// Irradiance from the environment. The gradient counts as two uniform hemispheres, for which a surface
// leaning by n.y sees (1 + n.y) / 2 of the upper one; the upper one's mean under the cosine is a third of
// the horizon's radiance and two thirds of the zenith's; soft boxes add theirs.
Vec3 ambient_irradiance(Vec3 n) {
  Vec3 above = (Vec3(u.sky.horizon) + Vec3(u.sky.zenith) * 2.0f) / Float(3.0f) + Vec3(u.boxes_mean);
  Vec3 below = Vec3(u.sky.ground);
  Vec3 radiance = below + (above - below) * ((1.0f + n.y) * 0.5f);
  if (u.sky.has_image != 0) {
    radiance = Vec3(u.ambient_0) + Vec3(u.ambient_1) * n.y + Vec3(u.ambient_2) * n.z +
               Vec3(u.ambient_3) * n.x + Vec3(u.ambient_4) * (n.x * n.y) +
               Vec3(u.ambient_5) * (n.y * n.z) + Vec3(u.ambient_6) * (3.0f * n.z * n.z - 1.0f) +
               Vec3(u.ambient_7) * (n.x * n.z) + Vec3(u.ambient_8) * (n.x * n.x - n.y * n.y);
    radiance = Vec3(max_of(radiance.x, 0.0f), max_of(radiance.y, 0.0f), max_of(radiance.z, 0.0f));
  }
  return radiance * 3.14159265f;
}

// The way of the camera's ray through this pixel's middle.
Vec3 ray_direction() {
  Vec3 forward = Vec3(u.camera.forward);
  Vec3 direction = forward;
  if (u.camera.is_perspective != 0) {
    Float x = frag_x() * u.camera.pixel.x + u.camera.corner.x;
    Float y = frag_y() * u.camera.pixel.y + u.camera.corner.y;
    direction = normalize_or(forward + Vec3(u.camera.right) * x + Vec3(u.camera.up) * y, forward);
  }
  return direction;
}

// What a surface mirrors of the environment along a camera's ray: between the sharp image and the mean over
// the cosine by its roughness, times glTF's specular BRDF over all directions.
Vec3 mirrored_environment(Vec3 n, Vec3 sight, Vec4 specular) {
  Float cosine = clamp_to(-dot3(n, sight), 0.0f, 1.0f);
  Vec3 onward = normalize_or(sight + n * (2.0f * cosine), n);
  Float roughness = specular.w;
  Vec3 blurred = ambient_irradiance(onward) * 0.318309886f;
  Bool smooth_enough = roughness < 1.0f;
  Vec3 sharp = blurred;
  if (any_lane(smooth_enough)) sharp = sky_radiance(u.sky, onward);
  Vec3 radiance = sel(smooth_enough, sharp * (1.0f - roughness) + blurred * roughness, blurred);
  DirectionalAlbedo albedo = directional_albedo(cosine, roughness);
  Float whitest = max_of(max_of(specular.x, specular.y), specular.z);
  return radiance * (Vec3(specular) * albedo.scale + Vec3(grazing_reflectance(whitest) * albedo.bias));
}

// rgb: radiance of the blended surfaces that are nearer, w: how much passes them.
Vec4 layers_before(Int column, Int row) {
  Vec4 nearer = fetch_clamped(layers, column, row);
  Vec4 none = Vec4(0.0f, 0.0f, 0.0f, 1.0f);
  if (u.layer == 0) nearer = sel(is_covered(fetch_clamped(first_layer, column, row)), nearer, none);
  return nearer;
}

// The share of the environment's light that other surfaces leave, between the four nearest texels of
// ambient_occlusion on the same surface. Those are means whose middles lie at pixels 4 i.
Float share_left(Int column, Int row, Vec3 n) {
  Vec3 position = Vec3(texel_fetch(view_position, column, row));
  Int i = column / 4;
  Int j = row / 4;
  Float x = Float(column - i * 4) * 0.25f;
  Float y = Float(row - j * 4) * 0.25f;
  Float sum = Float(0.0f);
  Float weights = Float(0.0f);
  for (int dy = 0; dy < 2; dy++)
    for (int dx = 0; dx < 2; dx++) {
      Vec4 other = fetch_clamped(ambient_occlusion, i + dx, j + dy);
      Float beside = sel(Bool(dx == 0), 1.0f - x, x) * sel(Bool(dy == 0), 1.0f - y, y);
      Float weight = same_surface(position, n, other) * max_of(beside, 1.0e-4f);
      sum = sum + (other.w - 1.0f) * weight;
      weights = weights + weight;
    }
  return sel(weights > 0.0f, sum / sel(weights > 0.0f, weights, Float(1.0f)), Float(1.0f));
}

// What a surface shows of its own: its light, and what it reflects.
Vec3 surface_radiance(Int column, Int row, Vec3 albedo) {
  Vec3 n = Vec3(texel_fetch(view_normal, column, row));
  // What the frame lacks is one texel of zeros.
  Vec3 emission = Vec3(fetch_clamped(view_emission, column, row));
  Vec3 ambient = ambient_irradiance(n);
  Vec3 mirrored = Vec3(0.0f);
  if (u.mirrors != 0)
    mirrored = mirrored_environment(n, ray_direction(), fetch_clamped(view_specular, column, row));
  if (u.is_occluded != 0) {
    Float share = fetch_clamped(view_ambient, column, row).x;
    ambient = ambient * share;
    mirrored = mirrored * share;
  }
  if (u.has_ambient_occlusion != 0) {
    Float left = share_left(column, row, n);
    ambient = ambient * left;
    mirrored = mirrored * left;
  }
  Vec3 irradiance = Vec3(fetch_clamped(direct, column, row)) +
                    Vec3(fetch_clamped(caustic, column, row)) + ambient;
  // Glass shows what a surface mirrors of the lights towards the camera, though it looks from another side:
  // rough metal shows nothing else.
  Vec3 surface = emission + (albedo * 0.318309886f) * irradiance + mirrored;
  if (u.mirrors != 0) surface = surface + Vec3(fetch_clamped(highlight, column, row));
  return surface;
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  // Where there is no layer at all.
  if (u.layer != 0) discard_if(!is_covered(fetch_clamped(first_layer, column, row)));
  Bool covered = is_covered(texel_fetch(view_position, column, row));
  if (u.behind_glass != 0) discard_if(!covered);
  Vec4 colour = texel_fetch(view_albedo, column, row);
  Vec3 surface = Vec3(0.0f);
  if (any_lane(covered)) surface = surface_radiance(column, row, Vec3(colour));
  Vec4 nearer = Vec4(0.0f, 0.0f, 0.0f, 1.0f);
  if (u.blends != 0 && u.layer != 1) nearer = layers_before(column, row);
  Vec3 color = Vec3(0.0f);
  Float passes = Float(1.0f);
  if (u.behind_glass != 0) {
    color = sel(covered, surface * colour.w, color);
    passes = sel(covered, 1.0f - colour.w, passes);
  } else if (u.layer != 0) {
    color = sel(covered, surface * colour.w, color);
    Bool takes = covered && !is_on_glass(texel_fetch(view_position, column, row));
    passes = nearer.w * sel(takes, 1.0f - colour.w, Float(1.0f));
  } else {
    Vec3 background = backdrop_radiance(u.sky, ray_direction());
    color = sel(covered, surface * colour.w + background * (1.0f - colour.w), background);
  }
  if (u.blends != 0) color = Vec3(nearer) + color * nearer.w;
  scene_color = Vec4(color, passes);
}
#endif
