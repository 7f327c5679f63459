// What the rows of the table of closed forms share, and the table itself.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "tests/gl/gl_or_skip.hpp"
#include "tests/support/catch.hpp"
#include "tests/truth/rows.hpp"

namespace caustics::test {

std::string text_of(const Settings& settings) {
  return "grid " + std::to_string(settings.grid) + ", map " + std::to_string(settings.map);
}

double texel_on_floor(const Scene& scene, const Rendering& r, const Settings& settings) {
  const View& view = r.views[0].caustic;
  const glm::dvec2 size = view.window_upper - view.window_lower;
  return std::max(size.x, size.y) / settings.map / std::fabs(scene.lights[0].direction.y);
}

double relative_l1(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0.0, total = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    difference += std::fabs(a[i] - b[i]);
    total += b[i];
  }
  return difference / total;
}

namespace {

void check(const Rows& rows, const std::string& backend) {
  for (const Row& row : rows) {
    INFO(backend << ": " << row.truth << ", " << row.what << ": " << row.error << ", bound " << row.bound
                 << " (" << row.settings << ")");
    CHECK(row.error <= row.bound);
  }
}

}  // namespace

void check_rows(Rows (*rows)(const Bench&)) {
  const std::unique_ptr<Device> software = make_software_device();
  check(rows({*software, *software}), "software");
  const std::unique_ptr<GlDevice> gl = gl_or_skip();
  check(rows({*gl, *software}), gl->description());
}

}  // namespace caustics::test

namespace {

using namespace caustics::test;

std::string figure(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2g", value);
  return buffer;
}

void print_table(bool full) {
  const auto software = caustics::make_software_device();
  const auto gl = gl_if_any();
  std::cout << "| closed form | figure | error, software | error, OpenGL | bound | settings |\n"
               "|---|---|---|---|---|---|\n";
  for (const auto rows : {sphere_rows, bubble_rows, ring_rows, water_rows, point_light_rows, slab_rows,
                          prism_rows, interface_rows, imager_rows}) {
    const Rows by_software = rows({*software, *software, full});
    const Rows by_gl = gl ? rows({*gl, *software, full}) : Rows{};
    for (std::size_t i = 0; i < by_software.size(); ++i) {
      const Row& row = by_software[i];
      std::cout << "| " << row.truth << " | " << row.what << " | " << figure(row.error) << " | "
                << (gl ? figure(by_gl[i].error) : "no driver") << " | " << figure(row.bound) << " | "
                << row.settings << " |" << std::endl;
    }
  }
}

}  // namespace

TEST_CASE("truth: the table of closed forms at full size", "[.closed_forms]") {
  // Not part of a run by default: tests/support/update_table.py puts it into docs/accuracy.md.
  print_table(true);
}

TEST_CASE("truth: the table of closed forms at the tests' size", "[.closed_forms_small]") {
  print_table(false);
}
