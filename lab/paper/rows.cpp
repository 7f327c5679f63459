#include <algorithm>
#include <cmath>

#include "lab/paper/row.hpp"
#include "lab/reference/sphere_floor.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::paper {

namespace {

// glass_sphere.glb, as scenes/README.md has it.
constexpr GlassSphere kSphere{.radius = 0.5, .index = 1.5, .distance = 0.8};
const std::vector<std::string> kLandingToMap{"landing", "cells", "caustic_cells", "caustic_map",
                                             "cascade_cells"};

// The floor of a scene whose camera `floor` sees 2 x 2 m of it.
Shot floor_shot(const std::string& name, const std::string& scene, Options options = {}) {
  options.insert(options.begin(), {"-r", "512x512", "--camera", "floor"});
  return {name, scene, options, "direct,caustic"};
}

// The same by traced light, as the truth of pictures (its own noise: some 2 % of the sphere's caustic).
Shot traced_floor(const std::string& name, const std::string& scene) {
  return {name, scene, {"-r", "512x512", "--camera", "floor", "--batches", "64"}, "", true};
}

std::vector<double> floor_irradiance(const Shots& shots, const std::string& name) {
  const FloorLayer direct = shots.layer(name, "direct"), caustic = shots.layer(name, "caustic");
  std::vector<double> values;
  for (std::size_t i = 0; i < direct.pixels.size(); ++i)
    values.push_back(direct.pixels[i][0] + caustic.pixels[i][0]);
  return values;
}

SphereFloorError sphere_error(const Shots& shots, const std::string& name) {
  return compare_with_sphere(floor_irradiance(shots, name), kSphere, 2.0);
}

bool all_closed(const Shots& shots, const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(),
                     [&](const std::string& n) { return shots.residual(n) < 1e-5; });
}

Row figure_row() {
  return {"1",
          "Fig. 1: a coloured figure, two refractions for its caustic and its look",
          {{"figure", "glass_figure.glb", {"-r", "960x540"}}},
          "figure",
          "ledger within 1e-5; amber takes blue before green before red",
          [](const Shots& s) -> Finding {
            const auto taken = [&](int c) {
              return s.flux("figure", "absorbed", c) / s.flux("figure", "entered", c);
            };
            return {all_closed(s, {"figure"}) && taken(2) > taken(1) && taken(1) > taken(0),
                    "absorbed " + percent(taken(0)) + ", " + percent(taken(1)) + ", " + percent(taken(2)) +
                        " of red, green, blue; passes " +
                        duration_text(s.stats("figure").at("milliseconds").at("passes"))};
          }};
}

Row sphere_row() {
  return {"2",
          "Fig. 2: the glass sphere's caustic",
          {{"sphere", "glass_sphere.glb", {"-r", "960x540"}}, floor_shot("sphere_floor", "glass_sphere.glb")},
          "sphere",
          "relative L1 against the closed form below 5 %, flux within 0.5 %",
          [](const Shots& s) -> Finding {
            const SphereFloorError e = sphere_error(s, "sphere_floor");
            return {e.relative_l1_in_shadow < 0.05 && std::fabs(e.flux_ratio - 1.0) < 0.005,
                    "relative L1 " + percent(e.relative_l1_in_shadow) + ", flux ratio " +
                        significant(e.flux_ratio, 5)};
          }};
}

Row grids_row() {
  Row row{"8",
          "Fig. 11: grids of 64 and 128 (and 256) beside traced light; points and cells",
          {traced_floor("sphere_traced", "glass_sphere.glb")},
          "grids_side_by_side",
          "the error falls with the grid; cells beat points on every grid",
          {}};
  for (const char* splat : {"point", "cell"})
    for (const char* grid : {"64", "128", "256"})
      row.shots.push_back(floor_shot(std::string("grid_") + grid + "_" + splat, "glass_sphere.glb",
                                     {"--grid", grid, "--map", "256", "--splat", splat}));
  row.check = [](const Shots& s) -> Finding {
    std::string text = "relative L1, points against cells:";
    bool holds = true;
    double last = 1e9;
    for (const char* grid : {"64", "128", "256"}) {
      const std::string name = std::string("grid_") + grid + "_";
      const double point = sphere_error(s, name + "point").relative_l1_in_shadow;
      const double cell = sphere_error(s, name + "cell").relative_l1_in_shadow;
      text += std::string(" ") + grid + ": " + percent(point) + " " + percent(cell) + ",";
      holds = holds && cell < point && point < last;
      last = point;
    }
    text.pop_back();
    s.draw_side_by_side({"grid_64_point", "grid_128_point", "grid_64_cell", "grid_128_cell"}, "sphere_traced",
                        "caustic", "grids_side_by_side");
    return {holds, text};
  };
  return row;
}

