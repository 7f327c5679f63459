// Runs one pass by itself on small textures, for pass tests.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/gpu/device.hpp"
#include "pipeline/plan/pass.hpp"
#include "raster/software_device.hpp"

namespace caustics::test {

// What a pass wrote, by attachment name.
struct PassImages {
  std::map<std::string, Image> images;
  PassResult result;
  const Image& operator[](const std::string& name) const { return images.at(name); }
};

struct PassInputs {
  int width = 1, height = 1;
  UniformBytes uniforms{};
  std::vector<Image> textures{};  // in the order of the definition's reads; empty images are unbound
  MeshData mesh{};                // empty: `vertex_count` vertices without attributes
  int vertex_count = 3;
};

// What a frame with this effect makes of a pass.
inline PassDefinition definition_with(const Pass& pass, Effect Effects::*effect,
                                      const DrawnFor& drawn_for = kFrame) {
  Effects effects;
  (effects.*effect).active = true;
  return definition_of(pass, effects, drawn_for);
}

inline PassImages run_pass(const PassDefinition& definition, const PassInputs& inputs) {
  const std::unique_ptr<Device> device = make_software_device({.threads = 1});
  PassRun run{.definition = &definition};
  for (const ColorWrite& write : definition.writes)
    run.colors.push_back(device->create_texture(write.format, inputs.width, inputs.height));
  if (definition.depth) run.depth = device->create_texture(Format::Depth32F, inputs.width, inputs.height);
  Draw draw{.vertex_count = inputs.vertex_count, .uniforms = inputs.uniforms};
  if (!inputs.mesh.vertices.empty()) {
    draw.mesh = device->create_mesh(inputs.mesh);
    draw.vertex_count = 0;
  }
  for (const Image& image : inputs.textures)
    draw.textures.push_back(image.values.empty() ? TextureId::None : device->upload(image));
  run.draws.push_back(draw);
  PassImages out;
  out.result = device->run(run);
  for (std::size_t i = 0; i < run.colors.size(); ++i)
    out.images[definition.writes[i].name] = device->read_back(run.colors[i]);
  if (definition.depth) out.images[definition.depth->name] = device->read_back(run.depth);
  return out;
}

// A mesh with the attributes of SceneOnDevice: two triangles spanning four corners in order.
inline MeshData quad(const glm::vec3 (&corners)[4], const glm::vec3& normal) {
  MeshData data;
  data.layout = {{"position", 3}, {"normal", 3}, {"tangent", 4}, {"uv", 2}};
  const float uv[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) {
    const float vertex[12] = {corners[i].x, corners[i].y, corners[i].z, normal.x, normal.y, normal.z,
                              1.0f,         0.0f,         0.0f,         1.0f,     uv[i][0], uv[i][1]};
    data.vertices.insert(data.vertices.end(), vertex, vertex + 12);
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
  const auto offset = static_cast<std::uint32_t>(first.vertices.size() / 12);
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
