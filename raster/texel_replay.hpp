// Draws texels of a pass again, one fragment at a time (texel_history.hpp).
#pragma once
#include <memory>

#include "raster/prepared_draw.hpp"
#include "raster/texel_history.hpp"

namespace caustics::raster {

class TexelReplay {
 public:
  // `size`: of the targets. `definition` and `workers` must outlive it.
  TexelReplay(const PassDefinition& definition, const TargetsBefore& before, const ImageShape& size,
              const TexelRectangle& where, const Workers& workers);
  TexelReplay(const TexelReplay&) = delete;
  TexelReplay& operator=(const TexelReplay&) = delete;
  ~TexelReplay();

  // The run's next draw. `shaded`: where its primitives look for their vertices.
  void draw(std::size_t number, const PreparedDraw& prepared, ShadedVertices& shaded,
            const FragmentVisitor& visit);

 private:
  TexelRectangle part_in(int tile) const;

  class Texels;
  std::unique_ptr<Texels> texels_;  // of the rectangle, as they are so far
  TexelRectangle where_;
  TileGrid grid_;
  const Workers& workers_;
};

}  // namespace caustics::raster
