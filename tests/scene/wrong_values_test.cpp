// Every value of a glTF file in turn is left out or becomes another one, of its own type or not: the file is
// refused, or the scene has certain bits. wrong_values.txt keeps a hash of all answers for each place;
// `caustics_tests '[.wrong_values]'` writes it anew. Whoever changes a line says in the commit why.
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/scene/file_of_all.hpp"

using namespace caustics;
using namespace caustics::test;
using Json = nlohmann::json;

namespace {

// FNV-1a of what is given one after the other, floats by their bits.
class Hash {
 public:
  Hash& bytes(const void* data, std::size_t count) {
    for (const auto* at = static_cast<const unsigned char*>(data); count > 0; --count, ++at)
      value_ = (value_ ^ *at) * 0x100000001b3u;
    return *this;
  }
  Hash& operator<<(const std::string& text) { return bytes(text.data(), text.size() + 1); }
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T> Hash& operator<<(T value) {
    return bytes(&value, sizeof value);
  }
  template <glm::length_t N, class T>
  Hash& operator<<(const glm::vec<N, T>& v) {
    return bytes(&v, N * sizeof(T));
  }
  template <class T>
  Hash& operator<<(const std::vector<T>& all) {
    *this << all.size();
    for (const T& each : all) *this << each;
    return *this;
  }
  std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value_));
    return digits;
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

Hash& operator<<(Hash& hash, const Image& image) {
  return hash << image.shape.format << image.width() << image.height() << image.values;
}
Hash& operator<<(Hash& hash, const TextureUse& use) {
  return hash << use.image << use.uv_transform[0] << use.uv_transform[1] << use.uv_transform[2] << use.wrap_u
              << use.wrap_v << use.nearest << use.levels;
}
Hash& operator<<(Hash& hash, const Material& m) {
  hash << m.name << m.base_color << m.base_color_texture << m.least_alpha << m.most_alpha << m.normal_texture
       << m.normal_scale << m.alpha_mode << m.alpha_cutoff << m.emissive << m.emissive_texture << m.metallic;
  hash << m.roughness << m.metallic_roughness_texture << m.roughness_factor << m.metallic_factor
       << m.occlusion_texture << m.occlusion_strength << m.double_sided << m.unlit << m.transmission;
  return hash << m.transmission_texture << m.ior << m.thickness << m.attenuation_color
              << m.attenuation_distance << m.dispersion << m.fresnel_factor;
}
Hash& operator<<(Hash& hash, const Vertex& v) { return hash << v.position << v.normal << v.tangent << v.uv; }
Hash& operator<<(Hash& hash, const Mesh& m) {
  return hash << m.name << m.vertices << m.colors << m.indices << m.material << m.object << m.closedness
              << m.inside_out << m.lower << m.upper << m.outline << m.has_uv;
}
Hash& operator<<(Hash& hash, const Light& l) {
  hash << l.name << l.type << l.color << l.intensity << l.position << l.direction << l.range << l.inner_cone;
  return hash << l.outer_cone << l.lambertian << l.shape << l.radius << l.width << l.height
              << l.angular_radius;
}
Hash& operator<<(Hash& hash, const Camera& c) {
  return hash << c.name << c.orthographic << c.position << c.right << c.up << c.forward << c.vertical_fov
              << c.half_width << c.half_height << c.near << c.far;
}
Hash& operator<<(Hash& hash, const Water& w) {
  return hash << w.name << w.mesh << w.radius << w.height << w.corner << w.right << w.across << w.columns
              << w.rows << w.dx << w.dz << w.step << w.steps_per_plop << w.plop_steps << w.highest
              << w.settings.damping << w.settings.start << w.settings.seed << w.steps_until(1.0);
}
Hash& operator<<(Hash& hash, const SineWave& wave) { return hash << wave.amplitude << wave.k << wave.phase; }
Hash& operator<<(Hash& hash, const StatedShape& shape) {
  return hash << shape.mesh << shape.kind << shape.field.level << shape.field.waves << shape.field.axes[0]
              << shape.field.axes[2] << shape.field.origin;
}
Hash& operator<<(Hash& hash, const Scene& s) {
  hash << s.origin << s.meshes << s.materials << s.images << s.coarser << s.lights << s.cameras << s.waters;
  return hash << s.stated_shapes << s.medium.scattering << s.medium.absorption << s.medium.anisotropy
              << s.notes;
}

