#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>

#include "lab/paper/row.hpp"
#include "lab/reference/closed_forms.hpp"
#include "tests/support/catch.hpp"

using namespace caustics::paper;

namespace {

using Json = nlohmann::ordered_json;

Row row_of(const std::string& id) {
  for (Row& row : paper_rows())
    if (row.id == id) return std::move(row);
  throw std::out_of_range(id);
}

FloorLayer floor_of(int width, int height, const std::array<double, 3>& color = {}) {
  return {width, height, std::vector(static_cast<std::size_t>(width * height), color)};
}

// What a test states in place of pictures: the same of all shots, but where it says otherwise. A check may
// ask a shot for what it was taken with, and for nothing else.
class StatedShots : public Shots {
 public:
  explicit StatedShots(const Row& row) : row_(row) {}

  FloorLayer& state(const std::string& name, const std::string& layer) { return layers_[{name, layer}]; }
  Texels& state_texels(const std::string& name, const std::string& attachment) {
    return texels_[{name, attachment}];
  }
  // The names of those that were asked for anything.
  const std::set<std::string>& used() const { return used_; }
  const std::set<std::string>& drawn() const { return drawn_; }

  const Json& stats(const std::string& name) const override {
    shot(name);
    static const Json json = [] {
      Json flux = {{"residual", 0.0}};
      for (const char* account : {"entered", "landed", "in_map", "outside", "fresnel", "absorbed", "medium",
                                  "kernel_edge", "not_converged"})
        flux[account] = {1.0, 1.0, 1.0};
      return Json{{"device", "none"},
                  {"milliseconds", {{"passes", 1.0}, {"total", 2.0}}},
                  {"passes", Json::array()},
                  {"lights", {{{"flux", flux}}, {{"flux", flux}}}}};
    }();
    return json;
  }
  FloorLayer layer(const std::string& name, const std::string& layer) const override {
    const Shot& taken = shot(name);
    INFO(name << " " << layer);
    const bool listed = ("," + taken.layers + ",").find("," + layer + ",") != std::string::npos;
    CHECK((listed || layer == "beauty" || (taken.traced && layer == "caustic")));
    const auto stated = layers_.find({name, layer});
    return stated == layers_.end() ? floor_of(4, 4, {1.0, 1.0, 1.0}) : stated->second;
  }
  Texels attachment(const std::string& name, const std::string& attachment) const override {
    INFO(name);
    CHECK(shot(name).dumped);
    const auto stated = texels_.find({name, attachment});
    if (stated != texels_.end()) return stated->second;
    return {2, 2, std::vector<std::array<double, 4>>(4, {1.0, 1.0, 1.0, 1.0})};
  }
  bool taken(const std::string& name) const override {
    CHECK(shot(name).on_gl);
    return true;
  }
  void draw_side_by_side(const std::vector<std::string>& tested, const std::string& truth,
                         const std::string& wanted, const std::string& name) const override {
    for (const std::string& each : tested) layer(each, wanted);
    layer(truth, wanted);
    drawn_.insert(name);
  }

 private:
  // "lens.0002": a frame of a shot of several.
  const Shot& shot(const std::string& name) const {
    const std::string whole = name.substr(0, name.find('.'));
    for (const Shot& each : row_.shots)
      if (each.name == whole) {
        used_.insert(whole);
        return each;
      }
    throw std::out_of_range("row " + row_.id + " has no shot " + name);
  }

  const Row& row_;
  std::map<std::pair<std::string, std::string>, FloorLayer> layers_;
  std::map<std::pair<std::string, std::string>, Texels> texels_;
  mutable std::set<std::string> used_, drawn_;
};

std::string last_of(const Options& options, const std::string& key) {
  const auto found = std::find(options.rbegin(), options.rend(), key);
  return found == options.rend() ? "" : *(found - 1);
}

}  // namespace

TEST_CASE("paper rows: each of the paper's 39 things has one row, with what is expected of it") {
  std::multiset<int> found;
  for (const Row& row : paper_rows()) {
    std::istringstream numbers(row.id);
    for (std::string number; std::getline(numbers, number, ',');) found.insert(std::stoi(number));
    INFO(row.id);
    CHECK_FALSE(row.expected.empty());
    CHECK(row.check);
  }
  std::vector<int> all(39);
  std::iota(all.begin(), all.end(), 1);
  CHECK(std::vector<int>(found.begin(), found.end()) == all);
}

