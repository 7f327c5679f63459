// What a frame is put together from, what it costs, and what it is worth.
#include <algorithm>
#include <cmath>

#include "lab/paper/floor_shots.hpp"
#include "lab/paper/measures.hpp"
#include "lab/paper/rows.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::paper {

namespace {

// A frame's time by its parts; "sphere: caster, receiver maps 3 ms, V 0.1 ms, ...".
std::string parts(const Shots& s, const std::string& name) {
  const double all = s.stats(name).at("milliseconds").at("passes");
  const auto part = [&](const std::string& what, const std::vector<std::string>& passes) {
    return what + " " + duration_text(s.milliseconds(name, passes));
  };
  return part("light's views", {"caster_map", "caster_exit_map", "receiver_map", "shadow_map"}) + ", " +
         part("V", {"caster_flux"}) + ", " + part("landing", {"landing"}) + ", " +
         part("map", {"cells", "caustic_cells", "caustic_footprints", "caustic_map"}) + ", all passes " +
         duration_text(all) + " (" + significant(1e3 / all, 3) + " fps)";
}

}  // namespace

Row dynamic_row() {
  const Options small{"-r", "160x90", "--grid", "128", "--map", "128", "--fps", "1", "-D", "shadow=512"};
  const auto frames = [&](const std::string& name, const std::string& which) {
    Shot shot{name, "moving_lens.glb", small, "caustic"};
    shot.options.insert(shot.options.end(), {"--frames", which});
    return shot;
  };
  return {"11",
          "nothing precomputed; light, casters and receivers move",
          {frames("row_of_frames", "1..3"), frames("alone", "3..3")},
          "",
          "a frame within a row of frames and alone are equal to the bit, and differ from the one before",
          [](const Shots& s) -> Finding {
            const FloorLayer within = s.layer("row_of_frames.0003", "caustic"),
                             alone = s.layer("alone.0003", "caustic");
            const FloorLayer before = s.layer("row_of_frames.0002", "caustic");
            return {within.pixels == alone.pixels && within.pixels != before.pixels,
                    within.pixels == alone.pixels ? "equal" : "they differ"};
          }};
}

Row composition_row() {
  return {"12",
          "fits any renderer, and restricts no shadow",
          {{"layers",
            "glass_sphere.glb",
            {"-r", "512x512", "--camera", "floor", "-D", "highlights=off", "-D", "ambient.occlusion=off",
             "-D", "further.share=1", "-D", "cascades=off"},
            "beauty,direct,caustic"},
           floor_shot("preset_512", "glass_sphere.glb", {"--preset", "paper", "--grid", "512"})},
          "layers",
          "the picture is albedo / pi times direct light and caustic, and an even sky: 1e-5; the direct "
          "light is the "
          "same to the bit whatever the caustic, in maps as fine",
          [](const Shots& s) -> Finding {
            const FloorLayer beauty = s.layer("layers", "beauty"), direct = s.layer("layers", "direct");
            const FloorLayer caustic = s.layer("layers", "caustic"), other = s.layer("preset_512", "direct");
            const std::array<double, 3> albedo{0.80, 0.72, 0.62};
            std::vector<double> skies;
            double largest = 0.0;
            for (std::size_t i = 0; i < beauty.pixels.size(); ++i)
              for (std::size_t c = 0; c < 3; ++c) {
                const double k = albedo[c] / 3.14159265358979;
                const double lit = direct.pixels[i][c] + caustic.pixels[i][c];
                skies.push_back((beauty.pixels[i][c] - k * lit) / k);
                largest = std::max(largest, lit);
              }
            const auto [least, most] = std::minmax_element(skies.begin(), skies.end());
            const double uneven = *most - *least;
            const bool same = direct.pixels == other.pixels;
            return {uneven < 1e-5 * largest && same,
                    "the rest is even to " + significant(uneven / largest, 2) +
                        " of the brightest pixel; direct light " + (same ? "the same" : "differs")};
          }};
}

Row shadow_row() {
  return {
      "19",
      "the optional shadow map",
      {floor_shot("sphere_floor", "glass_sphere.glb")},
      "",
      "no direct light within the sphere's shadow, all of it outside, but for 5 mm at its edge",
      [](const Shots& s) -> Finding {
        const FloorLayer direct = s.layer("sphere_floor", "direct");
        std::size_t wrong = 0, judged = 0;
        for (int y = 0; y < direct.height; ++y)
          for (int x = 0; x < direct.width; ++x) {
            const double r =
                std::hypot((x + 0.5) / direct.width * 2.0 - 1.0, (y + 0.5) / direct.height * 2.0 - 1.0);
            if (std::fabs(r - kSphere.radius) < 0.005) continue;
            const double expected = r < kSphere.radius ? 0.0 : 1.0;
            ++judged;
            wrong += std::fabs(direct.at(x, y)[1] - expected) < 1e-5 ? 0 : 1;
          }
        return {wrong == 0, std::to_string(wrong) + " of " + std::to_string(judged) + " pixels are wrong"};
      }};
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

Row times_row() {
  Shot on_gl{"preset_gl", "glass_sphere.glb", {"-r", "960x540", "--preset", "paper", "--backend", "gl"}};
  on_gl.on_gl = true;
  return {"23, 34",
          "what a frame costs, 245 fps in the paper (GeForce 7800); V anew every frame at negligible cost",
          {{"sphere", "glass_sphere.glb", {"-r", "960x540"}},
           {"preset_view", "glass_sphere.glb", {"-r", "960x540", "--preset", "paper"}},
           on_gl},
          "preset_view",
          "V takes less than a twentieth of the preset's frame",
          [](const Shots& s) -> Finding {
            std::string text = "preset paper, software: " + parts(s, "preset_view") + "; ";
            text += s.taken("preset_gl") ? "OpenGL, " + s.stats("preset_gl").at("device").get<std::string>() +
                                               ": " + parts(s, "preset_gl")
                                         : "OpenGL is not there";
            text += "; defaults, software: " + parts(s, "sphere");
            const double all = s.stats("preset_view").at("milliseconds").at("passes");
            return {s.milliseconds("preset_view", {"caster_flux"}) < 0.05 * all, text};
          }};
}

Row offline_row() {
  return {"37",
          "comparable to off-line rendering, the processor left free",
          {traced_floor("sphere_traced", "glass_sphere.glb"), floor_shot("sphere_floor", "glass_sphere.glb")},
          "",
          "the defaults within 5 % of traced light (its noise included), in less time",
          [](const Shots& s) -> Finding {
            const double error = s.relative_l1("sphere_floor", "sphere_traced", "caustic");
            const auto total = [&](const char* name) {
              return s.stats(name).at("milliseconds").at("total").get<double>();
            };
            const auto& times = s.stats("sphere_floor").at("milliseconds");
            return {error < 0.05 && total("sphere_floor") < total("sphere_traced"),
                    "relative L1 " + percent(error) + " in " + duration_text(times.at("passes")) +
                        " of passes; traced in " + duration_text(total("sphere_traced")) +
                        "; no work for each vertex outside the passes, which OpenGL runs as they are"};
          }};
}
}  // namespace caustics::paper
