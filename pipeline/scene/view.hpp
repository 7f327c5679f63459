// A view: from where and through which window something is seen. Cameras and lights use the same
// kind, so one shader text can draw from either.
//
// View coordinates of a scene-space point p: x = right.(p - origin), y = up.(p - origin),
// z = forward.(p - origin), metres. z is the distance along the way the light travels or the camera
// looks. Window coordinates are x, y (parallel views) or x/z, y/z (perspective views); map
// coordinates u, v run from 0 to 1 across the window, v upwards.
//
// A cube view sees all around: six perspective faces along its axes, each 90 degrees wide, whose tiles lie
// side by side in the map (cube_atlas.hpp). It has no window of its own.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "pipeline/scene/cube_atlas.hpp"
#include "pipeline/scene/scene.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics {

// A perspective view sees at most this far to the side: tan 71.6 degrees. The texels of a map as wide are as
// large as those of a cube's tiles, so that wider views are better cubes.
inline constexpr double kWidestTangent = 3.0;

struct View {
  glm::dvec3 origin{0.0};                                                       // scene space
  glm::dvec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};  // orthonormal
  bool perspective = false;
  // Metres across the light, or tangents of angles in a perspective view.
  glm::dvec2 window_lower{-1.0}, window_upper{1.0};
  double near = 0.0, far = 1.0;   // range of z; near > 0 in a perspective view; of a cube, of each face's z
  std::optional<CubeAtlas> cube;  // a cube view, and then `perspective` too
  int face = 4;                   // of a cube: the face that is drawn

  glm::dvec3 coordinates(const glm::dvec3& p) const;
  // (x, y) or (x/z, y/z); z must be positive in a perspective view. Not for cubes.
  glm::dvec2 window(const glm::dvec3& coordinates) const;
  // Area of the window: square metres, or tangent units squared. Of a cube: that of all its map's texels,
  // used or not, so that the map's size divides it into the area of a texel.
  double window_area() const;
};

// What shaders get of a view (pipeline/shader/view.glsl; passes/shared/view_space.glsl uses it).
std140::View shader_view(const View& view);

// A right-handed view that looks along `forward`, with an `up` chosen without any branch cut near
// the usual directions: the coordinate axis least aligned with `forward`, made orthogonal.
View view_along(const glm::dvec3& origin, const glm::dvec3& forward);

// The camera's view for a picture of this size; a perspective camera keeps its vertical angle, an
// orthographic one keeps its smaller extent. Far is drawn in to just behind `bounds`.
View view_of(const Camera& camera, int width, int height, const Bounds& bounds);

}  // namespace caustics
