// Total reflection, grazing light, extreme indices, absorption and dispersion.
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "tests/stability/hard_case.hpp"
#include "tests/support/catch.hpp"
#include "tests/truth/prism.hpp"

namespace caustics::test {

namespace {

// A prism whose vertical face takes nothing and whose hypotenuse, at 45 degrees, is met from inside by light
// that came in through the level top without bending.
Mesh right_prism() {
  Mesh mesh;
  mesh.name = "prism";
  mesh.material = 1;
  const auto polygon = [&](const std::vector<glm::vec3>& points) {
    const glm::vec3 n = glm::normalize(glm::cross(points[1] - points[0], points[2] - points[0]));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::vec3& p : points) mesh.vertices.push_back({.position = p, .normal = n});
    for (std::uint32_t i = 2; i < points.size(); ++i)
      for (const std::uint32_t v : {0u, i - 1, i}) mesh.indices.push_back(first + v);
  };
  const float h = 0.4f, low = 0.5f, high = 0.9f;  // half width, heights
  polygon({{-0.2f, high, h}, {0.2f, high, h}, {0.2f, high, -h}, {-0.2f, high, -h}});
  polygon({{-0.2f, low, -h}, {-0.2f, low, h}, {-0.2f, high, h}, {-0.2f, high, -h}});
  polygon({{-0.2f, low, h}, {-0.2f, low, -h}, {0.2f, high, -h}, {0.2f, high, h}});
  polygon({{-0.2f, low, h}, {0.2f, high, h}, {-0.2f, high, h}});
  polygon({{-0.2f, low, -h}, {-0.2f, high, -h}, {0.2f, high, -h}});
  finish(mesh, 1.0f);
  return mesh;
}

HardCase critical_angle_case(float index, const std::string& where, const std::string& behaviour) {
  HardCase c{"total reflection, " + where, behaviour, {}};
  c.scene.materials = {diffuse(0.8f), glass(index)};
  c.scene.meshes = {floor(40.0, 0.0, 0), right_prism()};
  c.scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  c.scene.cameras = {camera_down(0.2, 1.0)};
  // Through the level face at 0 degrees, at the slanted one from inside at 45 degrees.
  const double n = static_cast<double>(index);
  const double first = 1.0 - fresnel(1.0, 1.0, n).mean(),
               second = 1.0 - fresnel(std::sqrt(0.5), n, 1.0).mean();
  c.expect = [=](const DrawnCase& drawn) {
    CHECK(drawn.leaves() == Approx(first * second).margin(0.01));
    CHECK(drawn.share(&Ledger::total_reflection) == Approx(second > 0.0 ? 0.0 : first).margin(0.01));
  };
  return c;
}

// The mean over a disc of light of the share that passes a sphere's two surfaces; Snell's and Fresnel's laws,
// by 4,000 rings of equal area.
double passes_sphere(double n) {
  double sum = 0.0;
  const int rings = 4000;
  for (int i = 0; i < rings; ++i) {
    const double cosine = std::sqrt(1.0 - (i + 0.5) / rings);
    const double t = 1.0 - fresnel(cosine, 1.0, n).mean();
    sum += t * t / rings;
  }
  return sum;
}

HardCase index_case(float index, const std::string& behaviour) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", static_cast<double>(index));
  HardCase c{"sphere of index " + std::string(text), behaviour, sphere_scene(index, 4)};
  c.settings = through_two_surfaces(small_settings(96, 64, 24));
  c.settings.interfaces = Interfaces::Two;  // what the closed form counts
  c.expect = [index](const DrawnCase& drawn) {
    CHECK(drawn.leaves() + drawn.share(&Ledger::absorbed) ==
          Approx(passes_sphere(static_cast<double>(index))).margin(0.01));
  };
  return c;
}

// Light goes on as if there was no sphere: each landing lies under where it entered.
HardCase index_one_case() {
  HardCase c =
      index_case(1.0f, "nothing bends or is reflected: each landing lies straight under where light entered");
  c.expect = [](const DrawnCase& drawn) {
    CHECK(drawn.share(&Ledger::fresnel) == 0.0);
    CHECK(drawn.share(&Ledger::in_map) == Approx(1.0).margin(2e-3));
    const Image &landing = drawn.of_light(kLanding), &entry = drawn.of_light("caster_position");
    int landed = 0;
    for (int y = 0; y < landing.height(); ++y)
      for (int x = 0; x < landing.width(); ++x) {
        if (landing.at(x, y, 3) != static_cast<float>(LandingStatus::Landed)) continue;
        ++landed;
        CHECK(std::fabs(landing.at(x, y, 0) - entry.at(x, y, 0)) < 1e-6f);
        CHECK(std::fabs(landing.at(x, y, 2) - entry.at(x, y, 2)) < 1e-6f);
      }
    CHECK(landed > 4000);
  };
  return c;
}

HardCase index_zero_case() {
  HardCase c{"index 0", "glTF's value for what never refracts: no caster, a receiver of light",
             sphere_scene(0.0f, 4)};
  c.expect = [](const DrawnCase& drawn) {
    CHECK(drawn.ledger().entered[1] == 0.0);
    CHECK(drawn.rendering.images.count(light_texture(kCausticMap, 0)) == 0);
  };
  return c;
}

