// What light does at surfaces and in air, and what lights there are.
#include <algorithm>
#include <cmath>

#include "lab/paper/floor_shots.hpp"
#include "lab/paper/measures.hpp"
#include "lab/paper/rows.hpp"
#include "lab/reference/ring_floor.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::paper {

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

Row mirror_row() {
  return {
      "14",
      "reflection, one bounce",
      {floor_shot("ring_floor", "metal_ring.glb")},
      "",
      "relative L1 against the closed form of both walls below 5 %",
      [](const Shots& s) -> Finding {
        const FloorLayer caustic = s.layer("ring_floor", "caustic");
        const MetalRing ring{
            .inner = 0.5, .outer = 0.54, .height = 0.18, .elevation = std::atan(0.8), .reflectance = 0.78};
        const int pixels = caustic.width;
        const std::vector<double> truth = irradiance_average(ring, {.pixels = pixels});
        double difference = 0.0, sum = 0.0;
        for (int y = 0; y < pixels; ++y)
          for (int x = 0; x < pixels; ++x) {
            const double r = std::hypot((x + 0.5) / pixels * 2.0 - 1.0, (y + 0.5) / pixels * 2.0 - 1.0);
            if (r > ring.inner - 0.004 && r < ring.outer + 0.004) continue;  // the ring stands there
            const double expected =
                10.0 * truth[static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels) +
                             static_cast<std::size_t>(x)];
            difference += std::fabs(caustic.at(x, y)[1] - expected);
            sum += expected;
          }
        return {difference < 0.05 * sum, "relative L1 " + percent(difference / sum)};
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

namespace {

// V, on both devices, and what the occlusion query says.
Finding judge_count(const Shots& s) {
  const auto v = [&](const char* name) { return s.attachment(name, "caster_flux[0]").values[0][1]; };
  const auto query = [&](const char* name) { return s.samples_passed(name, "caster_map"); };
  double covered = 0.0;
  for (const auto& p : s.attachment("query", "caster_position[0]").values) covered += p[3] != 0.0 ? 1.0 : 0.0;
  bool same = v("query") == covered && query("query") >= covered;
  std::string text = "V " + significant(covered, 8) +
                     ", the query, which counts texels again that a nearer facet covers later, " +
                     significant(query("query"), 8);
  if (s.taken("query_gl")) {
    same = same && v("query_gl") == v("query") && query("query_gl") == query("query");
    text += std::string("; OpenGL counts ") + (same ? "the same" : "otherwise");
  } else {
    text += "; OpenGL is not there";
  }
  return {same, text};
}

// Each vertex's physical and paper's weights under the lamp of glass_sphere_lamp.glb, two radii from the
// sphere's middle, before the glass takes its part.
Finding judge_lamp(const Shots& s) {
  VertexWeights found;
  for (const auto& texel : s.attachment("lamp_physical", "landing_fresnel[0]").values)
    found.flux.push_back(texel[3]);
  for (const auto& texel : s.attachment("lamp_paper", "landing_fresnel[0]").values)
    found.literal.push_back(texel[3]);
  const VertexWeights exact = weights_under_lamp(2.0);
  const WeightErrors errors = weight_errors(found), expected = weight_errors(exact);
  const double part = sum_of(found.literal) / sum_of(found.flux);
  const double exact_part = sum_of(exact.literal) / sum_of(exact.flux);
  const bool holds = std::fabs(part - exact_part) < 2e-3 &&
                     std::fabs(errors.equal_parts - expected.equal_parts) < 2e-3 &&
                     std::fabs(errors.literal - expected.literal) < 2e-3;
  const auto error = [](double found_error, double exact_error) {
    return significant(1e2 * found_error, 3) + " % (" + significant(1e2 * exact_error, 3) + " %)";
  };
  return {holds, "under a lamp two radii from the middle " + significant(part, 4) + " (exact " +
                     significant(exact_part, 4) + "), equal parts " +
                     error(errors.equal_parts, expected.equal_parts) +
                     " off each vertex's own flux times N.L, " + error(errors.literal, expected.literal) +
                     " off that flux"};
}

}  // namespace

Row weights_row() {
  Shot on_gl = dumped_shot("query_gl", "glass_sphere.glb", 128, {"--preset", "paper", "--backend", "gl"});
  on_gl.on_gl = true;
  return {
      "21",
      "eq. 6: the light onto V grid vertices, an equal part of it each, times N.L; V by occlusion query",
      {floor_shot("paper_weights", "glass_sphere.glb", {"-D", "weights=paper"}),
       dumped_shot("query", "glass_sphere.glb", 128, {"--preset", "paper"}), on_gl,
       dumped_shot("lamp_physical", "glass_sphere_lamp.glb", 128),
       dumped_shot("lamp_paper", "glass_sphere_lamp.glb", 128, {"--weights", "paper"})},
      "",
      "weights add up to 2/3 of the light onto a sphere's disc; V is the number of covered texels, on "
      "both devices; under a lamp, sum and distance from physical weights within 0.002 of the closed form",
      [](const Shots& s) -> Finding {
        const double disc = 3.14159265358979 * 0.25;
        const double sum = s.flux("paper_weights", "entered", 0) / disc;
        const Finding count = judge_count(s), lamp = judge_lamp(s);
        return {std::fabs(sum - 2.0 / 3.0) < 2e-3 && count.holds && lamp.holds,
                significant(sum, 5) + "; " + count.figure + "; " + lamp.figure};
      }};
}

Row absorption_row() {
  return {
      "22",
      "eq. 7: absorption, inside the glass; through one surface, down to the receiver",
      {dumped_shot("amber", "glass_figure.glb", 128, {"-D", "unconverged=draw"}),
       dumped_shot("amber_open", "glass_figure.glb", 128, {"--interfaces", "1", "-D", "unconverged=draw"})},
      "amber",
      "each landing's colour is exp(-Ka d) to 1e-4, d inside, and from surface to receiver",
      [](const Shots& s) -> Finding {
        std::array<double, 3> absorption{};
        const std::array<double, 3> left{0.98, 0.60, 0.16};  // after 0.6 m
        for (std::size_t c = 0; c < 3; ++c) absorption[c] = -std::log(left[c]) / 0.6;
        const auto worst = [&](const std::string& name, bool open) {
          const Texels entry = s.attachment(name, "caster_position[0]");
          const Texels landing = s.attachment(name, "landing[0]");
          const Texels inside = s.attachment(name, "landing_absorbed[0]");
          std::vector<double> way;
          for (std::size_t i = 0; i < landing.values.size(); ++i) {
            const auto &p = entry.values[i], &q = landing.values[i];
            const bool counts = has_landed(q) && p[3] > 0.0;
            way.push_back(!counts ? -1.0
                          : open  ? std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2])
                                  : inside.values[i][3]);
          }
          return worst_tint(s.attachment(name, "landing_flux[0]"), way, absorption);
        };
        const double solid = worst("amber", false), open = worst("amber_open", true);
        return {solid < 1e-4 && open < 1e-4, "at most " + significant(solid, 2) + " off inside, " +
                                                 significant(open, 2) + " down to the receiver"};
      }};
}

Row haze_row() {
  return {"30",
          "caustics in a volume: a lens in haze",
          {{"haze", "hazy_lens.glb", {"-r", "960x540", "--exposure", "1"}}},
          "haze",
          "the medium takes its share; ledger within 1e-5",
          [](const Shots& s) -> Finding {
            return {all_closed(s, {"haze"}) && s.share("haze", "medium") > 0.0,
                    "the medium takes " + percent(s.share("haze", "medium")) + ", residual " +
                        significant(s.residual("haze"), 2)};
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
}  // namespace caustics::paper
