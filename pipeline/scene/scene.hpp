// A scene as the passes need it: triangles in one common space, materials, lights, cameras.
//
// Scene space: metres, right-handed, axes as in the glTF world, origin moved to `Scene::origin` (the
// centre of the geometry's bounds) so that single precision resolves detail wherever the world lies.
// Photometric units as in glTF: lux, candela, nit (candela per square metre). Colours are linear.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/gpu/image.hpp"
#include "pipeline/scene/stated_shape.hpp"
#include "pipeline/scene/water.hpp"

namespace caustics {

// What a sampler makes of coordinates beyond the picture, along an axis.
enum class Wrap : std::uint8_t { Repeat, Clamp, Mirror };

// A texture as a material uses it. Values are linear (sRGB images are decoded on loading), row 0 is
// the bottom row; glTF's v axis is flipped on loading so that (0, 0) is the bottom left corner.
struct TextureUse {
  int image = -1;  // index into Scene::images, -1: none
  // uv' = rows * (u, v, 1): KHR_texture_transform and the flip of v.
  glm::mat3 uv_transform{1.0f};
  Wrap wrap_u = Wrap::Repeat, wrap_v = Wrap::Repeat;
  // Where a texel is wider than what a sample sees it is shown as it is, not interpolated.
  bool nearest = false;
  int levels = 1;  // of its mip map; the second and on are in Scene::coarser
  bool present() const { return image >= 0; }
};

enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };
// A blended surface is opaque where it covers at least this: a texel of 8 bits all, interpolated or not.
inline constexpr float kCoversAll = 254.5f / 255.0f;

// Where the camera's picture of a surface gives way to what lies behind all surfaces: with the distance from
// a point, metres, from all of the surface to none of it.
struct Fade {
  glm::vec3 centre{0.0f};  // scene space
  float from = 0.0f, to = 0.0f;
  bool present() const { return to > from; }
};

// glTF 2.0 metallic-roughness with the KHR extensions that matter to light. Ranges are enforced by the
// loader; the defaults are those of the specifications.
struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};
  TextureUse base_color_texture;
  // Of base_color_texture's opacity; without one 1.
  float least_alpha = 1.0f, most_alpha = 1.0f;
  TextureUse normal_texture;
  float normal_scale = 1.0f;
  AlphaMode alpha_mode = AlphaMode::Opaque;
  float alpha_cutoff = 0.5f;
  glm::vec3 emissive{0.0f};  // nit: emissiveFactor * KHR_materials_emissive_strength
  TextureUse emissive_texture;
  float metallic = 1.0f;   // the mean over metallicRoughnessTexture where there is one
  float roughness = 1.0f;  // likewise
  // Where it is present, texel by texel: g times the one factor, b times the other.
  TextureUse metallic_roughness_texture;
  float roughness_factor = 1.0f, metallic_factor = 1.0f;
  TextureUse occlusion_texture;     // r: the share of the environment's light that arrives
  float occlusion_strength = 1.0f;  // 0: none of it is kept away
  bool double_sided = false;
  bool unlit = false;
  float transmission = 0.0f;        // KHR_materials_transmission: 0..1; mean over its texture
  TextureUse transmission_texture;  // r: 0..1, times
  float transmission_factor = 0.0f;
  float ior = 1.5f;        // KHR_materials_ior: 0 (never refracts), else > 0
  float thickness = 0.0f;  // KHR_materials_volume: > 0 means a solid
  glm::vec3 attenuation_color{1.0f};
  float attenuation_distance = std::numeric_limits<float>::infinity();  // metres
  float dispersion = 0.0f;  // KHR_materials_dispersion: 20 / Abbe number
  // KHR_materials_specular: of what Fresnel's equations mirror, 0..1; and of a diffuse surface's reflectance
  // at normal incidence, by channel.
  float fresnel_factor = 1.0f;
  glm::vec3 specular_color{1.0f};
  Fade fade;  // of an added ground
};

