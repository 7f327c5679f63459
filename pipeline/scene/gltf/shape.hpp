// One primitive in one place, between the file and caustics::Mesh: world space, double precision.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/scene/exact.hpp"

namespace caustics::gltf {

struct Shape {
  std::string name;  // for people: node and mesh
  std::string path;  // JSON path of the primitive
  int material = 0;
  int object = 0;
  std::vector<glm::dvec3> positions;  // world
  std::vector<glm::dvec3> normals;    // world, not normalised, may hold NaN; empty: none in the file
  std::vector<glm::dvec4> tangents;   // world, w handedness; empty: none
  std::vector<glm::dvec2> uvs;        // as in the file; empty: none
  std::vector<glm::vec4> colors;      // 0..1, linear; empty: none
  std::vector<std::array<std::uint32_t, 3>> triangles;
  float closedness = 0.0f;
  bool inside_out = false;
};

}  // namespace caustics::gltf
