#include "app/reference_shapes.hpp"

#include <algorithm>

#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/nearest.hpp"

namespace caustics::app {

namespace {

constexpr const char* kNames[] = {"sphere", "cylinder", "waves"};  // by ShapeKind, and by ExactShape::form

bool has_shape(const std::vector<tracer::ExactShape>& shapes, int mesh) {
  return std::any_of(shapes.begin(), shapes.end(),
                     [&](const tracer::ExactShape& s) { return s.mesh == mesh; });
}

// Of each mesh that has this name.
void add_named(const Scene& scene, const ExactRequest::Named& wanted,
               std::vector<tracer::ExactShape>& shapes) {
  std::vector<std::string> names;
  bool found = false;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    names.push_back(scene.meshes[i].name);
    if (names.back() != wanted.mesh) continue;
    found = true;
    const int mesh = static_cast<int>(i);
    if (has_shape(shapes, mesh))
      throw Error(ExitCode::WrongUsage, "--exact names the mesh " + in_quotes(wanted.mesh) + " twice");
    shapes.push_back(tracer::exact_shape_of(scene, mesh, wanted.kind));
  }
  if (!found)
    throw Error(ExitCode::WrongUsage,
                "--exact names no mesh: " + in_quotes(wanted.mesh) + suggestion(wanted.mesh, names));
}

}  // namespace

void ExactRequest::add(const std::string& text) {
  if (text == "scene") {
    stated_by_scene = true;
    return;
  }
  const std::size_t equals = text.rfind('=');
  const std::string kind = equals == std::string::npos ? "" : text.substr(equals + 1);
  const auto found = std::find(std::begin(kNames), std::end(kNames), kind);
  if (found == std::end(kNames))
    throw Error(ExitCode::WrongUsage, "--exact cannot be " + in_quotes(text) +
                                          ": scene, or NAME=sphere, NAME=cylinder, NAME=waves");
  named.push_back({text.substr(0, equals), static_cast<ShapeKind>(found - std::begin(kNames))});
}

std::vector<tracer::ExactShape> exact_shapes(const Scene& scene, const ExactRequest& request) {
  std::vector<tracer::ExactShape> shapes;
  for (const ExactRequest::Named& named : request.named) add_named(scene, named, shapes);
  if (!request.stated_by_scene) return shapes;
  if (scene.stated_shapes.empty())
    throw Error(ExitCode::WrongUsage,
                "--exact scene: the file states no shape in extras.exact_shape "
                "(docs/reference.md); name one, as in --exact ball=sphere");
  // What is named here counts more.
  for (const StatedShape& stated : scene.stated_shapes)
    if (!has_shape(shapes, stated.mesh))
      shapes.push_back(tracer::exact_shape_of(scene, stated.mesh, stated.kind));
  return shapes;
}

const char* name_of(const tracer::ExactShape& shape) { return kNames[shape.form.index()]; }

}  // namespace caustics::app
