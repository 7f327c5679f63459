#include "lab/study/plot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/study/html.hpp"
#include "lab/study/sentence.hpp"

namespace caustics::study {

namespace {

constexpr double kWidth = 960.0, kHeight = 560.0;
constexpr double kLeft = 84.0, kRight = 24.0, kTop = 20.0, kBottom = 58.0;
constexpr double kLegendRow = 22.0, kMark = 6.5, kLetter = 7.0, kLine = 15.0;

// A logarithmic axis between two marks.
struct Axis {
  Axis(double least, double most, double from, double to)
      : marks(log_marks(least, most)), from(from), to(to) {}
  double at(double value) const {
    const double low = std::log(marks.front()), high = std::log(marks.back());
    return from + (to - from) * (std::log(value) - low) / (high - low);
  }
  std::vector<double> marks;
  double from, to;
};

std::string text_at(double x, double y, const std::string& anchor, const std::string& text,
                    const std::string& more = "") {
  return "<text x=\"" + length_text(x) + "\" y=\"" + length_text(y) + "\" text-anchor=\"" + anchor + "\"" +
         more + ">" + escaped(text) + "</text>\n";
}

std::string line_from(double x1, double y1, double x2, double y2, const std::string& kind) {
  return "<line class=\"" + kind + "\" x1=\"" + length_text(x1) + "\" y1=\"" + length_text(y1) + "\" x2=\"" +
         length_text(x2) + "\" y2=\"" + length_text(y2) + "\"/>\n";
}

// "M1.00 2.00"
void move_to(std::string& path, char how, double x, double y) {
  path.append(1, how).append(length_text(x)).append(1, ' ').append(length_text(y));
}

// A star or polygon: every second corner at `inner` of the radius.
std::string corners(double x, double y, int count, double inner, double turn) {
  std::string path;
  for (int i = 0; i < count; ++i) {
    const double angle = (turn + 360.0 * i / count) * std::numbers::pi / 180.0;
    const double radius = kMark * (i % 2 ? inner : 1.0) * 1.15;
    move_to(path, i ? 'L' : 'M', x + radius * std::sin(angle), y - radius * std::cos(angle));
  }
  return path + "Z";
}

// A plus with thick arms.
std::string plus(double x, double y, double turn) {
  constexpr double kThick = kMark / 3.0, kLong = kMark * 1.1;
  constexpr std::pair<double, double> kArm[] = {{kThick, kThick}, {kThick, kLong}, {-kThick, kLong}};
  std::string path;
  for (int arm = 0; arm < 4; ++arm) {
    const double angle = (turn + 90.0 * arm) * std::numbers::pi / 180.0, c = std::cos(angle),
                 s = std::sin(angle);
    for (const auto& [across, along] : kArm)
      move_to(path, path.empty() ? 'M' : 'L', x + c * across - s * along, y + s * across + c * along);
  }
  return path + "Z";
}

std::string outline(std::size_t shape, double x, double y) {
  switch (shape % kPlotShapes) {
    case 0:
      return corners(x, y, 24, 1.0, 0.0);  // about a circle
    case 1:
      return corners(x, y, 4, 1.0, 45.0);  // square
    case 2:
      return corners(x, y, 3, 1.0, 0.0);  // triangle
    case 3:
      return corners(x, y, 4, 1.0, 0.0);  // diamond
    case 4:
      return corners(x, y, 3, 1.0, 180.0);  // triangle on its tip
    case 5:
      return corners(x, y, 10, 0.45, 0.0);  // star
    case 6:
      return plus(x, y, 0.0);
    default:
      return plus(x, y, 45.0);
  }
}

std::string shape_at(std::size_t group, bool hollow, double x, double y, const std::string& title) {
  const std::string number = std::to_string(group % kPlotShapes);
  std::string text =
      "<path class=\"mark g" + number + (hollow ? " hollow" : "") + "\" d=\"" + outline(group, x, y) + "\"";
  if (title.empty()) return text + "/>\n";
  return text + "><title>" + escaped(title) + "</title></path>\n";
}

struct Box {
  double left, top, right, bottom;
  bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

class Drawing {
 public:
  explicit Drawing(const Plot& plot)
      : plot_(plot),
        x_(least_x(), most_x(), kLeft, kWidth - kRight),
        y_(least_y(), most_y(), kHeight - kBottom, kTop) {}

