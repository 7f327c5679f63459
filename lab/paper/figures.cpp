// What the paper's figures show.
#include <algorithm>
#include <cmath>

#include "lab/paper/floor_shots.hpp"
#include "lab/paper/measures.hpp"
#include "lab/paper/rows.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::paper {

Row formation_row() {
  return {"3",
          "Fig. 3: rays from the light through the caster to receivers",
          {dumped_shot("rays", "slab_glass.glb", 64)},
          "",
          "rays through a slab, 80 mm from its edges on, land within 1e-5 m of where Snell's law has them",
          [](const Shots& s) -> Finding {
            const std::vector<double> errors = slab_errors(kSlab, s.attachment("rays", "caster_position[0]"),
                                                           s.attachment("rays", "landing[0]"));
            const double worst = percentile(errors, 1.0);
            return {errors.size() > 100 && worst < 1e-5,
                    std::to_string(errors.size()) + " rays, at most " + significant(worst, 2) + " m off"};
          }};
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
  Row row{"10",
          "Fig. 13: a figure refracted by one index and by three, and a spectrum by sixteen",
          {{"spectrum_16", "spectrum.glb", {"-r", "960x540", "--wavelengths", "16"}}},
          "flint_3",
          "all wavelengths together enter as white, ledgers close; three indices leave colours where one "
          "leaves none",
          {}};
  for (const char* wavelengths : {"1", "3"})
    row.shots.push_back({std::string("flint_") + wavelengths,
                         "flint_figure.glb",
                         {"-r", "960x540", "--grid", "256", "--wavelengths", wavelengths},
                         "caustic"});
  row.check = [](const Shots& s) -> Finding {
    double white = 0.0;
    for (const char* name : {"spectrum_16", "flint_1", "flint_3"})
      for (int c = 0; c < 3; ++c)
        white = std::max(white, std::fabs(s.flux(name, "entered", c) / s.flux(name, "entered", 1) - 1.0));
    const auto coloured = [&](const char* name) {
      double apart = 0.0, sum = 0.0;
      for (const auto& pixel : s.layer(name, "caustic").pixels) {
        apart += std::fabs(pixel[0] - pixel[2]);
        sum += pixel[0] + pixel[2];
      }
      return sum > 0.0 ? apart / sum : 0.0;
    };
    const double one = coloured("flint_1"), three = coloured("flint_3");
    return {
        all_closed(s, {"spectrum_16", "flint_1", "flint_3"}) && white < 1e-5 && one < 1e-6 && three > 0.05,
        "channels enter alike to " + significant(white, 2) +
            "; red and blue of the figure's caustic differ by " + percent(one) +
            " of their sum with one index, by " + percent(three) + " with three"};
  };
  return row;
}

Row diagrams_row() {
  return {"4",
          "Figs. 4, 5, 9, 10",
          {},
          "",
          "nothing: the text at hand does not hold them",
          [](const Shots&) -> Finding {
            return {
                true,
                "not recovered; `caustics probe` shows a ray's steps, row 8 the grid, row 15 an area light"};
          }};
}
}  // namespace caustics::paper
