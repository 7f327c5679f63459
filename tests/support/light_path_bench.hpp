// Parts of the pass walk by themselves (tests/walk): triangles in a hierarchy, and light under way between
// two surfaces.
#pragma once
#include <array>
#include <vector>

#include "passes/walk/walk.hpp"
#include "pipeline/scene/hierarchy_tables.hpp"
#include "pipeline/shader/constants.hpp"
#include "tests/support/run_pass.hpp"

namespace caustics {
extern const Shader walk_enter_shader, walk_bend_shader, walk_land_shader, walk_hit_shader;
}

namespace caustics::test {

// How tests/walk/shaders/path_outputs.glsl marks light that is followed no further.
inline constexpr float kEnded = -1.0f;
inline const std::vector<std::string> kPathOutputs{"path_start", "path_direction", "path_flux", "path_media",
                                                   "path_width", "path_spread",    "booked",    "absorbed"};

inline PassDefinition part_of_walk(const Shader& shader, const std::vector<std::string>& reads,
                                   const std::vector<std::string>& writes) {
  PassDefinition definition{.name = "part", .purpose = "a part of the pass walk", .shader = &shader};
  for (const std::string& name : reads)
    definition.reads.push_back({.name = name, .meaning = name, .optional = true});
  for (const std::string& name : writes)
    definition.writes.push_back({.name = name, .format = Format::RGBA32F, .meaning = name});
  return definition;
}

// Triangles by themselves, three corners each, with flat normals. Corners wind counter-clockwise seen from
// outside.
using Corners = std::array<glm::vec3, 3>;
inline Mesh mesh_of(const std::vector<Corners>& triangles) {
  Mesh mesh;
  for (const Corners& corners : triangles)
    for (const glm::vec3& corner : corners) {
      const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back({.position = corner, .normal = normal});
    }
  return mesh;
}

// A triangle that faces up, with its right angle at (x, height, z) and legs of 4 m along +z and +x: a hit
// with the weights (w1, w2) lies at (x + 4 w2, height, z + 4 w1).
inline Corners level_triangle(float height, float x = 0.0f, float z = 0.0f) {
  return {{{x, height, z}, {x, height, z + 4.0f}, {x + 4.0f, height, z}}};
}

// What light can meet. Triangles are numbered in the order in which meshes are added, casters before
// receivers.
struct HierarchyBench {
  Scene scene{};
  HierarchyMeshes meshes{};
  std::vector<int> rows{};
  float touch = 0.0f;

  // `row`: of its material in caster_materials, which is that of its body too.
  HierarchyBench& caster(Mesh mesh, int row = 0) {
    meshes.casters.push_back(add(std::move(mesh), row, row));
    return *this;
  }
  HierarchyBench& receiver(Mesh mesh, int row = 0) {
    meshes.receivers.push_back(add(std::move(mesh), row, -1));
    return *this;
  }
  // A blended one.
  HierarchyBench& sheet(Mesh mesh, int row = 0) {
    meshes.receivers.push_back(add(std::move(mesh), row, kSheet));
    return *this;
  }
  HierarchyTables tables(int threads = 0) const {
    return hierarchy_tables(scene, meshes, rows, touch, threads);
  }
  int first_receiver() const { return static_cast<int>(caster_triangles(scene, meshes)); }

 private:
  int add(Mesh mesh, int row, int body) {
    scene.meshes.push_back(std::move(mesh));
    rows.push_back(row);
    meshes.bodies.push_back(body);
    return static_cast<int>(scene.meshes.size()) - 1;
  }
};

// A row of caster_materials.
struct BenchMaterial {
  float ior = 1.5f;
  float dispersion = 0.0f;  // n_F - n_C
  bool mirror = false;
  glm::vec3 absorption{0.0f};  // per metre
  glm::vec3 color{1.0f};
  float transmitted = 1.0f;
};

inline Image caster_materials(const std::vector<BenchMaterial>& materials) {
  Image image(Format::RGBA32F, 4, static_cast<int>(materials.size()));
  for (int row = 0; row < image.height(); ++row) {
    const BenchMaterial& material = materials[static_cast<std::size_t>(row)];
    image.at(0, row, 0) = material.ior;
    image.at(0, row, 1) = material.dispersion;
    image.at(0, row, 3) = material.mirror ? 1.0f : 0.0f;
    image.at(3, row, 0) = material.transmitted;
    for (int c = 0; c < 3; ++c) {
      image.at(1, row, c) = material.absorption[c];
      image.at(2, row, c) = material.color[c];
    }
  }
  return image;
}

// Two unit axes across a direction (Duff and others 2017): the textures hold widths and spreads in them.
inline std::array<glm::dvec3, 2> axes_across(const glm::dvec3& d) {
  const double sign = d.z >= 0.0 ? 1.0 : -1.0, a = -1.0 / (sign + d.z), b = d.x * d.y * a;
  return {{{1.0 + sign * d.x * d.x * a, sign * b, -sign * d.x}, {b, sign + d.y * d.y * a, -d.y}}};
}

// The start's triangle of light that starts on none of the hierarchy's, plus 1.
inline constexpr float kOnNoTriangle = 1e6f;

// Light under way. `mark`: path_start's w. Widths and spreads have no part along the direction.
struct BenchPath {
  glm::vec3 start{0.0f};
  float mark = kOnNoTriangle;
  glm::vec3 direction{0.0f, -1.0f, 0.0f};
  float path = 0.0f;
  glm::vec3 flux{1.0f};
  float whole = 1.0f;
  glm::vec4 media{0.0f};
  glm::vec3 width_x{0.0f}, width_y{0.0f};    // metres
  glm::vec3 spread_x{0.0f}, spread_y{0.0f};  // radians

