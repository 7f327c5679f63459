// Draws hand-made vertices, in window or clip coordinates, on the software device or another.
#pragma once
#include <memory>
#include <vector>

#include "pipeline/gpu/device.hpp"
#include "raster/software_device.hpp"

namespace caustics {
extern const Shader raster_probe_shader;
extern const Shader raster_two_targets_shader;
extern const Shader raster_discard_shader;
}  // namespace caustics

namespace caustics::test {

struct RasterVertex {
  float x = 0, y = 0, z = 0.5f, w = 1.0f;  // clip coordinates
  float red = 1, green = 1, blue = 1, alpha = 1;
  float size = 1.0f;
};

struct RasterBench {
  int width = 8, height = 8;
  PassDefinition definition{.name = "test",
                            .purpose = "test",
                            .writes = {{.name = "color", .format = Format::R32F, .meaning = "m"}},
                            .shader = &raster_probe_shader};
  SoftwareOptions options{.threads = 1};
  Device* on = nullptr;  // none: a software device with these options
  std::vector<bool> keep{};
  std::vector<bool> absent{};            // colour targets that are not there; empty: all are
  std::vector<std::uint32_t> indices{};  // empty: the vertices in order
  PassResult result{};

  // A vertex at window coordinates (pixels, y up) and window depth.
  RasterVertex at(double x, double y, float value = 1.0f, float z = 0.5f) const {
    RasterVertex v;
    v.x = static_cast<float>(2.0 * x / width - 1.0);
    v.y = static_cast<float>(2.0 * y / height - 1.0);
    v.z = z;
    v.red = v.green = v.blue = v.alpha = value;
    return v;
  }

  // All colour targets after one draw of these vertices; `before` fills the first target
  // beforehand.
  std::vector<Image> draw(const std::vector<RasterVertex>& vertices, const Image* before = nullptr) {
    return draw_each({vertices}, before);
  }

  // After a draw of each.
  std::vector<Image> draw_each(const std::vector<std::vector<RasterVertex>>& draws,
                               const Image* before = nullptr) {
    const std::unique_ptr<Device> own = on ? nullptr : make_software_device(options);
    Device* const device = on ? on : own.get();
    PassRun run;
    run.definition = &definition;
    for (const ColorWrite& write : definition.writes) {
      const std::size_t i = run.colors.size();
      run.colors.push_back(!absent.empty() && absent[i] ? TextureId::None
                           : before && i == 0           ? device->upload(*before)
                                              : device->create_texture(write.format, width, height));
    }
    if (definition.depth) run.depth = device->create_texture(Format::Depth32F, width, height);
    run.keep = keep;
    for (const std::vector<RasterVertex>& vertices : draws) {
      Draw draw;
      draw.mesh = device->create_mesh(mesh_of(vertices));
      run.draws.push_back(draw);
    }
    result = device->run(run);
    std::vector<Image> images;
    std::erase(run.colors, TextureId::None);
    for (const TextureId color : run.colors) images.push_back(device->read_back(color));
    if (run.depth != TextureId::None) images.push_back(device->read_back(run.depth));
    for (const TextureId color : run.colors) device->destroy(color);
    if (run.depth != TextureId::None) device->destroy(run.depth);
    for (const Draw& draw : run.draws) device->destroy(draw.mesh);
    return images;
  }

  MeshData mesh_of(const std::vector<RasterVertex>& vertices) const {
    MeshData mesh;
    mesh.layout = {{"position", 4}, {"color", 4}, {"size", 1}};
    for (const RasterVertex& v : vertices)
      for (const float f : {v.x, v.y, v.z, v.w, v.red, v.green, v.blue, v.alpha, v.size})
        mesh.vertices.push_back(f);
    mesh.indices = indices;
    return mesh;
  }

  // The sum of the first target's first channel, and how many texels are not 0.
  static double sum(const Image& image) {
    double total = 0.0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) total += static_cast<double>(image.at(x, y, 0));
    return total;
  }
};

// A bench that adds up how often each texel is covered.
inline RasterBench counting(int width = 8, int height = 8) {
  RasterBench bench;
  bench.width = width;
  bench.height = height;
  bench.definition.writes[0].blend = kAccumulate;
  return bench;
}

}  // namespace caustics::test
