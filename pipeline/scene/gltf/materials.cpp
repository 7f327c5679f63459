#include "pipeline/scene/gltf/materials.hpp"

#include <algorithm>
#include <charconv>

namespace caustics::gltf {

namespace {

std::string text(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  return std::string(digits, end);
}

double clamped(Context& context, const std::string& path, double value, double lowest, double highest) {
  const double result = std::min(std::max(value, lowest), highest);
  if (result != value) context.note(path + " is " + text(value) + "; " + text(result) + " is used.");
  return result;
}

float factor(Context& context, const Cursor& cursor, double fallback, double lowest, double highest) {
  return static_cast<float>(clamped(context, cursor.path(), cursor.number(fallback), lowest, highest));
}

glm::vec3 color_factor(Context& context, const Cursor& cursor, const glm::vec3& fallback) {
  const std::vector<double> values = cursor.numbers(3);
  if (values.empty()) return fallback;
  glm::vec3 color;
  for (int c = 0; c < 3; ++c) {
    color[c] = factor(context, cursor.element(static_cast<std::size_t>(c)), 0, 0, 1);
  }
  return color;
}

class Reader {
 public:
  Reader(Context& context, Textures& textures, const Cursor& material)
      : context_(context),
        textures_(textures),
        material_(material),
        extensions_(material.member("extensions")),
        older_(extensions_.member("KHR_materials_pbrSpecularGlossiness")) {}

  Material run(int& uv_set) {
    result_.name = printable(material_.member("name").string(""));
    read_core();
    read_alpha();
    read_transmission();
    read_ior();
    read_specular();
    read_volume();
    uv_set = read_textures();
    return result_;
  }

 private:
  void read_core();
  void read_metallic_roughness(const Cursor& pbr);
  void read_specular_glossiness(const Cursor& older);
  // KHR_materials_pbrSpecularGlossiness has another for its colour, and none for metal.
  Cursor base_color_texture() const {
    return older_.present() ? older_.member("diffuseTexture")
                            : material_.member("pbrMetallicRoughness").member("baseColorTexture");
  }
  Cursor metallic_roughness_texture() const {
    const Cursor core = older_.present() ? older_ : material_.member("pbrMetallicRoughness");
    return core.member("metallicRoughnessTexture");
  }
  void read_alpha();
  void read_transmission();
  void read_ior();
  void read_specular();
  void read_volume();
  int read_textures();
  void read_coverage();
  TextureUse placed(const Cursor& info, int set, Reading reading);

