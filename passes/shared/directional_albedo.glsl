// Of glTF's specular BRDF, what it sends back of light of 1 from all around: a reflectance at normal
// incidence times `scale`, plus one at grazing incidence times `bias`. What a reflectance of 1 sends back is
// fitted to its integral, to 2 % in the mean and 11 % at grazing view; the bias is from Karis, "Physically
// based shading on mobile", 2014.
struct DirectionalAlbedo {
  Float scale;
  Float bias;
};

// `cosine`: between the view and the normal.
DirectionalAlbedo directional_albedo(Float cosine, Float roughness) {
  Float smoothness = 1.0f - roughness;
  Float grazing = min_of(smoothness * smoothness, exp_of(cosine * -6.43240f)) * smoothness + 0.0425f -
                  0.0275f * roughness;
  DirectionalAlbedo albedo;
  albedo.bias = max_of(grazing * 1.04f + 0.022f * roughness - 0.04f, 0.0f);
  Float squared = roughness * roughness;
  Float lost = squared * (0.940f - 1.039f * cosine - 0.371f * roughness + 2.734f * (squared * cosine));
  albedo.scale = Float(1.0f) / (1.0f + max_of(lost, 0.0f)) - albedo.bias;
  return albedo;
}

// The reflectance at grazing incidence, told by the one at normal incidence: 1, but less where that is below
// 0.02, which only KHR_materials_specular makes of solids (Lagarde and de Rousiers 2014).
Float grazing_reflectance(Float normal_incidence) { return min_of(normal_incidence * 50.0f, Float(1.0f)); }

Float sent_back(IN(DirectionalAlbedo) albedo, Float reflectance) {
  return reflectance * albedo.scale + grazing_reflectance(reflectance) * albedo.bias;
}