struct Vertex {
  glm::vec3 position{0.0f};                   // scene space
  glm::vec3 normal{0.0f};                     // unit, scene space, outward; never zero
  glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};  // xyz unit, w handedness; for normal textures only
  glm::vec2 uv{0.0f};
};

// One glTF primitive in one place of the node tree, in scene space. Triangles wind counter-clockwise
// seen from outside, mirrored node transforms included.
struct Mesh {
  std::string name;  // node / mesh names, for messages
  std::vector<Vertex> vertices;
  std::vector<glm::vec4> colors;       // of the vertices, 0..1, linear: times the base colour; empty: none
  std::vector<std::uint32_t> indices;  // three a triangle
  int material = 0;                    // index into Scene::materials
  int object = 0;                      // primitives of one node share an object
  // 1 less the area of the surface's holes over its own area, judged for all primitives of the object
  // with this material together, after welding (positions within 1e-6 of the extent); 1 is closed.
  float closedness = 0.0f;
  bool closed() const { return closedness >= 0.9f; }
  bool inside_out = false;             // closed, and its triangles wind as seen from within
  glm::vec3 lower{0.0f}, upper{0.0f};  // bounds
  // Of what moves, where it was set: points that it comes to, among them the farthest to many sides.
  std::vector<glm::vec3> outline;
  bool has_uv = false;
};

enum class LightType : std::uint8_t { Directional, Point, Spot };

// What an area light's samples are spread over (docs/lights.md).
enum class LightShape : std::uint8_t {
  None,       // a point, or one direction
  Sphere,     // of a point or spot light: `radius`
  Rectangle,  // of a point or spot light: `width` and `height`
  Disk,       // of a directional light, as the sun's: `angular_radius`
  Mesh,       // the mesh `emitter`, on both sides where it is an open, double-sided sheet
};

// KHR_lights_punctual. Directional intensity in lux, point and spot in candela; times `color`.
struct Light {
  std::string name;
  LightType type = LightType::Directional;
  glm::vec3 color{1.0f};
  float intensity = 1.0f;
  glm::dvec3 position{0.0};                              // scene space
  glm::dvec3 direction{0.0, 0.0, -1.0};                  // unit, the way the light travels
  float range = std::numeric_limits<float>::infinity();  // metres
  float inner_cone = 0.0f;                               // radians
  float outer_cone = 0.785398163f;
  // Of a point light: shines on the side of `direction` only, with the cosine to it (Lambert).
  bool lambertian = false;
  LightShape shape = LightShape::None;
  // Of a sphere, metres; of a rectangle its edges, scene space. A mesh has those of the one that it is, or 0.
  double radius = 0.0;
  glm::dvec3 width{0.0}, height{0.0};
  double angular_radius = 0.0;  // radians
  int emitter = -1;             // index into Scene::meshes of what shines: it does not shadow its own light
  int samples = 0;  // of an area light: by how many it is drawn; 0: as Settings::light_samples has it
  // Metres. Of a Lambertian sample: of the disk of its share of the area; near it the light falls off as a
  // disk's on its axis does, I / (d^2 + r^2). Of other samples: nearer than this they get no brighter.
  double sample_radius = 0.0;
  int source = -1;  // index into Scene::sources, once sample_lights has run

  bool is_ball() const { return shape == LightShape::Sphere || (shape == LightShape::Mesh && radius > 0.0); }
  bool is_rectangle() const {
    return shape == LightShape::Rectangle || (shape == LightShape::Mesh && width != glm::dvec3(0.0));
  }
  // A mesh that shines and is neither: known by points of it.
  bool is_lamp() const { return shape == LightShape::Mesh && !is_ball() && !is_rectangle(); }
};

// Its intensity in the brightest of its channels, lux or candela.
double brightness(const Light& light);

// A mesh that shines, but does not light the scene.
struct DimMesh {
  int mesh = -1;    // index into Scene::meshes
  std::string why;  // "it adds less than ..."
};

struct Camera {
  std::string name;
  bool orthographic = false;
  glm::dvec3 position{0.0};                                                     // scene space
  glm::dvec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};  // orthonormal
  double vertical_fov = 0.7;                                                    // radians, perspective
  double half_width = 1.0, half_height = 1.0;  // metres, orthographic (xmag, ymag)
  double near = 0.01;
  double far = std::numeric_limits<double>::infinity();
};