TEST_CASE("paper rows: shots of one name are one shot") {
  std::map<std::string, Shot> shots;
  for (const Row& row : paper_rows())
    for (const Shot& shot : row.shots) {
      const Shot& first = shots.try_emplace(shot.name, shot).first->second;
      INFO(shot.name);
      CHECK(first.scene == shot.scene);
      CHECK(first.options == shot.options);
      CHECK(first.layers == shot.layers);
    }
}

TEST_CASE(
    "paper rows: a check asks shots for what they are taken with, and each shot is there for something") {
  for (const Row& row : paper_rows()) {
    INFO(row.id);
    const StatedShots shots(row);
    CHECK_FALSE(row.check(shots).figure.empty());
    const bool shows_a_shot = std::any_of(row.shots.begin(), row.shots.end(),
                                          [&](const Shot& shot) { return shot.name == row.picture; });
    CHECK((row.picture.empty() || shows_a_shot || shots.drawn().count(row.picture) > 0));
    for (const Shot& shot : row.shots) {
      INFO(shot.name);
      CHECK((shots.used().count(shot.name) > 0 || shot.name == row.picture));
    }
  }
}

TEST_CASE("paper rows: grid vertices of one row's shots are the same ones") {
  for (const Row& row : paper_rows()) {
    std::set<std::string> sides;
    for (const Shot& shot : row.shots)
      if (shot.dumped) sides.insert({last_of(shot.options, "--grid"), last_of(shot.options, "--map")});
    INFO(row.id);
    CHECK(sides.size() <= 1);
  }
}

TEST_CASE("paper rows: a ring's light counts inside it and outside it, and not beneath it") {
  const Row row = row_of("9");
  StatedShots shots(row);
  FloorLayer& caustic = shots.state("ring_floor", "caustic") = floor_of(20, 40);
  // In the column just right of the middle: 0.056, 0.527 and 0.577 m from it.
  const auto shine = [&](std::size_t line, double red) {
    caustic.pixels[20 * line + 10] = {red, 0.5 * red, 0.25 * red};
  };
  shine(20, 3.0);
  shine(30, 5.0);
  CHECK_FALSE(row.check(shots).holds);
  shine(31, 1.0);
  CHECK(row.check(shots).holds);
  CHECK(row.check(shots).figure.find("25.0% lies outside; green and blue are 0.5 and 0.25 of red") !=
        std::string::npos);
  shine(20, 0.0);
  CHECK_FALSE(row.check(shots).holds);
  shine(20, 3.0);
  for (auto& pixel : caustic.pixels) std::swap(pixel[0], pixel[1]);
  CHECK_FALSE(row.check(shots).holds);
}

TEST_CASE("paper rows: every pixel of the floor below a ring counts, those at its border like the others") {
  const Row row = row_of("9");
  constexpr int width = 4, height = 6;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      // A pixel as red as the one in the middle, without its green and blue: both ratios are halved.
      StatedShots shots(row);
      FloorLayer& caustic = shots.state("ring_floor", "caustic") = floor_of(width, height);
      caustic.pixels[width * 3 + 2] = {2.0, 1.0, 0.5};
      caustic.pixels[static_cast<std::size_t>(width * y + x)][0] += 2.0;
      const double px = (2 * x + 1 - width) / double(width), py = (2 * y + 1 - height) / double(height);
      const bool outside = std::hypot(px, py) > 0.55;
      // The ring's own wall is 0.49 to 0.55 m from the middle, and no pixel's middle lies there.
      REQUIRE((outside || std::hypot(px, py) < 0.49));
      const Finding finding = row.check(shots);
      INFO(x << " " << y);
      CHECK(finding.holds == outside);
      CHECK(finding.figure == std::string("of the light on the floor in view ") +
                                  (outside ? "50.0%" : "0.0%") +
                                  " lies outside; green and blue are 0.25 and 0.125 of red");
    }
}