  std::string text() {
    std::string svg = "<svg viewBox=\"0 0 " + length_text(kWidth) + " " +
                      length_text(kHeight + kLegendRow * static_cast<double>(legend_rows())) +
                      "\" role=\"img\" aria-label=\"" + escaped(plot_.title) +
                      "\" xmlns=\"http://www.w3.org/2000/svg\">\n";
    svg += axes() + floor_line() + fronts();
    for (const PlotPoint& point : plot_.points) svg += mark(point);
    svg += labels() + legend();
    return svg + "</svg>\n";
  }

 private:
  template <class Value>
  double extreme(bool most, const Value& value) const {
    double result = value(plot_.points.front());
    for (const PlotPoint& p : plot_.points)
      result = most ? std::max(result, value(p)) : std::min(result, value(p));
    return result;
  }
  double least_x() const {
    return extreme(false, [](const PlotPoint& p) { return p.x_least; });
  }
  double most_x() const {
    return extreme(true, [](const PlotPoint& p) { return p.x_most; });
  }
  double least_y() const {
    const double least = extreme(false, [](const PlotPoint& p) { return p.y; });
    return plot_.floor > 0.0 ? std::min(least, plot_.floor) : least;
  }
  double most_y() const {
    return extreme(true, [](const PlotPoint& p) { return p.y; });
  }

  std::string axes() const {
    std::string svg;
    for (const double mark : x_.marks) {
      svg += line_from(x_.at(mark), kTop, x_.at(mark), kHeight - kBottom, "gridline");
      svg += text_at(x_.at(mark), kHeight - kBottom + 18.0, "middle", short_number(mark));
    }
    for (const double mark : y_.marks) {
      svg += line_from(kLeft, y_.at(mark), kWidth - kRight, y_.at(mark), "gridline");
      svg += text_at(kLeft - 8.0, y_.at(mark) + 4.0, "end", short_number(mark));
    }
    svg += text_at(0.5 * (kLeft + kWidth - kRight), kHeight - kBottom + 42.0, "middle", plot_.x_name);
    const double middle = 0.5 * (kTop + kHeight - kBottom);
    return svg + text_at(18.0, middle, "middle", plot_.y_name,
                         " transform=\"rotate(-90 18 " + length_text(middle) + ")\"");
  }

  std::string floor_line() {
    if (!(plot_.floor > 0.0)) return {};
    const double y = y_.at(plot_.floor);
    taken_.push_back({kLeft, y - kLine, kLeft + kLetter * static_cast<double>(plot_.floor_name.size()), y});
    return line_from(kLeft, y, kWidth - kRight, y, "floor") +
           text_at(kLeft + 6.0, y - 5.0, "start", plot_.floor_name);
  }

  // Steps: what one gets within a time is the best of what is quicker.
  std::string fronts() {
    std::string svg;
    for (const PlotFront& front : plot_.fronts) {
      if (front.points.empty()) continue;
      std::string path;
      const PlotPoint* last = nullptr;
      for (const std::size_t i : front.points) {
        const PlotPoint& p = plot_.points[i];
        if (last) keep_clear(*last, p);
        last = &p;
        const std::string x = length_text(x_.at(p.x)), y = length_text(y_.at(p.y));
        const bool first = path.empty();
        path.append(first ? "M" : "H").append(x).append(first ? " " : "V").append(y);
      }
      svg += "<path class=\"front" + std::string(front.dashed ? " dashed" : "") + "\" d=\"" + path +
             "\"><title>" + escaped(front.name) + "</title></path>\n";
    }
    return svg;
  }

  // No label stands on a front's line.
  void keep_clear(const PlotPoint& from, const PlotPoint& to) {
    const double x1 = x_.at(from.x), y1 = y_.at(from.y), x2 = x_.at(to.x), y2 = y_.at(to.y);
    taken_.push_back({x1, y1 - 1.0, x2, y1 + 1.0});
    taken_.push_back({x2 - 1.0, y1, x2 + 1.0, y2});
  }

