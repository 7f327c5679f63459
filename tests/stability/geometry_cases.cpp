// Meshes that are broken, flat, doubled, inside out or wild.
#include <cmath>

#include "tests/stability/hard_case.hpp"
#include "tests/support/catch.hpp"

namespace caustics::test {

namespace {

// A number in 0..1 of each index, the same everywhere.
float scatter(std::uint32_t index) {
  std::uint32_t h = index * 2654435761u;
  h = (h ^ (h >> 15)) * 2246822519u;
  h ^= h >> 13;
  return static_cast<float>(h >> 8) * 0x1p-24f;
}

using Change = std::function<void(Mesh&)>;

HardCase changed_sphere(const std::string& name, const std::string& behaviour, const Change& change) {
  HardCase c{name, behaviour, sphere_scene(1.5f, 3)};
  change(c.scene.meshes[1]);
  return c;
}

void turn_inside_out(Mesh& mesh) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  for (Vertex& v : mesh.vertices) v.normal = -v.normal;
}

void flip_normals(Mesh& mesh) {
  for (Vertex& v : mesh.vertices) v.normal = -v.normal;
}

// Normals of every other vertex point the opposite way: between them they pass through zero.
void cancel_normals(Mesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
    if (i % 2) mesh.vertices[i].normal = -mesh.vertices[i].normal;
}

void scatter_normals(Mesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    const glm::vec3 n(scatter(3 * i) - 0.5f, scatter(3 * i + 1) - 0.5f, scatter(3 * i + 2) - 0.5f);
    mesh.vertices[i].normal = glm::normalize(n + glm::vec3(1e-6f));
  }
}

// Triangles without area: twice one vertex, three in a row, and one some thousand times longer than wide.
void add_degenerates(Mesh& mesh) {
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::vector<std::uint32_t> first(mesh.indices.begin(), mesh.indices.begin() + 60);
  for (std::size_t i = 0; i + 2 < first.size(); i += 3)
    for (const std::uint32_t v : {first[i], first[i], first[i + 1]}) mesh.indices.push_back(v);
  const glm::vec3 top(0.0f, 1.3f, 0.0f);
  for (const glm::vec3& p : {top, top + glm::vec3(1e-7f, 0.0f, 0.0f), top + glm::vec3(2e-7f, 0.0f, 0.0f),
                             glm::vec3(0.3f, 1.2f, 1e-6f), glm::vec3(-0.3f, 1.2f, 0.0f)})
    mesh.vertices.push_back({.position = p, .normal = {0.0f, 1.0f, 0.0f}});
  for (const std::uint32_t v : {n, n + 1, n + 2, n, n + 3, n + 4}) mesh.indices.push_back(v);
  finish(mesh, 1.0f);
}

HardCase degenerate_case() {
  HardCase c =
      changed_sphere("triangles without area, and slivers",
                     "cover no texel, or the slivers' own: the rest is the sphere's", add_degenerates);
  c.expect = [](const DrawnCase& drawn) { CHECK(drawn.leaves() == Approx(0.8355).margin(0.02)); };
  return c;
}

HardCase doubled_case() {
  HardCase c =
      changed_sphere("the same mesh twice in one place",
                     "through two surfaces the first one counts: as one sphere, to the bit", [](Mesh&) {});
  c.scene.meshes.push_back(c.scene.meshes[1]);
  c.settings.interfaces = Interfaces::Two;
  HardCase single = changed_sphere("", "", [](Mesh&) {});
  single.settings.interfaces = Interfaces::Two;
  c.expect = [single](const DrawnCase& drawn) {
    const auto device = make_software_device();
    const DrawnCase one = draw_case(single, *device, *device);
    CHECK(sha256(drawn.of_light(kCausticMap)) == sha256(one.of_light(kCausticMap)));
  };
  return c;
}

HardCase inside_out_case() {
  return changed_sphere(
      "winding and normals inside out",
      "files: turned on loading (docs/materials.md); as it stands: its far wall bends the light, books close",
      turn_inside_out);
}