  Context& context_;
  Textures& textures_;
  const Cursor& material_;
  Cursor extensions_, older_;
  Material result_;
};

// As metallic-roughness: what has no diffuse colour and mirrors more than any dielectric is metal of its
// specular colour, all else is none.
void Reader::read_specular_glossiness(const Cursor& older) {
  constexpr float kMostOfDielectrics = 0.2f;
  const glm::vec3 specular = color_factor(context_, older.member("specularFactor"), glm::vec3(1));
  const bool is_metal = glm::vec3(result_.base_color) == glm::vec3(0) && !base_color_texture().present() &&
                        std::max({specular.x, specular.y, specular.z}) > kMostOfDielectrics;
  if (is_metal) result_.base_color = glm::vec4(specular, result_.base_color.a);
  result_.metallic = result_.metallic_factor = is_metal ? 1.0f : 0.0f;
  const auto glossiness = textures_.mean(older.member("specularGlossinessTexture"), 3);
  result_.roughness = 1.0f - factor(context_, older.member("glossinessFactor"), 1, 0, 1) *
                                 static_cast<float>(glossiness.value_or(1.0));
  result_.roughness_factor = result_.roughness;
}

void Reader::read_core() {
  const Cursor pbr = material_.member("pbrMetallicRoughness");
  const Cursor base = older_.present() ? older_.member("diffuseFactor") : pbr.member("baseColorFactor");
  if (!base.numbers(4).empty()) {
    for (std::size_t c = 0; c < 4; ++c) {
      result_.base_color[static_cast<int>(c)] = factor(context_, base.element(c), 1, 0, 1);
    }
  }
  if (older_.present()) {
    read_specular_glossiness(older_);
  } else {
    read_metallic_roughness(pbr);
  }
  const Cursor strength = extensions_.member("KHR_materials_emissive_strength").member("emissiveStrength");
  result_.emissive = color_factor(context_, material_.member("emissiveFactor"), glm::vec3(0)) *
                     factor(context_, strength, 1, 0, 1e9);
  result_.double_sided = material_.member("doubleSided").boolean(false);
  const Cursor unlit = extensions_.member("KHR_materials_unlit");
  unlit.keys();  // must be an object
  result_.unlit = unlit.present();
}

void Reader::read_metallic_roughness(const Cursor& pbr) {
  result_.metallic = factor(context_, pbr.member("metallicFactor"), 1, 0, 1);
  result_.roughness = factor(context_, pbr.member("roughnessFactor"), 1, 0, 1);
  const Cursor both = pbr.member("metallicRoughnessTexture");
  const auto roughness = textures_.mean(both, 1), metallic = textures_.mean(both, 2);
  result_.roughness_factor = result_.roughness;
  result_.metallic_factor = result_.metallic;
  if (roughness) result_.roughness *= static_cast<float>(*roughness);
  if (metallic) result_.metallic *= static_cast<float>(*metallic);
}

void Reader::read_alpha() {
  const Cursor mode = material_.member("alphaMode");
  const std::string name = mode.string("OPAQUE");
  if (name == "MASK") {
    result_.alpha_mode = AlphaMode::Mask;
  } else if (name == "BLEND") {
    result_.alpha_mode = AlphaMode::Blend;
  } else if (name != "OPAQUE") {
    context_.note(mode.path() + " is " + name + "; OPAQUE is used.");
  }
  result_.alpha_cutoff = factor(context_, material_.member("alphaCutoff"), 0.5, 0, 1e6);
}

void Reader::read_transmission() {
  const Cursor extension = extensions_.member("KHR_materials_transmission");
  result_.transmission = factor(context_, extension.member("transmissionFactor"), 0, 0, 1);
  result_.transmission_factor = result_.transmission;
  const auto mean = textures_.mean(extension.member("transmissionTexture"), 0);
  // What decides whether a material is glass or a mirror is one number a material.
  const Cursor both = material_.member("pbrMetallicRoughness").member("metallicRoughnessTexture");
  if (both.present() && (result_.transmission > 0 || result_.metallic >= 0.5f)) {
    context_.note(both.path() + ": its means decide what the whole material is.");
  }
  if (mean) result_.transmission *= static_cast<float>(*mean);
}

void Reader::read_ior() {
  const Cursor ior = extensions_.member("KHR_materials_ior").member("ior");
  const double value = ior.number(1.5);
  if (value < 0) {
    ior.fail("is " + text(value) + ", an index of refraction cannot be negative",
             "use 1.33 for water, 1.5 for glass");
  }
  if (value > 0 && value < 1) {
    context_.note(ior.path() + " is " + text(value) +
                  ", below 1: taken as a bubble's, relative to its surroundings.");
  }
  result_.ior = static_cast<float>(clamped(context_, ior.path(), value, 0, 100));
  // Below this, a tiny index would overflow when divided by.
  if (result_.ior > 0 && result_.ior < 0.01f) result_.ior = 0.01f;
}

// Its textures count by their means.
void Reader::read_specular() {
  const Cursor specular = extensions_.member("KHR_materials_specular");
  result_.fresnel_factor =
      factor(context_, specular.member("specularFactor"), 1, 0, 1) *
      static_cast<float>(textures_.mean(specular.member("specularTexture"), 3).value_or(1.0));
  const Cursor color = specular.member("specularColorFactor");
  const Cursor texture = specular.member("specularColorTexture");
  for (std::size_t c = 0; c < 3; ++c)
    result_.specular_color[static_cast<int>(c)] =
        (color.present() ? factor(context_, color.element(c), 1, 0, 1000) : 1.0f) *
        static_cast<float>(textures_.mean(texture, static_cast<int>(c)).value_or(1.0));
}

void Reader::read_volume() {
  const Cursor volume = extensions_.member("KHR_materials_volume");
  result_.thickness = factor(context_, volume.member("thicknessFactor"), 0, 0, 1e12);
  result_.attenuation_color = color_factor(context_, volume.member("attenuationColor"), glm::vec3(1));
  const Cursor distance = volume.member("attenuationDistance");
  if (distance.present()) {
    const double value = distance.number();
    if (value > 0) {
      result_.attenuation_distance = static_cast<float>(std::min(std::max(value, 1e-12), 1e30));
    } else {
      context_.note(distance.path() + " is " + text(value) +
                    ", but must be above 0: nothing is absorbed, as without it.");
    }
  }
  const Cursor dispersion = extensions_.member("KHR_materials_dispersion").member("dispersion");
  result_.dispersion = factor(context_, dispersion, 0, 0, 20);
}

TextureUse Reader::placed(const Cursor& info, int set, Reading reading) {
  if (!info.present()) return {};
  if (Textures::uv_set(info) != set && !textures_.is_surveying()) {
    context_.note(info.path() + " uses TEXCOORD_" + std::to_string(Textures::uv_set(info)) +
                  ", other textures of the material TEXCOORD_" + std::to_string(set) + "; it is left out.");
    return {};
  }
  return textures_.use(info, reading);
}

// What a blended material's texture covers at least and at most.
void Reader::read_coverage() {
  if (result_.alpha_mode != AlphaMode::Blend || !result_.base_color_texture.present()) return;
  const auto [least, most] = textures_.alpha_range(result_.base_color_texture.image);
  result_.least_alpha = least;
  result_.most_alpha = most;
}

int Reader::read_textures() {
  const Cursor base = base_color_texture();
  const Cursor normal = material_.member("normalTexture");
  const Cursor emissive = material_.member("emissiveTexture");
  const Cursor both = metallic_roughness_texture();
  const Cursor occlusion = material_.member("occlusionTexture");
  // One set of coordinates serves all. Where light passes, the normals matter more than the colour.
  const bool normal_first = result_.transmission > 0 && normal.present();
  const Cursor& first = normal_first         ? normal
                        : base.present()     ? base
                        : normal.present()   ? normal
                        : emissive.present() ? emissive
                        : both.present()     ? both
                                             : occlusion;
  const int set = Textures::uv_set(first);
  // First: its means were just read.
  result_.metallic_roughness_texture = placed(both, set, Reading::Data);
  result_.base_color_texture = placed(base, set, Reading::Color);
  read_coverage();
  result_.normal_texture = placed(normal, set, Reading::FineData);
  result_.normal_scale = factor(context_, normal.member("scale"), 1, -1000, 1000);
  result_.emissive_texture = placed(emissive, set, Reading::Color);
  result_.occlusion_texture = placed(occlusion, set, Reading::Data);
  result_.occlusion_strength = factor(context_, occlusion.member("strength"), 1, 0, 1);
  if (result_.transmission > 0) {
    const Cursor extension = extensions_.member("KHR_materials_transmission");
    result_.transmission_texture = placed(extension.member("transmissionTexture"), set, Reading::FineData);
  }
  return set;
}

}  // namespace

Materials read_materials(Context& context, const Document& document, const Used& used, Textures& textures) {
  Materials materials;
  const Cursor all = document.root(context).member("materials");
  const std::vector<std::string> notes = context.notes();
  for (std::size_t i = 0; i < all.size(); ++i) {
    int ignored = 0;
    if (used.materials[i]) Reader(context, textures, all.element(i)).run(ignored);
  }
  textures.fit();
  context.notes() = notes;  // the second reading makes them anew
  for (std::size_t i = 0; i < all.size(); ++i) {
    int set = 0;
    const Cursor material = all.element(i);
    materials.list.push_back(used.materials[i] ? Reader(context, textures, material).run(set) : Material());
    if (materials.list.back().name.empty()) materials.list.back().name = material.path();
    materials.uv_sets.push_back(set);
  }
  Material fallback;
  fallback.name = "glTF default";
  materials.list.push_back(fallback);
  materials.uv_sets.push_back(0);
  return materials;
}

}  // namespace caustics::gltf
