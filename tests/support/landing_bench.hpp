// The pass `landing` by itself: a light straight down, a caster, a receiver map, and where the light comes
// down.
#pragma once
#include <cmath>
#include <optional>

#include "passes/landing/landing.hpp"
#include "pipeline/measure/ledger.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "tests/support/cube_map.hpp"
#include "tests/support/run_pass.hpp"

namespace caustics::test {

struct LandingTextures {
  Image position, normal;  // of the caster map
  Image exit_position{}, exit_normal{};
  Image receiver, materials;
  Image tint{}, impostor{}, caster_flux{};
};

inline PassImages run_landing(const std140::Landing& uniforms, const LandingTextures& t) {
  return run_pass(definition_of(landing_pass()),
                  {.width = t.position.width(),
                   .height = t.position.height(),
                   .uniforms = uniform_bytes(uniforms),
                   .textures = {t.position, t.normal, t.exit_position, t.exit_normal, t.receiver, t.materials,
                                t.tint, t.impostor, Image{}, t.caster_flux}});
}

// Of a light straight down whose maps all have one view; whatever is not named is off.
inline std140::Landing bench_uniforms(const View& view, const View& impostors, int estimator,
                                      int iterations) {
  std140::Landing u{};
  u.caster = u.receiver = u.caustic = shader_view(view);
  u.cone.axis = u.light = {0.0f, -1.0f, 0.0f};
  u.cell_area = 0.25f;
  u.channel_share = {1.0f, 1.0f, 1.0f};
  u.exit_tolerance = u.landing_tolerance = 2.0f;
  u.impostor_centre = impostors.origin;
  u.impostor = shader_view(impostors);
  u.estimator = estimator;
  u.iterations = iterations;
  u.newton_guard = 1;
  return u;
}

// A light straight down from 10 m, casters around height 1, a floor at height 0. The caster map is one
// grid vertex at (0, 1, 0) repeated, so every texel of a 2 x 2 grid tells the same.
struct LandingBench {
  View view = down(4.0, 10.0, 20.0);
  glm::vec3 normal{0.0f, 1.0f, 0.0f};
  float facing = 1.0f;
  float ior = 1.5f;
  bool mirror = false;
  glm::vec3 color{1.0f};  // what glass lets through; of a mirror, its reflectance at normal incidence
  glm::vec3 absorption{0.0f};
  float dispersion = 0.0f;  // n_F - n_C
  glm::vec3 channel_share{1.0f};
  float bend = 0.0f;
  bool reflected = false;
  std::optional<glm::vec3> tint;  // the grid vertices' own colour, in place of `color`
  float transmitted = 1.0f;
  bool wyman = false;
  bool solid = false;
  bool thin = false;      // a rough wall
  bool exit_seen = true;  // by the exit map
  float exit_height = 0.5f;
  glm::vec3 exit_normal{0.0f, -1.0f, 0.0f};
  std::optional<glm::vec3> exit_normal_left;  // of the exit surface's half at x < 0, if it is another
  glm::vec3 receivers_lower{-100.0f, 0.0f, -100.0f}, receivers_upper{100.0f, 0.0f, 100.0f};
  int iterations = 5;
  int estimator = ESTIMATOR_SECANT;
  bool paper_weights = false;
  glm::vec2 caster_flux{4.0f, 4.0f};  // flux on all grid vertices in cells, and how many they are
  float search_start = 0.0f;
  float newton_epsilon = 0.0f;
  bool newton_guard = true;
  bool draws_unconverged = false;
  Image receiver = floor_map(64, 0.0, 0.0);
  View impostors = with_atlas(cube_view({0.0, 2.0, 0.0}, {1.0, 20.0}), 300);
  Image impostor;  // positions around impostors.origin

  // Positions of the plane y = height + slope * x over the view, as receiver_map writes them.
  Image floor_map(int size, double height, double slope) const {
    Image image(Format::RGBA32F, size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double px = -4.0 + 8.0 * (x + 0.5) / size;
        image.at(x, y, 0) = static_cast<float>(px);
        image.at(x, y, 1) = static_cast<float>(height + slope * px);
        image.at(x, y, 2) = static_cast<float>(4.0 - 8.0 * (y + 0.5) / size);
        image.at(x, y, 3) = 1.0f;
      }
    return image;
  }

  // The row of caster_materials.
  Image materials() const {
    Image image(Format::RGBA32F, 4, 1);
    for (int c = 0; c < 3; ++c) {
      image.at(1, 0, c) = absorption[c];
      image.at(2, 0, c) = color[c];
    }
    image.at(0, 0, 0) = ior;
    image.at(0, 0, 1) = dispersion;
    image.at(0, 0, 3) = mirror ? 1.0f : thin ? -1.0f : 0.0f;
    image.at(1, 0, 3) = solid ? 1.0f : 0.0f;
    image.at(3, 0, 0) = transmitted;
    return image;
  }

  // As exit_height's map has positions.
  Image exit_normals() const {
    Image image = filled(64, 64, glm::vec4(exit_normal, 1.0f));
    if (!exit_normal_left) return image;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 32; ++x)
        for (int c = 0; c < 3; ++c) image.at(x, y, c) = (*exit_normal_left)[c];
    return image;
  }

  PassImages run() const {
    std140::Landing u = bench_uniforms(view, impostors, estimator, iterations);
    u.channel_share = channel_share;
    u.bend = bend;
    u.grid_side = 2;
    u.has_walls = thin;
    u.receivers_lower = receivers_lower;
    u.receivers_upper = receivers_upper;
    u.paper_weights = paper_weights;
    u.search_start = search_start;
    u.newton_epsilon = newton_epsilon;
    u.newton_guard = newton_guard;
    u.draws_unconverged = draws_unconverged;
    u.is_reflection = reflected;
    u.has_mirrors = mirror;
    u.has_exit_maps = solid;
    u.wyman_thickness = wyman;
    u.has_caster_tint = tint.has_value();
    return run_landing(u, {.position = filled(2, 2, {0.0f, 1.0f, 0.0f, facing}),
                           .normal = filled(2, 2, glm::vec4(normal, 0.0f)),
                           .exit_position = exit_seen ? floor_map(64, static_cast<double>(exit_height), 0.0)
                                                      : Image(Format::RGBA32F, 64, 64),
                           .exit_normal = exit_normals(),
                           .receiver = receiver,
                           .materials = materials(),
                           .tint = tint ? filled(2, 2, glm::vec4(*tint, 1.0f)) : Image{},
                           .impostor = impostor,
                           .caster_flux = filled(1, 1, {caster_flux.x, caster_flux.y, 0.0f, 0.0f})});
  }
};

inline LandingStatus landing_status(const PassImages& out, int x = 0, int y = 0) {
  return static_cast<LandingStatus>(static_cast<int>(out["landing"].at(x, y, 3)));
}

// The unit normal tilted by `degrees` from up towards +x.
inline glm::vec3 tilted(double degrees) {
  const double a = degrees * 3.14159265358979323846 / 180.0;
  return {static_cast<float>(std::sin(a)), static_cast<float>(std::cos(a)), 0.0f};
}

}  // namespace caustics::test
