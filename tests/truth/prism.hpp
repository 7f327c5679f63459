// A prism and where its light lands, followed by hand.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "lab/reference/closed_forms.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

namespace caustics::test {

// A prism with an apex of 60 degrees and edges along z, its middle 0.6 m above a floor, under
// vertical light. Angles are those of the faces' outward normals in the x-y plane.
struct Prism {
  static constexpr double kDegree = 3.14159265358979323846 / 180.0;
  double incidence;  // on the entry face
  double entry = 90.0 * kDegree + incidence, exit = entry + 120.0 * kDegree, base = exit + 120.0 * kDegree;
  double inner = 0.1, height = 0.6;  // of the faces from the middle; of the middle above the floor
  Scene scene;

  explicit Prism(const Material& material, double incidence_on_entry = 50.0 * kDegree)
      : incidence(incidence_on_entry) {
    scene.materials = {diffuse(0.8f), material};
    scene.meshes = {floor(4.0, 0.0, 0), mesh()};
    scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  }

  glm::dvec3 normal(double angle) const { return {std::cos(angle), std::sin(angle), 0.0}; }

  // Where the lines normal(a).p = inner and normal(b).p = inner meet.
  glm::dvec2 corner(double a, double b) const {
    const double d = std::cos(a) * std::sin(b) - std::sin(a) * std::cos(b);
    return glm::dvec2(inner * (std::sin(b) - std::sin(a)) / d, inner * (std::cos(a) - std::cos(b)) / d);
  }

  Mesh mesh() const {
    const glm::dvec2 c[3] = {corner(base, entry), corner(entry, exit), corner(exit, base)};
    Mesh mesh;
    mesh.name = "prism";
    mesh.material = 1;
    const auto polygon = [&](const std::vector<glm::dvec3>& points) {
      const glm::dvec3 n = glm::normalize(glm::cross(points[1] - points[0], points[2] - points[0]));
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const glm::dvec3& p : points) {
        Vertex v;
        v.position = glm::vec3(p);
        v.normal = glm::vec3(n);
        mesh.vertices.push_back(v);
      }
      for (std::uint32_t i = 2; i < points.size(); ++i)
        for (const std::uint32_t j : {0u, i - 1, i}) mesh.indices.push_back(first + j);
    };
    const double half = 0.4;
    const auto at = [&](int i, double z) { return glm::dvec3(c[i].x, c[i].y + height, z); };
    polygon({at(0, half), at(1, half), at(2, half)});
    polygon({at(0, -half), at(2, -half), at(1, -half)});
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      polygon({at(i, -half), at(j, -half), at(j, half), at(i, half)});
    }
    finish(mesh, 1.0f);
    return mesh;
  }

  // Where light of index n that enters at p1 meets the exit face; nothing where it meets the base.
  std::optional<glm::dvec3> exit_point(const glm::dvec3& p1, double n) const {
    const glm::dvec3 middle(0.0, height, 0.0), n2 = normal(exit);
    const glm::dvec3 d1 = *refract_direction({0.0, -1.0, 0.0}, normal(entry), 1.0 / n);
    const double to_exit = (inner - glm::dot(p1 - middle, n2)) / glm::dot(d1, n2);
    const glm::dvec3 p2 = p1 + to_exit * d1;
    if (glm::dot(p2 - middle, normal(base)) > inner - 1e-3) return {};
    return p2;
  }

  // Where that light lands on the floor, followed by hand in the cross-section's plane: Snell at
  // the entry, straight to the exit face's line, Snell again, straight down.
  std::optional<double> landing(const glm::dvec3& p1, double n) const {
    const glm::dvec3 down(0.0, -1.0, 0.0);
    const std::optional<glm::dvec3> p2 = exit_point(p1, n);
    if (!p2) return {};
    const glm::dvec3 d1 = *refract_direction(down, normal(entry), 1.0 / n);
    const glm::dvec3 d2 = *refract_direction(d1, -normal(exit), n);
    CHECK(std::acos(glm::dot(d2, down)) ==
          Approx(*prism_deviation(60.0 * kDegree, n, incidence)).epsilon(1e-9));
    return p2->x - d2.x / d2.y * p2->y;
  }

  // Is this texel of the caster's normals on the entry face?
  bool is_entry(const Image& normals, int x, int y) const {
    return std::fabs(double(normals.at(x, y, 0)) - normal(entry).x) < 1e-3;
  }
};

// The largest distance between landings and those followed by hand, over the middle row of the
// entry face, metres.
inline double worst_landing(const Prism& prism, const Rendering& r, const std::string& landing_name, double n,
                            int& compared) {
  const Image& landing = r[landing_name];
  const Image& position = r[light_texture("caster_position", 0)];
  const Image& normal = r[light_texture("caster_normal", 0)];
  double worst = 0.0;
  for (int x = 0; x < landing.width(); ++x) {
    const int y = landing.height() / 2;
    const glm::dvec3 p1{position.at(x, y, 0), position.at(x, y, 1), 0.0};
    if (position.at(x, y, 3) == 0.0f || !prism.is_entry(normal, x, y)) continue;
    const std::optional<double> expected = prism.landing(p1, n);
    if (!expected) continue;
    REQUIRE(landing.at(x, y, 3) == float(LandingStatus::Landed));
    worst = std::max(worst, std::fabs(double(landing.at(x, y, 0)) - *expected));
    ++compared;
  }
  return worst;
}

}  // namespace caustics::test
