#include "raster/prepared_draw.hpp"

#include <algorithm>

#include "raster/lane_dispatch.hpp"

namespace caustics::raster {

namespace {

std::vector<std::uint8_t> flat_components(const ShaderInterface& interface) {
  std::vector<std::uint8_t> flat;
  for (const ShaderVariable& varying : interface.varyings)
    flat.insert(flat.end(), static_cast<std::size_t>(varying.components),
                varying.interpolation == Interpolation::Flat ? 1 : 0);
  return flat;
}

}  // namespace

std::uint64_t PreparedDraw::shade(std::size_t first, std::size_t count, const Workers& workers,
                                  ShadedVertices& out) const {
  if (!indexed) return shade_vertices(vertex_stage, first * corners_each, count * corners_each, workers, out);
  return first == 0 ? shade_vertices(vertex_stage, 0, vertices, workers, out) : 0;
}

PreparedDraw prepare_draw(const PassDefinition& definition, const Draw& draw,
                          std::vector<TextureView> textures, const MeshData* mesh, Lanes lanes,
                          const ShadedVertices& shaded) {
  const ShaderInterface& interface = interface_of(*definition.shader);
  const auto width = static_cast<std::size_t>(lanes);
  PreparedDraw p{.textures = std::move(textures),
                 .flat = flat_components(interface),
                 .vertex_stage = {},
                 .primitive_stage = {},
                 .work = {}};
  p.indexed = mesh && !mesh->indices.empty();
  p.vertices = mesh ? mesh->vertex_count() : static_cast<std::size_t>(std::max(0, draw.vertex_count));
  p.corners_each = definition.topology == Topology::Triangles ? 3 : 1;
  p.corners = p.indexed ? mesh->indices.size() : p.vertices;
  p.primitives = p.corners / p.corners_each;
  p.vertex_stage = {&interface, definition.shader->kernels.vertex[width], draw.uniforms.data(),
                    p.textures.data(), mesh};
  p.primitive_stage = {.topology = definition.topology,
                       .options = {definition.cull, interface.varying_components(), p.flat.data()},
                       .vertices = &shaded,
                       .indices = mesh ? &mesh->indices : nullptr};
  p.work = {.definition = &definition,
            .fragment = definition.shader->kernels.fragment[width],
            .uniforms = draw.uniforms.data(),
            .textures = p.textures.data(),
            .varying_count = interface.varying_components(),
            .varying_flat = p.flat.data(),
            .may_discard = interface.discards,
            .kernel = tile_kernel(lanes)};
  return p;
}

}  // namespace caustics::raster