TEST_CASE("paper rows: how even a sky must be goes by the brightest pixel, whatever light lies before it") {
  const Row row = row_of("12");
  const std::array<double, 3> albedo{0.80, 0.72, 0.62};
  for (const double lux : {1e-3, 1.0, 1e3})
    for (const double uneven : {0.5e-5, 2e-5}) {
      StatedShots shots(row);
      FloorLayer& direct = shots.state("layers", "direct") = floor_of(4, 1);
      FloorLayer& caustic = shots.state("layers", "caustic") = floor_of(4, 1);
      FloorLayer& beauty = shots.state("layers", "beauty") = floor_of(4, 1);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
          direct.pixels[i][c] = lux * static_cast<double>(i + c) / 10.0;
          caustic.pixels[i][c] = lux * static_cast<double>((3 - i) * (3 - i)) / 9.0;
          const double sky = lux * (0.3 + (i == 1 && c == 2 ? uneven : 0.0));
          beauty.pixels[i][c] =
              albedo[c] / std::numbers::pi * (direct.pixels[i][c] + caustic.pixels[i][c] + sky);
        }
      shots.state("preset_512", "direct") = direct;
      INFO(lux << " " << uneven);
      CHECK(row.check(shots).holds == (uneven < 1e-5));
      shots.state("preset_512", "direct").pixels[1][1] *= 1.0 + 1e-12;
      CHECK_FALSE(row.check(shots).holds);
    }
}

TEST_CASE("paper rows: nothing is precomputed if a frame alone is that of a row, and another than before") {
  const Row row = row_of("11");
  for (const bool same : {false, true})
    for (const bool moved : {false, true}) {
      StatedShots shots(row);
      shots.state("row_of_frames.0003", "caustic") = floor_of(2, 1, {2.0, 2.0, 2.0});
      shots.state("alone.0003", "caustic") = floor_of(2, 1, {2.0, 2.0, same ? 2.0 : 2.5});
      shots.state("row_of_frames.0002", "caustic") = floor_of(2, 1, {2.0, moved ? 1.5 : 2.0, 2.0});
      const Finding finding = row.check(shots);
      INFO(same << " " << moved);
      CHECK(finding.holds == (same && moved));
      CHECK(finding.figure == (same ? "equal" : "they differ"));
    }
}

TEST_CASE("paper rows: tessellation and grid are told with the errors of their own pictures") {
  const Row row = row_of("27");
  const caustics::GlassSphere sphere{.radius = 0.5, .index = 1.5, .distance = 0.8};
  constexpr int side = 32;
  const caustics::FloorIrradiance truth =
      irradiance_average(sphere, {.lower = glm::dvec2(-1.0), .side = 2.0, .pixels = side});
  // All of a truth times 1 + e is wrong by e; beside the shadow, where nothing is judged, it is dark here.
  const auto finding = [&](double fine, double coarse, double half) {
    StatedShots shots(row);
    const auto state = [&](const std::string& name, double error) {
      shots.state(name, "direct") = floor_of(side, side);
      FloorLayer& caustic = shots.state(name, "caustic") = floor_of(side, side);
      for (std::size_t i = 0; i < caustic.pixels.size(); ++i)
        caustic.pixels[i].fill((1.0 + error) * truth.values[i]);
    };
    state("grid_128", fine);
    state("coarse_128", coarse);
    state("grid_64", half);
    return row.check(shots);
  };
  const Finding holds = finding(0.02, 0.03, 0.25);
  CHECK(holds.holds);
  CHECK(holds.figure == "relative L1, grid 128: 20 480 triangles 2.0%, 1 280 3.0%; grid 64: 25.0%");
  CHECK_FALSE(finding(0.02, 0.25, 0.03).holds);
}

TEST_CASE("paper rows: refraction and reflection are told with the mean distances of their landings") {
  const Row row = row_of("28");
  const auto finding = [&](const std::vector<double>& water, const std::vector<double>& ring) {
    StatedShots shots(row);
    const auto state = [&](const std::string& scene, const std::vector<double>& apart) {
      for (const bool paper : {false, true}) {
        Texels& texels = shots.state_texels(scene + (paper ? "_paper" : "_secant"), "landing[0]");
        texels = {static_cast<int>(apart.size()), 1, {}};
        for (const double distance : apart) texels.values.push_back({0.0, paper ? distance : 0.0, 0.0, 1.0});
      }
    };
    state("water_patch", water);
    state("metal_ring", ring);
    return row.check(shots);
  };
  const Finding holds = finding({0.001, 0.003}, {0.002, 0.004, 0.009});
  CHECK(holds.holds);
  CHECK(holds.figure == "mean distance of landings: water 2 mm, ring 5 mm");
  CHECK_FALSE(finding({0.002, 0.004, 0.009}, {0.001, 0.003}).holds);
  // Of none that has landed the mean is 0, not a number that is none.
  CHECK(finding({}, {0.007}).figure == "mean distance of landings: water 0 mm, ring 7 mm");
}