Row ring_row() {
  return {"9",
          "Fig. 12: a metal ring: the caustic inside, and bands outside from its outer wall",
          {{"ring", "metal_ring.glb", {"-r", "960x540"}}, floor_shot("ring_floor", "metal_ring.glb")},
          "ring",
          "light inside the ring and outside it; red above green above blue, as gold reflects",
          [](const Shots& s) -> Finding {
            const FloorLayer caustic = s.layer("ring_floor", "caustic");
            double inside = 0.0, outside = 0.0;
            std::array<double, 3> sum{};
            for (int y = 0; y < caustic.height; ++y)
              for (int x = 0; x < caustic.width; ++x) {
                const double px = (x + 0.5) / caustic.width * 2.0 - 1.0,
                             py = (y + 0.5) / caustic.height * 2.0 - 1.0;
                const double r = std::sqrt(px * px + py * py);
                if (r < 0.49) inside += caustic.at(x, y)[0];
                if (r > 0.55) outside += caustic.at(x, y)[0];
                for (std::size_t c = 0; c < 3; ++c) sum[c] += caustic.at(x, y)[c];
              }
            return {all_closed(s, {"ring"}) && inside > 0.0 && outside > 0.0 && sum[0] > sum[1] &&
                        sum[1] > sum[2],
                    "of the light on the floor in view " + percent(outside / (inside + outside)) +
                        " lies outside; green and blue are " + significant(sum[1] / sum[0], 3) + " and " +
                        significant(sum[2] / sum[0], 3) + " of red"};
          }};
}

Row dispersion_row() {
  return {"10",
          "Fig. 13: refraction by three indices, and by sixteen",
          {{"spectrum", "spectrum.glb", {"-r", "960x540"}},
           {"spectrum_16", "spectrum.glb", {"-r", "960x540", "--wavelengths", "16"}}},
          "spectrum_16",
          "all wavelengths together enter as white; the ledger closes",
          [](const Shots& s) -> Finding {
            double worst = 0.0;
            for (const char* name : {"spectrum", "spectrum_16"})
              for (int c = 0; c < 3; ++c)
                worst =
                    std::max(worst, std::fabs(s.flux(name, "entered", c) / s.flux(name, "entered", 1) - 1.0));
            return {all_closed(s, {"spectrum", "spectrum_16"}) && worst < 1e-5,
                    "channels enter alike to " + significant(worst, 2)};
          }};
}

Row water_row() {
  Row row{"7",       "Fig. 8: water stirred by random plops at regular intervals",       {},
          "water_2", "as much light enters at every moment: 0.5 %; ledgers within 1e-5", {}};
  for (const char* seconds : {"0", "1", "2", "3"})
    row.shots.push_back(
        {std::string("water_") + seconds, "water_plops.glb", {"-r", "960x540", "--time", seconds}});
  row.check = [](const Shots& s) -> Finding {
    double least = 1e9, most = 0.0, least_lands = 1.0;
    for (const char* name : {"water_0", "water_1", "water_2", "water_3"}) {
      least = std::min(least, s.flux(name, "entered", 1));
      most = std::max(most, s.flux(name, "entered", 1));
      least_lands = std::min(least_lands, s.share(name, "in_map"));
    }
    return {all_closed(s, {"water_0", "water_1", "water_2", "water_3"}) && most / least < 1.005,
            "entered " + significant(least, 5) + " to " + significant(most, 5) + " m2, at least " +
                percent(least_lands) + " of it in the map"};
  };
  return row;
}

Row room_row() {
  return {"26",
          "the frustum's limitation: a lamp among its casters in a closed room",
          {{"room", "closed_room.glb", {"-r", "960x540"}}},
          "room",
          "no flux leaves the maps; ledger within 1e-5",
          [](const Shots& s) -> Finding {
            return {all_closed(s, {"room"}) && s.share("room", "outside") == 0.0,
                    "outside " + percent(s.share("room", "outside")) + ", residual " +
                        significant(s.residual("room"), 2)};
          }};
}

Row haze_row() {
  return {"30",
          "caustics in a volume: a lens in haze",
          {{"haze", "hazy_lens.glb", {"-r", "960x540", "--exposure", "3.5"}}},
          "haze",
          "the medium takes its share; ledger within 1e-5",
          [](const Shots& s) -> Finding {
            return {all_closed(s, {"haze"}) && s.share("haze", "medium") > 0.0,
                    "the medium takes " + percent(s.share("haze", "medium")) + ", residual " +
                        significant(s.residual("haze"), 2)};
          }};
}