  // As images of one texel, in the order in which the shaders of tests/walk read them.
  std::vector<Image> textures() const {
    const auto across = [&](const glm::vec3& x, const glm::vec3& y) {
      const auto axes = axes_across(direction);
      glm::dvec4 both(glm::dot(glm::dvec3(x), axes[0]), glm::dot(glm::dvec3(x), axes[1]),
                      glm::dot(glm::dvec3(y), axes[0]), glm::dot(glm::dvec3(y), axes[1]));
      return filled(1, 1, glm::vec4(both));
    };
    return {filled(1, 1, {start, mark}), filled(1, 1, {direction, path}), filled(1, 1, {flux, whole}),
            filled(1, 1, media),         across(width_x, width_y),        across(spread_x, spread_y)};
  }
};

inline BenchPath path_at(const PassImages& out, int x = 0, int y = 0) {
  const auto of = [&](const char* name) { return texel(out[name], x, y); };
  const glm::vec4 start = of("path_start"), direction = of("path_direction"), flux = of("path_flux");
  const auto axes = axes_across(glm::dvec3(direction));
  const auto along = [&](float a, float b) {
    return glm::vec3(axes[0] * static_cast<double>(a) + axes[1] * static_cast<double>(b));
  };
  const glm::vec4 width = of("path_width"), spread = of("path_spread");
  return {.start = glm::vec3(start),
          .mark = start.w,
          .direction = glm::vec3(direction),
          .path = direction.w,
          .flux = glm::vec3(flux),
          .whole = flux.w,
          .media = of("path_media"),
          .width_x = along(width.x, width.y),
          .width_y = along(width.z, width.w),
          .spread_x = along(spread.x, spread.y),
          .spread_y = along(spread.z, spread.w)};
}

struct AimedRay {
  glm::vec3 start{0.0f};
  glm::vec3 direction{0.0f, -1.0f, 0.0f};
  float mark = kOnNoTriangle;
  glm::vec4 media{0.0f};
};

// The uniforms of tests/walk/shaders/walk_hit.glsl.
struct alignas(16) SurfaceSearch {
  int most_steps = 0;
  int first_receiver = 0;  // number of the first triangle that is no caster's
  float touch = 0.0f;      // metres: surfaces that are as near touch
};
// Everything is a caster's triangle; the steps are those of light that is bent three times.
inline constexpr SurfaceSearch kAllCasters{
    .most_steps = most_steps(3), .first_receiver = 1 << 24, .touch = 0.0f};

inline PassDefinition hit_definition(const Shader& shader) {
  return part_of_walk(
      shader,
      {"ray_start", "ray_direction", "ray_media", "nodes", "hierarchy_triangles", "hierarchy_normals"},
      {"hit"});
}

// The hit of each ray, as passes/shared/hit_texel.glsl has it.
inline std::vector<glm::vec4> walk(const HierarchyTables& tables, const std::vector<AimedRay>& rays,
                                   const SurfaceSearch& uniforms = kAllCasters) {
  constexpr int kColumns = 256;
  const int rows = (static_cast<int>(rays.size()) + kColumns - 1) / kColumns;
  Image starts(Format::RGBA32F, kColumns, rows), directions(Format::RGBA32F, kColumns, rows),
      media(Format::RGBA32F, kColumns, rows);
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (int c = 0; c < 4; ++c) {
      starts.values[4 * i + static_cast<std::size_t>(c)] = c < 3 ? rays[i].start[c] : rays[i].mark;
      directions.values[4 * i + static_cast<std::size_t>(c)] = c < 3 ? rays[i].direction[c] : 0.0f;
      media.values[4 * i + static_cast<std::size_t>(c)] = rays[i].media[c];
    }
  const PassImages out =
      run_pass(hit_definition(walk_hit_shader),
               {.width = kColumns,
                .height = rows,
                .uniforms = uniform_bytes(uniforms),
                .textures = {starts, directions, media, tables.nodes, tables.triangles, tables.normals}});
  std::vector<glm::vec4> hits;
  for (std::size_t i = 0; i < rays.size(); ++i)
    hits.push_back(texel(out["hit"], static_cast<int>(i) % kColumns, static_cast<int>(i) / kColumns));
  return hits;
}

}  // namespace caustics::test
