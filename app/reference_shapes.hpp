// Which meshes `caustics reference` traces as exact shapes: --exact.
#pragma once
#include <string>
#include <vector>

#include "lab/reference/tracer/exact_shapes.hpp"

namespace caustics::app {

// What the options ask for; it can be looked up only once the scene is loaded.
struct ExactRequest {
  struct Named {
    std::string mesh;
    ShapeKind kind = ShapeKind::Sphere;
  };
  std::vector<Named> named;
  bool stated_by_scene = false;  // --exact scene

  // "scene" or NAME=sphere|cylinder|waves. Throws Error (WrongUsage).
  void add(const std::string& text);
};

// Throws Error: WrongUsage for a name that no mesh has, two shapes for one mesh, or a scene that states none;
// BadInput for a mesh that is no such shape.
std::vector<tracer::ExactShape> exact_shapes(const Scene& scene, const ExactRequest& request);

const char* name_of(const tracer::ExactShape& shape);  // "sphere", as --exact has it

}  // namespace caustics::app
