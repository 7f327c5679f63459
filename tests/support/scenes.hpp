// Whole scenes in memory, shared by the end-to-end tests.
#pragma once
#include "pipeline/settings/settings.hpp"
#include "tests/support/shapes.hpp"

namespace caustics::test {

// A sphere of radius 0.5 m, its centre 0.8 m above a floor of albedo 0.8, under a vertical light of 1
// lux, seen by an orthographic camera 0.2 m above the floor over 2 x 2 m.
inline Scene sphere_scene(float ior, int levels = 5) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(ior)};
  scene.meshes = {floor(3.0, 0.0, 0), sphere({0.0, 0.8, 0.0}, 0.5, levels, 1)};
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {camera_down(0.2, 1.0)};
  return scene;
}

inline Scene without_casters(Scene scene) {
  std::erase_if(scene.meshes, [&](const Mesh& mesh) {
    return scene.materials[static_cast<std::size_t>(mesh.material)].transmission > 0.0f;
  });
  return scene;
}

inline Settings small_settings(int grid, int map, int picture) {
  Settings settings;
  settings.width = settings.height = picture;
  settings.grid = grid;
  settings.map = map;
  settings.shadow = 256;
  return settings;
}

// Neither light nor the camera's rays are followed from surface to surface.
inline Settings through_two_surfaces(Settings settings) {
  settings.further_share = 1.0f;
  return settings;
}

}  // namespace caustics::test
