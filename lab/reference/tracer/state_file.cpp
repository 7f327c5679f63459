#include "lab/reference/tracer/state_file.hpp"

#include <bit>
#include <cstring>
#include <type_traits>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/sha256.hpp"

namespace caustics::tracer {

namespace {

constexpr std::string_view kMagic = "caustics reference state 1\n";
constexpr std::string_view kEnd = "\n\n";

// Hashes values one by one: structures have gaps.
class Digest {
 public:
  template <class T>
  Digest& operator<<(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    sha_.add(&value, sizeof value);
    return *this;
  }
  template <int N, class T, glm::qualifier Q>
  Digest& operator<<(const glm::vec<N, T, Q>& v) {
    for (int i = 0; i < N; ++i) *this << v[i];
    return *this;
  }
  template <class T>
  void block(const std::vector<T>& values) {
    sha_.add(values.data(), values.size() * sizeof(T));
  }
  std::string text() { return sha_.hexadecimal().substr(0, 32); }

 private:
  Sha256 sha_;
};

std::string meshes_text(const Scene& scene, const Effects& effects) {
  Digest d;
  static_assert(sizeof(Vertex) == 12 * sizeof(float));
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i];
    d.block(mesh.vertices);
    d.block(mesh.indices);
    d << mesh.material << mesh.object << mesh.closedness << effects.surfaces[i].role
      << effects.surfaces[i].two_interfaces << effects.surfaces[i].rough << effects.surfaces[i].thin;
  }
  for (const Material& m : scene.materials)
    d << m.base_color << m.metallic << m.roughness << m.transmission << m.ior << m.thickness
      << m.attenuation_color << m.attenuation_distance << m.dispersion << m.double_sided << m.alpha_mode
      << m.alpha_cutoff << m.fresnel_factor << m.normal_scale;
  for (const Image& image : scene.images) d.block(image.values);
  const Bounds box = medium_bounds(scene);
  d << scene.medium.scattering << scene.medium.absorption << box.lower << box.upper;
  return d.text();
}

std::string lights_text(const Scene& scene, const Effects& effects) {
  Digest d;
  for (const Light& l : scene.sources)
    d << l.type << l.color << l.intensity << l.position << l.direction << l.range << l.inner_cone
      << l.outer_cone << l.lambertian << l.shape << l.radius << l.width << l.height << l.angular_radius
      << l.emitter;
  for (const Expectation& e : effects.expectations) d << e.light << e.mesh << e.expected;
  for (const Branch& b : effects.branches) d << b.reflected << b.bend << b.color;
  return d.text();
}

// Nothing where all is meshes.
std::string exact_text(const std::vector<ExactShape>& exact) {
  if (exact.empty()) return {};
  Digest d;
  for (const ExactShape& shape : exact)
    for (const double number : shape.numbers()) d << number;
  return "\nexact shapes: " + d.text();
}

std::string view_text(const View& f) {
  Digest d;
  d << f.origin << f.right << f.up << f.forward << f.perspective << f.window_lower << f.window_upper << f.near
    << f.far;
  return d.text();
}

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <class T>
void take(std::string_view& bytes, std::vector<T>& values) {
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  bytes.remove_prefix(values.size() * sizeof(T));
}

[[noreturn]] void refuse(const std::string& why) { throw Error(ExitCode::BadInput, why); }

// The first line of `wanted` that `there` has otherwise.
std::string difference(std::string_view there, std::string_view wanted) {
  while (!wanted.empty()) {
    const auto first_line = [](std::string_view& text) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      return line;
    };
    const std::string_view a = first_line(there), b = first_line(wanted);
    if (a != b) return std::string(a.substr(0, 80)) + " there, " + std::string(b) + " here";
  }
  return "it says more than is asked for";
}

}  // namespace

std::string request_text(const Scene& scene, const Effects& effects, const Camera& camera,
                         const TraceSettings& settings) {
  return "size: " + std::to_string(settings.width) + "x" + std::to_string(settings.height) +
         "\nrays: " + std::to_string(settings.side) +
         "\nphysics: " + (settings.physics == Physics::Full ? "full" : "single") +
         exact_text(settings.exact) +
         "\nview: " + view_text(view_of(camera, settings.width, settings.height, bounds_of(scene))) +
         "\nlights: " + lights_text(scene, effects) + "\nscene: " + meshes_text(scene, effects) +
         "\nnumbers: " + (std::endian::native == std::endian::little ? "little" : "big") + " endian";
}

std::string to_bytes(const TraceState& state, const std::string& request) {
  static_assert(std::is_trivially_copyable_v<Account>);
  std::string bytes;
  bytes.reserve(request.size() + 64 + sizeof(Account) * state.accounts.size() +
                sizeof(double) * (state.sum.size() + state.squares.size()));
  bytes.append(kMagic).append(request).append(kEnd);
  append(bytes, std::vector<std::uint64_t>{state.batches});
  append(bytes, state.accounts);
  append(bytes, state.sum);
  append(bytes, state.squares);
  return bytes;
}

TraceState from_bytes(std::string_view bytes, const std::string& request, const TraceState& like) {
  if (bytes.substr(0, kMagic.size()) != kMagic) refuse("is no state of 'caustics reference'");
  bytes.remove_prefix(kMagic.size());
  const std::size_t end = bytes.find(kEnd);
  if (end == std::string_view::npos) refuse("is damaged; remove it to start anew");
  if (bytes.substr(0, end) != request)
    refuse("is the state of another request: " + difference(bytes.substr(0, end), request) +
           "; remove it to start anew");
  bytes.remove_prefix(end + kEnd.size());
  TraceState state = like;
  std::vector<std::uint64_t> batches(1);
  if (bytes.size() != sizeof(std::uint64_t) + sizeof(Account) * state.accounts.size() +
                          sizeof(double) * (state.sum.size() + state.squares.size()))
    refuse("is damaged; remove it to start anew");
  take(bytes, batches);
  take(bytes, state.accounts);
  take(bytes, state.sum);
  take(bytes, state.squares);
  state.batches = batches.front();
  return state;
}

}  // namespace caustics::tracer
