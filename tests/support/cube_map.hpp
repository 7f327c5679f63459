// Maps of a cube view made by hand.
#pragma once
#include <functional>

#include "pipeline/gpu/image.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics::test {

// The direction in view axes that a texel of an atlas sees, with 1 along its face's axis.
inline glm::dvec3 direction_of(const CubeAtlas& atlas, int face, int x, int y) {
  const double tx = (2.0 * (x - atlas.guard) + 1.0) / atlas.face_width() - 1.0;
  const double ty = (2.0 * (y - atlas.guard) + 1.0) / atlas.face_height() - 1.0;
  const glm::dvec3 t{tx, ty, 1.0};
  // The turn's inverse is its transpose.
  glm::dvec3 q;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 unit{0.0};
    unit[axis] = 1.0;
    q[axis] = glm::dot(turned_to_face(unit, face), t);
  }
  return q;
}

// Positions as a pass draws them: `distance` along each direction (in units of it), 0 where there is nothing.
inline Image positions_around(const View& view, const std::function<double(const glm::dvec3&)>& distance) {
  const CubeAtlas& atlas = *view.cube;
  Image image(Format::RGBA32F, atlas.side, atlas.side);
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < atlas.tile_height(); ++y)
      for (int x = 0; x < atlas.tile_width(); ++x) {
        const glm::dvec3 q = direction_of(atlas, face, x, y);
        const glm::dvec3 d = view.right * q.x + view.up * q.y + view.forward * q.z;
        const double t = distance(d);
        if (!(t > 0.0)) continue;
        const glm::dvec3 p = view.origin + d * t;
        const int column = face % 3 * atlas.tile_width() + x, row = face / 3 * atlas.tile_height() + y;
        for (int c = 0; c < 3; ++c) image.at(column, row, c) = static_cast<float>(p[c]);
        image.at(column, row, 3) = static_cast<float>(t * glm::length(d));
      }
  return image;
}

}  // namespace caustics::test