HardCase open_case() {
  HardCase c = changed_sphere("a sphere without its lower half",
                              "not closed: bent once, at its first surface", [](Mesh& mesh) {
                                std::vector<std::uint32_t> upper;
                                for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                                  bool all = true;
                                  for (std::size_t k = 0; k < 3; ++k)
                                    all = all && mesh.vertices[mesh.indices[i + k]].position.y >= 0.79f;
                                  if (all)
                                    for (std::size_t k = 0; k < 3; ++k) upper.push_back(mesh.indices[i + k]);
                                }
                                mesh.indices = upper;
                                mesh.closedness = 0.5f;
                              });
  c.expect = [](const DrawnCase& drawn) { CHECK(drawn.share(&Ledger::total_reflection) == 0.0); };
  return c;
}

HardCase pierced_case() {
  HardCase c = changed_sphere(
      "a mesh that cuts itself", "the nearest front counts, and the first back behind it", [](Mesh& mesh) {
        Mesh other = sphere({0.3, 0.8, 0.1}, 0.4, 3, 1);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const std::uint32_t i : other.indices) mesh.indices.push_back(first + i);
        finish(mesh, 1.0f);
      });
  return c;
}

HardCase nested_case() {
  HardCase c = changed_sphere("glass in glass",
                              "two surfaces bend light, no more: the outer front, and the first back behind "
                              "it, which is the inner body's",
                              [](Mesh&) {});
  c.scene.materials.push_back(glass(1.2f));
  c.scene.meshes.push_back(sphere({0.0, 0.8, 0.0}, 0.3, 3, 2));
  return c;
}

HardCase triangle_case() {
  HardCase c = changed_sphere("a single triangle of glass", "an open sheet: bent once", [](Mesh& mesh) {
    mesh.vertices.resize(3);
    mesh.indices = {0, 1, 2};
    const glm::vec3 corners[] = {{-0.2f, 0.8f, 0.2f}, {0.2f, 0.8f, 0.2f}, {0.0f, 0.9f, -0.2f}};
    for (std::size_t i = 0; i < 3; ++i)
      mesh.vertices[i] = {.position = corners[i], .normal = {0.0f, 1.0f, 0.0f}};
    finish(mesh, 0.0f);
  });
  c.expect = [](const DrawnCase& drawn) { CHECK(drawn.share(&Ledger::in_map) > 0.9); };
  return c;
}

HardCase thin_case() {
  HardCase c =
      changed_sphere("a plate a ten-millionth of a metre thick",
                     "both surfaces in one texel's depth: light passes as through a plate", [](Mesh& mesh) {
                       mesh = box({-0.4, 0.8, -0.4}, {0.4, 0.8 + 1e-7, 0.4}, 1);
                     });
  // Twice 4 % at normal incidence.
  c.expect = [](const DrawnCase& drawn) { CHECK(drawn.leaves() == Approx(0.96 * 0.96).margin(0.01)); };
  return c;
}

HardCase speck_case() {
  HardCase c = changed_sphere("a caster smaller than a cell of the grid beside a large one",
                              "takes the texels whose centres it covers, or none", [](Mesh&) {});
  c.scene.meshes.push_back(sphere({1.2, 0.8, 0.0}, 0.004, 2, 1));
  return c;
}

}  // namespace

std::vector<HardCase> geometry_cases() {
  std::vector<HardCase> cases;
  cases.push_back(changed_sphere("normals that cancel between vertices",
                                 "where none is left the triangle's own normal stands in", cancel_normals));
  cases.push_back(changed_sphere("normals that point anywhere",
                                 "tilted towards the light's side where they face away; books close",
                                 scatter_normals));
  cases.push_back(changed_sphere(
      "normals that face away from the light on every front",
      "files: turned on loading; as they stand: tilted to where the surface ends, which mirrors nearly all",
      flip_normals));
  cases.push_back(inside_out_case());
  cases.push_back(degenerate_case());
  cases.push_back(doubled_case());
  cases.push_back(open_case());
  cases.push_back(pierced_case());
  cases.push_back(nested_case());
  cases.push_back(triangle_case());
  cases.push_back(thin_case());
  cases.push_back(speck_case());
  return cases;
}

}  // namespace caustics::test