// A rectangle of light infinitely far away, dimmer towards its edges.
struct SoftBox {
  glm::dvec3 middle{0.0, 1.0, 0.0}, across{1.0, 0.0, 0.0}, upward{0.0, 0.0, 1.0};  // orthonormal
  double half_width = 1.0, half_height = 1.0;  // tangents of the angles from the middle
  float radiance = 0.0f;                       // nit, of all channels
};

// The light from everywhere else: an equirectangular image, or a neutral gradient of the sky with soft boxes.
struct Environment {
  std::optional<Image> image;  // RGBA32F, linear, nit; the horizontal centre looks along -z, but for `turn`
  std::array<glm::vec3, 9> ambient{};  // of the image: environment_irradiance (environment.hpp)
  glm::dvec2 turn{1.0, 0.0};  // about the vertical, anticlockwise as seen from above: cosine and sine
  glm::vec3 zenith{0.0f}, horizon{0.0f}, ground{0.0f};  // nit, without an image
  std::array<SoftBox, 3> boxes{};  // not seen directly; a surface that faces up gets boxes_mean pi of them
  float boxes_mean = 0.0f;
  // Metres: as far a surface keeps some of it from another. 0: none does.
  float reach = 0.0f;
  std::optional<glm::vec3> backdrop;  // nit: what is seen directly below the horizon, instead of `ground`
};

// Haze in the air: homogeneous, outside of glass, in the box that medium_bounds gives (docs/medium.md).
struct Medium {
  glm::vec3 scattering{0.0f};  // per metre and channel, 0..1000
  glm::vec3 absorption{0.0f};  // likewise
  // Mean cosine of the angle by which scattering turns light (Henyey and Greenstein 1941), -0.99..0.99.
  float anisotropy = 0.0f;
  glm::vec3 extinction() const { return scattering + absorption; }
  bool scatters() const { return scattering.x > 0.0f || scattering.y > 0.0f || scattering.z > 0.0f; }
  bool present() const {
    return scatters() || absorption.x > 0.0f || absorption.y > 0.0f || absorption.z > 0.0f;
  }
};

struct Scene {
  std::string file;
  glm::dvec3 origin{0.0};  // glTF world coordinates of scene space's origin
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Image> images;   // RGBA32F for normals and transmission, else RGBA16F
  std::vector<Image> coarser;  // by image: its mip levels but for the first (mip_levels.hpp), if it has any
  // What is drawn, each with maps of its own: as a person knows them until sample_lights puts an area
  // light's samples in its place, and then keeps the lights as a person knows them in `sources`.
  std::vector<Light> lights;
  std::vector<Light> sources;
  std::vector<DimMesh> dim_meshes;  // as choose_lamps (lamp_meshes.hpp) has judged them
  std::vector<Camera> cameras;
  Environment environment;
  std::vector<Water> waters;  // meshes that waves run over, as they stand at the moment shown
  std::vector<StatedShape>
      stated_shapes;  // of which meshes the file says what they stand for; nothing is drawn by it
  Medium medium;
  // What the loader assumed or left out, one sentence each, in the order found; for people.
  std::vector<std::string> notes;
};

// The light as a person knows it of which lights[light] is a sample, or itself.
const Light& source_of(const Scene& scene, int light);

// Bounds of all meshes; an empty scene gives lower > upper.
struct Bounds {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};
  bool empty() const { return lower.x > upper.x; }
  void add(const glm::dvec3& p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  void add(const Bounds& other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
  glm::dvec3 centre() const { return 0.5 * (lower + upper); }
  double radius() const { return 0.5 * glm::length(upper - lower); }
};
Bounds bounds_of(const Mesh& mesh);
Bounds bounds_of(const Scene& scene);
// Where the medium is: the box around all meshes, cameras and lights that have a place.
Bounds medium_bounds(const Scene& scene);

}  // namespace caustics
