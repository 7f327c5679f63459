// What pass tests draw, and on what.
#pragma once
#include "pipeline/renderer/run_pass.hpp"
#include "raster/software_device.hpp"

namespace caustics::test {

// On the software device.
inline PassImages run_pass(const PassDefinition& definition, const PassInputs& inputs) {
  return caustics::run_pass(*make_software_device({.threads = 1}), definition, inputs);
}

// A mesh with the attributes of SceneOnDevice: two triangles spanning four corners in order.
inline MeshData quad(const glm::vec3 (&corners)[4], const glm::vec3& normal) {
  MeshData data;
  data.layout = {{"position", 3}, {"normal", 3}, {"tangent", 4}, {"uv", 2}, {"uv_density", 2}};
  const float uv[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const float along_u = 1.0f / glm::distance(corners[0], corners[1]);
  const float along_v = 1.0f / glm::distance(corners[0], corners[3]);
  for (int i = 0; i < 4; ++i) {
    const float vertex[14] = {corners[i].x, corners[i].y, corners[i].z, normal.x, normal.y,
                              normal.z,     1.0f,         0.0f,         0.0f,     1.0f,
                              uv[i][0],     uv[i][1],     along_u,      along_v};
    data.vertices.insert(data.vertices.end(), vertex, vertex + 14);
  }
  data.indices = {0, 1, 2, 0, 2, 3};
  return data;
}

// A level square of +-half metres that faces up, moved along x.
inline MeshData level(float height, float half = 4.0f, float x = 0.0f) {
  return quad({{x - half, height, half},
               {x + half, height, half},
               {x + half, height, -half},
               {x - half, height, -half}},
              {0.0f, 1.0f, 0.0f});
}

// Two meshes of one layout as one, drawn in this order.
inline MeshData both(MeshData first, const MeshData& second) {
  const auto offset = static_cast<std::uint32_t>(first.vertices.size() / 14);
  first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const std::uint32_t i : second.indices) first.indices.push_back(offset + i);
  return first;
}

// A square view that looks straight down from `height` metres on a window of +-half metres.
inline View down(double half, double height, double far) {
  View view = view_along({0.0, height, 0.0}, {0.0, -1.0, 0.0});
  view.window_lower = glm::dvec2(-half);
  view.window_upper = glm::dvec2(half);
  view.near = 0.0;
  view.far = far;
  return view;
}

// An image whose every texel holds the same four values.
inline Image filled(int width, int height, const glm::vec4& value) {
  Image image(Format::RGBA32F, width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 4; ++c) image.at(x, y, c) = value[c];
  return image;
}

inline glm::vec4 texel(const Image& image, int x, int y) {
  glm::vec4 value{0.0f};
  for (int c = 0; c < image.channels(); ++c) value[c] = image.at(x, y, c);
  return value;
}

// Of all texels.
inline double sum(const Image& image, int channel = 0) {
  double total = 0.0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) total += double(image.at(x, y, channel));
  return total;
}

}  // namespace caustics::test