// What becomes of a file: why it is refused, or a hash of its scene at two moments.
std::string answer_to(const Json& file) {
  const std::string text = file.dump();
  LoadOptions options;
  options.content = std::make_shared<const std::vector<std::uint8_t>>(text.begin(), text.end());
  try {
    const AnimatedScene scene = load_animated("scene.gltf", options);
    Hash hash;
    return (hash << scene.duration() << scene.start() << scene.at(0.3)).text();
  } catch (const Error& error) {
    return error.what();
  }
}

// What a value may wrongly become; null: it is left out.
std::vector<Json> others(const Json& value) {
  std::vector<Json> all = {nullptr};
  if (value.is_number()) {
    const double number = value.get<double>();
    for (const double other : {-1.0, 0.0, 1.0, 2.0, number + 0.25, number * 1.5, 1e5, 1e300})
      all.push_back(other);
    all.push_back(value.get<std::int64_t>() + 1);
    all.push_back("text");
  } else if (value.is_string()) {
    for (const char* other : {"", "other", "OPAQUE", "data:,"}) all.push_back(other);
    all.push_back(7);
  } else if (value.is_boolean()) {
    all.push_back(!value.get<bool>());
    all.push_back(1);
  } else if (value.is_array()) {
    Json shorter = value, longer = value;
    shorter.erase(shorter.size() - 1);
    longer.push_back(value.back());
    for (const Json& other : {shorter, longer, Json::object(), Json::array()}) all.push_back(other);
  } else {
    for (const Json& other : {Json::array(), Json::object(), Json(5)}) all.push_back(other);
  }
  return all;
}

// All places of a document but its roots' own.
void find_places(const Json& value, const std::string& path, std::vector<std::string>& places) {
  if (!path.empty()) places.push_back(path);
  if (!value.is_structured()) return;
  for (const auto& [key, part] : value.items()) find_places(part, path + "/" + key, places);
}

// The answers to all that may stand at a place, one a line.
std::string answers_at(const std::string& path, const Json& file) {
  const Json::json_pointer place(path);
  std::string answers;
  for (const Json& other : others(file.at(place))) {
    Json changed = file;
    Json& parent = changed.at(place.parent_pointer());
    if (!other.is_null()) {
      changed.at(place) = other;
    } else if (parent.is_array()) {
      parent.erase(std::stoul(place.back()));
    } else {
      parent.erase(place.back());
    }
    answers += other.dump() + ": " + answer_to(changed) + "\n";
  }
  return answers;
}

std::string kept_path() {
  const std::string source = __FILE__;
  return source.substr(0, source.rfind("_test.cpp")) + ".txt";
}

std::vector<std::string> all_places() {
  std::vector<std::string> places;
  find_places(Json::parse(file_of_all()), "", places);
  return places;
}

}  // namespace

TEST_CASE("wrong values: each place of a file takes what it may, and refuses the rest as it always has") {
  std::map<std::string, std::string> kept;
  std::ifstream list(kept_path());
  for (std::string place, hash; list >> place >> hash;) kept[place] = hash;
  const Json file = Json::parse(file_of_all());
  INFO(answer_to(file));
  REQUIRE(answer_to(file).size() == 16);  // a hash: not refused
  const std::vector<std::string> places = all_places();
  CHECK(kept.size() == places.size());
  for (const std::string& place : places) {
    const std::string answers = answers_at(place, file);
    INFO(place << " as\n" << answers);
    CHECK((Hash() << answers).text() == kept[place]);
  }
}

TEST_CASE("wrong values: writes what is kept", "[.wrong_values]") {
  std::ofstream list(kept_path());
  const Json file = Json::parse(file_of_all());
  for (const std::string& place : all_places())
    list << place << " " << (Hash() << answers_at(place, file)).text() << "\n";
  CHECK(list.good());
}
