#include "lab/study/plot.hpp"

#include <algorithm>
#include <cmath>

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

// The elements whose tag holds `what`, in order.
std::vector<std::string> tags(const std::string& svg, const std::string& what) {
  std::vector<std::string> found;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::string tag = svg.substr(at, svg.find('>', at) - at);
    if (tag.find(what) != std::string::npos) found.push_back(tag);
  }
  return found;
}

double number(const std::string& tag, const std::string& attribute) {
  return std::stod(tag.substr(tag.find(" " + attribute + "=\"") + attribute.size() + 3));
}

// Where a label of two letters is drawn, and the point that it belongs to: its bar begins there.
struct Placed {
  double x, y, point_x, point_y;
};

std::vector<Placed> placed_labels(const std::string& svg) {
  const auto labels = tags(svg, "class=\"label\""), bars = tags(svg, "class=\"spread");
  REQUIRE(labels.size() == bars.size());
  std::vector<Placed> placed;
  for (std::size_t i = 0; i < labels.size(); ++i)
    placed.push_back(
        {number(labels[i], "x"), number(labels[i], "y"), number(bars[i], "x1"), number(bars[i], "y1")});
  return placed;
}

Plot labelled(const std::vector<std::pair<double, double>>& points) {
  Plot plot{.groups = {"group"}};
  for (const auto& [x, y] : points)
    plot.points.push_back({.x = x, .y = y, .x_least = x, .x_most = x, .title = {}, .label = "No"});
  return plot;
}

}  // namespace

TEST_CASE(
    "study plot: a label stands beside its point, and marks are full unless they are said to be hollow") {
  Plot plot = labelled({{3.0, 0.2}});
  const Placed one = placed_labels(draw(plot)).at(0);
  CHECK(one.x - one.point_x == Approx(10.0));
  CHECK(one.y - one.point_y == Approx(-4.0));
  CHECK(tags(draw(plot), "leader").empty());
  CHECK(tags(draw(plot), "hollow").empty());
  plot.points[0].hollow = true;
  CHECK(tags(draw(plot), "hollow").size() == 1);
}

TEST_CASE(
    "study plot: labels of a crowd cover no point and no other label, and lines lead to those far off") {
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < 16; ++i) points.push_back({3.0 + 0.02 * (i % 4), 0.2 + 0.002 * i});
  const std::string svg = draw(labelled(points));
  const std::vector<Placed> placed = placed_labels(svg);
  // Two letters are 14 units wide, and reach from 11 units above their line to 3 below it.
  std::size_t far = 0;
  for (const Placed& a : placed) {
    CHECK((a.x > 84.0 && a.x + 14.0 < 936.0 && a.y > 31.0 && a.y < 502.0));
    for (const Placed& b : placed) {
      CHECK((b.point_x < a.x || b.point_x > a.x + 14.0 || b.point_y < a.y - 11.0 || b.point_y > a.y + 3.0));
      CHECK((&a == &b || std::fabs(a.x - b.x) > 14.0 || std::fabs(a.y - b.y) > 14.0));
    }
    const double away = std::max(std::fabs(a.x - a.point_x), std::fabs(a.y - a.point_y));
    if (away > 30.0) ++far;
  }
  CHECK(far > 0);
  const auto leaders = tags(svg, "leader");
  CHECK(leaders.size() >= far);
  for (const std::string& leader : leaders)
    CHECK(std::any_of(placed.begin(), placed.end(), [&](const Placed& a) {
      return a.point_x == number(leader, "x1") && a.point_y == number(leader, "y1");
    }));
}

TEST_CASE("study plot: marks reach from below the least to above the most") {
  check_marks(3.0, 40.0, {2.0, 5.0, 10.0, 20.0, 50.0});
  check_marks(10.0, 10.0, {10.0, 20.0});
  check_marks(0.002, 700.0, {0.001, 0.01, 0.1, 1.0, 10.0, 100.0, 1000.0});
}

TEST_CASE("study plot: every mark of both axes has its number and its line across the plot") {
  // From 3 to 40 the marks are 2, 5, 10, 20 and 50; from 0.01 to 0.03 they are 0.01, 0.02 and 0.05.
  const std::string svg = draw(labelled({{3.0, 0.011}, {40.0, 0.03}}));
  for (const char* mark : {"2", "5", "10", "20", "50", "0.01", "0.02", "0.05"}) {
    INFO(mark);
    CHECK(svg.find(">" + std::string(mark) + "</text>") != std::string::npos);
  }
  CHECK(tags(svg, "gridline").size() == 8);
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

TEST_CASE("study plot: a label stays within the plot at each of its four borders") {
  // Marks from 2 to 50 and from 0.01 to 0.05, the plot's corners: points close to them.
  const std::string svg =
      draw(labelled({{2.001, 0.01001}, {49.9, 0.01001}, {2.001, 0.0499}, {49.9, 0.0499}}));
  for (const Placed& label : placed_labels(svg)) {
    INFO(label.x << " " << label.y);
    CHECK((label.x >= 84.0 && label.x + 14.0 <= 936.0));
    CHECK((label.y >= 31.0 && label.y <= 502.0));
    CHECK(std::max(std::fabs(label.x - label.point_x), std::fabs(label.y - label.point_y)) < 30.0);
  }
}