Row interfaces_row() {
  return {
      "13",
      "single and double surface refraction",
      {floor_shot("one_interface", "glass_sphere.glb", {"--interfaces", "1"}),
       floor_shot("two_interfaces", "glass_sphere.glb", {"--interfaces", "2"})},
      "one_interface",
      "Fresnel's losses of one and of two interfaces: 9.178 % and 16.446 % (means over a sphere's disc)",
      [](const Shots& s) -> Finding {
        const double one = s.share("one_interface", "fresnel"), two = s.share("two_interfaces", "fresnel");
        const double exact_two = 1.0 - kSphere.transmitted_share();
        return {std::fabs(one - 0.09178) < 5e-4 && std::fabs(two - exact_two) < 1e-3,
                percent(one) + " and " + percent(two) + " (closed form of two: " + percent(exact_two) + ")"};
      }};
}

Row area_row() {
  Row row{"15",
          "area lights by sampling",
          {},
          "sun_16",
          "the flux does not depend on the number of samples: 0.5 %",
          {}};
  for (const char* samples : {"1", "4", "16"})
    row.shots.push_back({std::string("sun_") + samples,
                         "sun_disk.glb",
                         {"-r", "960x540", "--grid", "256", "--map", "256", "-D", "shadow=512", "-D",
                          std::string("light.samples=") + samples}});
  row.check = [](const Shots& s) -> Finding {
    const double one = s.flux("sun_1", "entered", 1);
    const double four = s.flux("sun_4", "entered", 1) / one, sixteen = s.flux("sun_16", "entered", 1) / one;
    return {
        std::fabs(four - 1.0) < 0.005 && std::fabs(sixteen - 1.0) < 0.005,
        "4 and 16 samples give " + significant(four, 5) + " and " + significant(sixteen, 5) + " of one's"};
  };
  return row;
}

Row identity_row() {
  return {
      "20",
      "the final pass: glass of IOR 1 is not there",
      {floor_shot("slab_identity", "slab.glb", {"--splat", "gaussian"})},
      "slab_identity",
      "direct light and caustic add up to the light without the slab, cos 40; the median pixel within 1e-3",
      [](const Shots& s) -> Finding {
        std::vector<double> off;
        const double expected = 0.76604444;
        for (const double e : floor_irradiance(s, "slab_identity"))
          off.push_back(std::fabs(e / expected - 1.0));
        std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2), off.end());
        const double median = off[off.size() / 2];
        return {median < 1e-3, "median " + significant(median, 2)};
      }};
}

Row weights_row() {
  return {"21",
          "eq. 6: the paper's weights, N.L over the visible texels",
          {floor_shot("paper_weights", "glass_sphere.glb", {"-D", "weights=paper"})},
          "",
          "they add up to 2/3 of the light onto a sphere's disc",
          [](const Shots& s) -> Finding {
            const double disc = 3.14159265358979 * 0.25;
            const double sum = s.flux("paper_weights", "entered", 0) / disc;
            return {std::fabs(sum - 2.0 / 3.0) < 2e-3, significant(sum, 5)};
          }};
}

Row gaps_row() {
  return {"24",
          "gaps between points",
          {floor_shot("gaps_point", "glass_sphere.glb", {"--grid", "64", "--splat", "point"}),
           floor_shot("gaps_cell", "glass_sphere.glb", {"--grid", "64"})},
          "gaps_point",
          "points of a grid of 64 leave most of the shadow dark, cells none of it",
          [](const Shots& s) -> Finding {
            const double point = sphere_error(s, "gaps_point").dark_share,
                         cell = sphere_error(s, "gaps_cell").dark_share;
            return {point > 0.5 && cell < 0.01,
                    "dark: " + percent(point) + " by points, " + percent(cell) + " by cells"};
          }};
}

Row gaussian_row() {
  return {"25",
          "points with a Gaussian",
          {floor_shot("gaussian", "glass_sphere.glb", {"--splat", "gaussian"})},
          "gaussian",
          "the kernel is normalised: map, map's edge and losses add up to what entered, 1e-5",
          [](const Shots& s) -> Finding {
            return {all_closed(s, {"gaussian"}), "residual " + significant(s.residual("gaussian"), 2) +
                                                     ", off the edge " +
                                                     percent(s.share("gaussian", "kernel_edge"))};
          }};
}