HardCase grazing_case(double degrees) {
  char text[64];
  std::snprintf(text, sizeof text, "light %g degrees off a water surface's normal", degrees);
  HardCase c{text, "reflected by Fresnel's law; what little enters lands", {}};
  c.scene.materials = {diffuse(0.8f), glass(1.33f)};
  c.scene.meshes = {floor(3.0, 0.0, 0), floor(0.5, 0.5, 1)};
  const double angle = degrees * Prism::kDegree;
  c.scene.lights = {sun({std::sin(angle), -std::cos(angle), 0.0}, 1.0f)};
  c.scene.cameras = {camera_down(0.2, 1.0)};
  const double reflected = fresnel(std::cos(angle), 1.0, static_cast<double>(1.33f)).mean();
  c.expect = [=](const DrawnCase& drawn) {
    if (drawn.ledger().entered[1] > 0.0)
      CHECK(drawn.share(&Ledger::fresnel) == Approx(reflected).margin(1e-3));
  };
  return c;
}

HardCase edge_on_case() {
  HardCase c = grazing_case(90.0);
  c.name = "light along a water surface";
  c.behaviour = "the sheet has no extent across the light: nothing enters, no caustic";
  c.expect = [](const DrawnCase& drawn) { CHECK(drawn.ledger().entered[1] == 0.0); };
  return c;
}

HardCase absorbing_case(const std::string& name, const std::string& behaviour, float distance, float color,
                        bool black) {
  HardCase c{name, behaviour, sphere_scene(1.5f, 4)};
  c.scene.materials[1].attenuation_distance = distance;
  c.scene.materials[1].attenuation_color = glm::vec3(color);
  c.expect = [black](const DrawnCase& drawn) {
    if (black) {
      CHECK(drawn.share(&Ledger::in_map) < 1e-6);
    } else {
      CHECK(drawn.share(&Ledger::absorbed) < 1e-3);
    }
    CHECK(drawn.share(&Ledger::fresnel) + drawn.share(&Ledger::absorbed) +
              drawn.share(&Ledger::total_reflection) + drawn.leaves() ==
          Approx(1.0).epsilon(1e-5));
  };
  return c;
}

HardCase dispersing_case(float dispersion, int wavelengths, const std::string& behaviour) {
  char text[96];
  std::snprintf(text, sizeof text, "dispersion %g (Abbe number %g), %d wavelengths",
                static_cast<double>(dispersion), 20.0 / static_cast<double>(dispersion), wavelengths);
  HardCase c{text, behaviour, sphere_scene(1.5f, 4)};
  c.scene.materials[1].dispersion = dispersion;
  c.settings = through_two_surfaces(small_settings(24, 32, 16));
  c.settings.wavelengths = wavelengths;
  return c;
}

HardCase reflections_case() {
  HardCase c{"a diamond ball and what it mirrors", "both branches' books close together",
             sphere_scene(2.42f, 4)};
  c.settings.reflections = true;
  return c;
}

HardCase black_mirror_case() {
  HardCase c{"a black mirror, and one whiter than white may be",
             "all absorbed but Schlick's share; never more light than fell on it",
             {}};
  c.scene.materials = {diffuse(0.8f), metal(glm::vec3(0.0f)), metal(glm::vec3(1.0f))};
  c.scene.meshes = {floor(3.0, 0.0, 0), half_ring(0.5, 0.3, 24, 1), half_ring(0.8, 0.3, 24, 2)};
  c.scene.lights = {sun({1.0, -1.0, 0.0}, 1.0f)};
  c.scene.cameras = {camera_down(0.2, 1.0)};
  c.expect = [](const DrawnCase& drawn) { CHECK(drawn.leaves() < 1.0); };
  return c;
}

}  // namespace

std::vector<HardCase> optics_cases() {
  std::vector<HardCase> cases;
  cases.push_back(critical_angle_case(1.41f, "just below the critical index (1.41 at 45 degrees)",
                                      "leaves along the surface, less what Fresnel's law keeps"));
  cases.push_back(critical_angle_case(1.41421356f,
                                      "at the critical index, the float nearest to the root of 2",
                                      "a rounding decides between both, and both leave nearly nothing"));
  cases.push_back(critical_angle_case(1.42f, "just above the critical index",
                                      "all booked as total reflection, nothing drawn"));
  cases.push_back(grazing_case(89.0));
  cases.push_back(grazing_case(89.9));
  cases.push_back(edge_on_case());
  cases.push_back(index_one_case());
  cases.push_back(index_case(1.000001f, "as index 1 to six digits: no cancellation near 1"));
  cases.push_back(index_case(
      0.9f, "light from denser into thinner: total reflection at the entry is booked as Fresnel's"));
  cases.push_back(index_zero_case());
  cases.push_back(index_case(2.42f, "diamond: Fresnel's law at both surfaces"));
  cases.push_back(index_case(4.0f, "germanium: likewise"));
  cases.push_back(absorbing_case("absorption 1e9 per metre", "all absorbed; the exponential's underflow is 0",
                                 1e-9f, 0.5f, true));
  cases.push_back(absorbing_case("absorption colour 0", "all absorbed", 1.0f, 0.0f, true));
  cases.push_back(absorbing_case("attenuation over 1e30 m", "nothing absorbed", 1e30f, 0.5f, false));
  cases.push_back(dispersing_case(20.0f, 3, "all three lines' books close"));
  cases.push_back(dispersing_case(200.0f, 64,
                                  "indices below 1 and below 0 go on as any other; saturated colours have "
                                  "negative shares of a channel; books close"));
  cases.push_back(reflections_case());
  cases.push_back(black_mirror_case());
  return cases;
}

}  // namespace caustics::test
