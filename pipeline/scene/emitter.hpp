// Meshes that shine: as lights, and points spread over their area.
#pragma once
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

struct SurfacePoint {
  glm::dvec3 position{0.0}, normal{0.0};  // the unit normal of the side that shines
  glm::dvec2 uv{0.0};                     // texture coordinates
};

// The surface of a mesh that shines. Both sides do where it is an open sheet of a double-sided material.
class Emitter {
 public:
  // `mesh`: index into Scene::meshes. The scene must outlive it.
  Emitter(const Scene& scene, int mesh);
  // Square metres, of all sides that shine.
  double area() const { return sums_.empty() ? 0.0 : sums_.back(); }
  // Does it shine to opposite sides: as a closed mesh, or an open sheet from both its sides?
  bool shines_all_around() const { return sides_ == 2 || mesh_.closed(); }
  // Nit, by channel: the mean over the surface where a texture varies it.
  glm::vec3 radiance() const;
  // A flat rectangle: sets the light's middle, edges and direction, that of its front. Is it one?
  bool make_rectangle(Light& light) const;
  // A closed sphere within which there is nothing else looks like a disk from all sides: sets middle and
  // radius. Is it one?
  bool make_ball(Light& light) const;
  // Points that stand for equal areas, near in place and normal; one point stands near the middle.
  std::vector<SurfacePoint> spread(int count) const;
  // So many points, spread evenly over the area; neighbours in the list are near in place and normal.
  std::vector<SurfacePoint> list(int count) const;

 private:
  std::vector<SurfacePoint> even(int count) const;
  // `along` (0..1) chooses the triangle by its share of the area, u and v (0..1) the point on it.
  SurfacePoint point(double along, double u, double v) const;

  const Scene& scene_;
  const Mesh& mesh_;
  const Material& material_;
  std::size_t sides_ = 1;
  std::vector<double> sums_;  // area of the triangles up to and with each; then of their back sides
};

// Has it a surface, and does its material shine (Material::emissive; an unlit one only shows its colour)?
bool shines(const Scene& scene, const Mesh& mesh);

// A light of LightShape::Mesh for a mesh that shines. Its intensity is luminance times area, candela.
Light light_of_mesh(const Scene& scene, int mesh);

// Those of Scene::sources that are lamps (Light::is_lamp): the first 64.
std::vector<int> lamps_of_points(const Scene& scene);

// Adds a light of every mesh that shines after the lights that the scene has. To be called before
// sample_lights.
void add_emissive_lights(Scene& scene);

}  // namespace caustics