  std::string mark(const PlotPoint& p) {
    const double x = x_.at(p.x), y = y_.at(p.y);
    taken_.push_back({x - kMark, y - kMark, x + kMark, y + kMark});
    return line_from(x_.at(p.x_least), y, x_.at(p.x_most), y,
                     "spread g" + std::to_string(p.group % kPlotShapes)) +
           shape_at(p.group, p.hollow, x, y, p.title);
  }

  // Beside its point, where nothing stands yet; a bit farther away where it must, and then with a line.
  std::string labels() {
    std::string svg;
    for (const PlotPoint& p : plot_.points)
      if (!p.label.empty()) svg += label(p);
    return svg;
  }

  std::string label(const PlotPoint& p) {
    const double x = x_.at(p.x), y = y_.at(p.y), wide = kLetter * static_cast<double>(p.label.size());
    for (const double away : {10.0, 24.0, 40.0, 58.0, 78.0, 100.0}) {
      for (const auto& [dx, dy] : {std::pair{1.0, -0.8},
                                   {0.2, -1.1},
                                   {-1.0, 1.0},
                                   {1.0, 1.3},
                                   {-1.0, 0.0},
                                   {-1.0, -0.8},
                                   {-0.2, 1.5}}) {
        const double left = dx > 0.0 ? x + dx * away : x + dx * away - wide, base = y + dy * away + 4.0;
        const Box box{left - 2.0, base - kLine + 3.0, left + wide + 2.0, base + 4.0};
        if (box.left < kLeft || box.right > kWidth - kRight || box.top < kTop ||
            box.bottom > kHeight - kBottom)
          continue;
        if (std::any_of(taken_.begin(), taken_.end(), [&](const Box& other) { return box.meets(other); }))
          continue;
        taken_.push_back(box);
        const double end = dx > 0.0 ? left - 1.0 : left + wide + 1.0;
        return (away > 10.0 ? line_from(x, y, end, base - 4.0, "leader") : "") +
               text_at(left, base, "start", p.label, " class=\"label\"");
      }
    }
    return {};  // no room: the table has it
  }

  std::size_t legend_rows() const { return (plot_.groups.size() + plot_.fronts.size() + 2) / 3; }

  std::string legend() const {
    std::string svg;
    std::size_t entry = 0;
    const auto place = [&] {
      const double x = kLeft + 290.0 * static_cast<double>(entry % 3);
      const std::size_t line = entry / 3;
      const double y = kHeight + kLegendRow * (static_cast<double>(line) + 0.5);
      ++entry;
      return std::pair{x, y};
    };
    for (std::size_t g = 0; g < plot_.groups.size(); ++g) {
      const auto [x, y] = place();
      svg += shape_at(g, false, x + 10.0, y, "") + text_at(x + 26.0, y + 4.0, "start", plot_.groups[g]);
    }
    for (const PlotFront& front : plot_.fronts) {
      const auto [x, y] = place();
      svg += line_from(x, y, x + 20.0, y, front.dashed ? "front dashed" : "front") +
             text_at(x + 26.0, y + 4.0, "start", front.name);
    }
    return svg;
  }

  const Plot& plot_;
  Axis x_, y_;
  std::vector<Box> taken_;  // by marks and labels
};

}  // namespace

std::vector<double> log_marks(double least, double most) {
  const int low = static_cast<int>(std::floor(std::log10(least))),
            high = static_cast<int>(std::ceil(std::log10(most)));
  std::vector<double> marks;
  for (int power = low; power <= std::max(high, low + 1); ++power)
    for (const double step : {1.0, 2.0, 5.0})
      if (step == 1.0 || high - low <= 3) marks.push_back(step * std::pow(10.0, power));
  while (marks.size() > 2 && marks[1] <= least) marks.erase(marks.begin());
  while (marks.size() > 2 && marks[marks.size() - 2] >= most) marks.pop_back();
  return marks;
}

std::string draw(const Plot& plot) {
  if (plot.points.empty())
    return "<p>No row has both an error and a time above 0: there is nothing to plot.</p>\n";
  return Drawing(plot).text();
}

}  // namespace caustics::study
