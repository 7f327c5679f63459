// The scatter plot of a study as inline SVG: error over time, both logarithmic.
#pragma once
#include <string>
#include <vector>

namespace caustics::study {

struct PlotPoint {
  double x = 0.0, y = 0.0;             // above 0
  double x_least = 0.0, x_most = 0.0;  // a bar; above 0
  std::size_t group = 0;               // into Plot::groups: shape and colour
  bool hollow = false;                 // of the second backend
  std::string title;                   // what a pointer that rests on it says
  std::string label;                   // beside it; "" for none
};

// Points that nothing beats, joined from the quickest to the most accurate.
struct PlotFront {
  std::string name;
  bool dashed = false;
  std::vector<std::size_t> points;
};

struct Plot {
  std::string title{}, x_name{}, y_name{};
  std::vector<std::string> groups{};  // names, for the legend
  std::vector<PlotPoint> points{};
  std::vector<PlotFront> fronts{};
  double floor = 0.0;  // a level line, where it is above 0
  std::string floor_name{};
};

// Up to this many groups have a shape and a colour of their own; more take turns.
inline constexpr std::size_t kPlotShapes = 8;

// One <svg> element of 960 units width; colours are CSS variables --g0 .. --g7, --ink, --soft, --front. A
// paragraph instead where there is no point.
std::string draw(const Plot& plot);

// Where a logarithmic axis has its marks, 1, 2 and 5 of every power of ten, or the powers alone where
// there are more than three of them; at least from the first mark below to the first above.
std::vector<double> log_marks(double least, double most);

}  // namespace caustics::study
