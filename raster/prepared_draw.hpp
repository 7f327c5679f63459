// A draw with everything that its stages refer to: what the device executes, and what is replayed texel by
// texel (texel_replay.hpp).
#pragma once
#include <vector>

#include "raster/primitives.hpp"
#include "raster/target.hpp"
#include "raster/vertex_stage.hpp"

namespace caustics::raster {

struct PreparedDraw {
  std::vector<TextureView> textures;
  std::vector<std::uint8_t> flat;  // by varying component
  VertexStage vertex_stage;
  PrimitiveStage primitive_stage;
  FragmentWork work;
  bool indexed = false;
  std::size_t vertices = 0;  // of the mesh, or without one
  std::size_t corners = 0, corners_each = 0, primitives = 0;

  // Shades the vertices that these primitives need: all at once where an index may be of any. Returns what
  // the shader's operations were counted to.
  std::uint64_t shade(std::size_t first, std::size_t count, const Workers& workers,
                      ShadedVertices& out) const;
};

// `textures`: as `draw` binds them. `mesh`: null where it has none. `shaded`: where its vertices will be.
// All must outlive it.
PreparedDraw prepare_draw(const PassDefinition& definition, const Draw& draw,
                          std::vector<TextureView> textures, const MeshData* mesh, Lanes lanes,
                          const ShadedVertices& shaded);

}  // namespace caustics::raster
