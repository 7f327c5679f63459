#include "lab/study/plot.hpp"

#include "lab/study/difference_picture.hpp"
#include "lab/study/html.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::study;

namespace {

void check_marks(double least, double most, const std::vector<double>& expected) {
  const std::vector<double> marks = log_marks(least, most);
  REQUIRE(marks.size() == expected.size());
  for (std::size_t i = 0; i < marks.size(); ++i) CHECK(marks[i] == Approx(expected[i]));
}

}  // namespace

TEST_CASE("study plot: marks reach from below the least to above the most") {
  check_marks(3.0, 40.0, {2.0, 5.0, 10.0, 20.0, 50.0});
  check_marks(10.0, 10.0, {10.0, 20.0});
  check_marks(0.002, 700.0, {0.001, 0.01, 0.1, 1.0, 10.0, 100.0, 1000.0});
}

TEST_CASE("study plot: names are escaped and every point has its words") {
  Plot plot{.title = "a < b", .groups = {"grid & map"}};
  plot.points.push_back({10.0, 0.1, 9.0, 12.0, 0, false, "\"one\"", "first"});
  plot.fronts.push_back({"front", false, {0}});
  const std::string svg = draw(plot);
  CHECK(svg.find("a &lt; b") != std::string::npos);
  CHECK(svg.find("grid &amp; map") != std::string::npos);
  CHECK(svg.find("<title>&quot;one&quot;</title>") != std::string::npos);
  CHECK(svg.find(">first</text>") != std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
}

TEST_CASE("study plot: without points it is a sentence") { CHECK(draw(Plot{}).rfind("<p>", 0) == 0); }

TEST_CASE("study pages: text cannot break out of its place") {
  CHECK(escaped("a<b>&\"'\n") == "a&lt;b&gt;&amp;&quot;&#39;\\x0a");
  CHECK(length_text(1.005e3) == "1005.00");
  CHECK(png_address("/nonexistent.png").empty());
}

TEST_CASE("study pictures: orange is more, blue is less, a tenth is two thirds of the colour") {
  Image tested(Format::RGBA32F, 4, 1), truth(Format::RGBA32F, 4, 1);
  for (int c = 0; c < 3; ++c) {
    truth.at(0, 0, c) = truth.at(1, 0, c) = truth.at(2, 0, c) = truth.at(3, 0, c) = 10.0f;
    tested.at(0, 0, c) = 10.0f;
    tested.at(1, 0, c) = 30.0f;
    tested.at(2, 0, c) = 0.0f;
    tested.at(3, 0, c) = 11.0f;
  }
  const Image picture = difference_picture(tested, truth, 10.0);
  CHECK(picture.at(0, 0, 0) == 0.0f);
  CHECK(picture.at(0, 0, 2) == 0.0f);
  CHECK(picture.at(1, 0, 0) > picture.at(1, 0, 2));
  CHECK(picture.at(2, 0, 0) < picture.at(2, 0, 2));
  CHECK(picture.at(3, 0, 0) == Approx(picture.at(1, 0, 0) * 2.0 / 3.0));
}

TEST_CASE("study pictures: the channel that differs most is shown with its sign") {
  Image tested(Format::RGBA32F, 1, 1), truth(Format::RGBA32F, 1, 1);
  tested.at(0, 0, 0) = 1.0f;
  truth.at(0, 0, 2) = 2.0f;  // blue lacks 2, red has 1 too much
  const Image picture = difference_picture(tested, truth, 1.0);
  CHECK(picture.at(0, 0, 2) > picture.at(0, 0, 0));
  tested.at(0, 0, 0) = 3.0f;
  const Image more = difference_picture(tested, truth, 1.0);
  CHECK(more.at(0, 0, 0) > more.at(0, 0, 2));
}

TEST_CASE("study pictures: large ones are averaged in boxes") {
  Image large(Format::RGBA32F, 641, 2);
  for (int x = 0; x < 641; ++x)
    for (int y = 0; y < 2; ++y) large.at(x, y, 0) = static_cast<float>(x);
  const Image small = small_picture(large);
  // Boxes of three texels a side.
  CHECK(small.width() == 214);
  CHECK(small.height() == 1);
  CHECK(small.at(0, 0, 0) == 1.0f);
  CHECK(small.at(213, 0, 0) == 639.5f);
}