Row estimators_row() {
  Row row{"5, 31, 32",
          "Fig. 6: the estimators on the sphere: distance impostors, paper (the modified version), newton "
          "(the appendix), "
          "secant; beside traced light",
          {traced_floor("sphere_traced", "glass_sphere.glb")},
          "estimators_side_by_side",
          "3 iterations each; secant at least as near to the closed form as the paper's",
          {}};
  for (const char* estimator : {"paper", "newton", "impostor", "secant"})
    row.shots.push_back(floor_shot(std::string("estimator_") + estimator, "glass_sphere.glb",
                                   {"--estimator", estimator, "--iterations", "3"}));
  row.check = [](const Shots& s) -> Finding {
    std::string text = "relative L1, and what did not converge:";
    const auto error = [&](const char* e) {
      return sphere_error(s, std::string("estimator_") + e).relative_l1_in_shadow;
    };
    for (const char* e : {"paper", "newton", "impostor", "secant"})
      text += std::string(" ") + e + " " + percent(error(e)) + ", " +
              percent(s.share(std::string("estimator_") + e, "not_converged") +
                      s.share(std::string("estimator_") + e, "exit_not_found")) +
              ";";
    text.pop_back();
    s.draw_side_by_side({"estimator_impostor", "estimator_paper", "estimator_newton", "estimator_secant"},
                        "sphere_traced", "caustic", "estimators_side_by_side");
    return {error("secant") <= error("paper") + 1e-3, text};
  };
  return row;
}

// Receivers on which distance impostors are not exact.
Row receivers_row() {
  const Options view{"--camera", "floor", "-r", "360x360"};
  Row row{"6, 33, 38",
          "Figs. 6, 7: caustics mapping and distance impostors beside offline tracing, and receivers of any "
          "shape",
          {{"receivers_traced", "receivers.glb", view, "", true}},
          "receivers_side_by_side",
          "3 iterations each, step, ball and ramp: the secant is nearer to traced light than impostors",
          {}};
  row.shots.front().options.insert(row.shots.front().options.end(), {"--batches", "48"});
  for (const char* estimator : {"paper", "newton", "impostor", "secant"}) {
    Options options = view;
    options.insert(options.end(), {"--estimator", estimator, "--iterations", "3"});
    row.shots.push_back({std::string("receivers_") + estimator, "receivers.glb", options, "caustic"});
  }
  row.check = [](const Shots& s) -> Finding {
    std::string text = "relative L1:";
    const auto error = [&](const char* e) {
      return s.relative_l1(std::string("receivers_") + e, "receivers_traced", "caustic");
    };
    for (const char* e : {"paper", "newton", "impostor", "secant"})
      text += std::string(e == std::string("paper") ? " " : ", ") + e + " " + percent(error(e));
    s.draw_side_by_side({"receivers_impostor", "receivers_paper", "receivers_newton", "receivers_secant"},
                        "receivers_traced", "caustic", "receivers_side_by_side");
    return {error("secant") < error("impostor"), text};
  };
  return row;
}

Row times_row() {
  return {
      "23, 34",
      "what a caustic costs every frame",
      {{"sphere", "glass_sphere.glb", {"-r", "960x540"}}},
      "",
      "reported, not judged",
      [](const Shots& s) -> Finding {
        const double landing = s.milliseconds("sphere", {"caster_map", "caster_exit_map", "receiver_map"});
        return {true, "grid and map 512: maps " + duration_text(landing) + ", landings to caustic map " +
                          duration_text(s.milliseconds("sphere", kLandingToMap)) + ", all passes " +
                          duration_text(s.stats("sphere").at("milliseconds").at("passes"))};
      }};
}

Row lights_row() {
  return {"39",
          "coloured light through glass: two lights, each with its maps",
          {{"two_lights", "two_lights.glb", {"-r", "960x540"}}},
          "two_lights",
          "both ledgers within 1e-5; both casts reach the floor",
          [](const Shots& s) -> Finding {
            const double sun = s.share("two_lights", "in_map", 0), spot = s.share("two_lights", "in_map", 1);
            return {all_closed(s, {"two_lights"}) && sun > 0.5 && spot > 0.5,
                    percent(sun) + " of the sun's and " + percent(spot) + " of the spot's light lands"};
          }};
}

}  // namespace

std::vector<Row> paper_rows() {
  return {figure_row(),     sphere_row(), water_row(),    grids_row(),      ring_row(),      dispersion_row(),
          interfaces_row(), area_row(),   identity_row(), weights_row(),    times_row(),     gaps_row(),
          gaussian_row(),   room_row(),   haze_row(),     estimators_row(), receivers_row(), lights_row()};
}

}  // namespace caustics::paper
