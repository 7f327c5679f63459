// The six faces of a cube around a point, side by side in one square texture: tiles of 3 columns and 2 rows.
// passes/shared/cube_atlas.glsl has the same rules for shaders, and says which face looks where.
//
// Each tile is `guard` texels wider than its face on every side. What is fetched or added near a face's edge
// therefore stays in its tile.
#pragma once
#include <glm/glm.hpp>

namespace caustics {

// Texels of one atlas. Its texels beyond 3 * tile_width and 2 * tile_height are not used.
struct CubeAtlas {
  int side = 0;   // of the texture
  int guard = 0;  // 2 * guard must be less than tile_width
  // Tiles as high as wide; the upper third of the texture is then not used. Of a grid of vertices: its cells
  // meet over an edge of the cube only where both faces have the same spacing, and no way to lay six oblong
  // tiles around a cube has that at every edge.
  bool square = false;

  int tile_width() const { return side / 3; }
  int tile_height() const { return square ? side / 3 : side / 2; }
  // Texels of a face, without the guard: 2 tangent units.
  int face_width() const { return tile_width() - 2 * guard; }
  int face_height() const { return tile_height() - 2 * guard; }
  // Where tangents of a face's frame (x/z, y/z) lie in the atlas, in texels from its lower left; past the
  // face's edge in its guard and beyond.
  glm::dvec2 texel(const glm::dvec2& tangents, int face) const {
    const glm::dvec2 corner(face % 3 * tile_width() + guard, face / 3 * tile_height() + guard);
    return corner + 0.5 * (tangents + 1.0) * glm::dvec2(face_width(), face_height());
  }
  // Does the texel lie in a face, and as many texels from its edges?
  bool in_face(int x, int y, int from_edge = 0) const {
    if (x >= 3 * tile_width() || y >= 2 * tile_height()) return false;
    const int column = x % tile_width(), row = y % tile_height(), least = guard + from_edge;
    return column >= least && row >= least && column < tile_width() - least && row < tile_height() - least;
  }
  // Area of a texel in tangent units squared.
  double texel_area() const {
    return 4.0 / (static_cast<double>(face_width()) * static_cast<double>(face_height()));
  }
};

// The smallest texture that holds an atlas with room for its guard.
inline constexpr int kLeastAtlas = 48;
// Bilinear fetches and the cells' neighbours need this much.
inline constexpr int kLeastGuard = 3;

// Right-handed turns of view coordinates that make a face's axis the z axis.
glm::dvec3 turned_to_face(const glm::dvec3& q, int face);
glm::dvec3 turned_from_face(const glm::dvec3& q, int face);
// The face that q lies in: that of the largest component; of equal ones z wins over x, x over y.
int face_of(const glm::dvec3& q);

}  // namespace caustics
