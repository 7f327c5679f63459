#include "lab/study/sweep.hpp"

#include <algorithm>
#include <functional>

namespace caustics::study {

namespace {

using Values = std::vector<std::string>;

std::size_t times(std::size_t a, std::size_t b, std::size_t limit) {
  return b != 0 && a > limit / b ? limit + 1 : a * b;
}

const Knob* find(const std::vector<Knob>& knobs, const std::string& key) {
  const auto found = std::find_if(knobs.begin(), knobs.end(), [&](const Knob& k) { return k.key == key; });
  return found == knobs.end() ? nullptr : &*found;
}

bool has_value(const Values& values, const std::string& value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

Values base_of(const std::vector<Knob>& knobs) {
  Values values;
  for (const Knob& knob : knobs) values.push_back(knob.base);
  return values;
}

void add(std::vector<Point>& points, Point point) {
  const auto same = [&](const Point& other) { return other.values == point.values; };
  if (std::none_of(points.begin(), points.end(), same)) points.push_back(std::move(point));
}

std::vector<Point> product(const std::vector<Knob>& knobs) {
  std::vector<Point> points{{{}, "all"}};
  for (const Knob& knob : knobs) {
    std::vector<Point> longer;
    for (const Point& point : points) {
      for (const std::string& value : knob.values) {
        longer.push_back(point);
        longer.back().values.push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

void add_grid_and_map(const std::vector<Knob>& knobs, std::vector<Point>& points) {
  const Knob *grid = find(knobs, "grid"), *map = find(knobs, "map");
  if (!grid || !map) return;
  for (const std::string& rays : grid->values) {
    for (const std::string& texels : map->values) {
      Point point{base_of(knobs), "grid, map"};
      point.values[static_cast<std::size_t>(grid - knobs.data())] = rays;
      point.values[static_cast<std::size_t>(map - knobs.data())] = texels;
      add(points, std::move(point));
    }
  }
}

}  // namespace

std::size_t count_points(const std::vector<Knob>& knobs, bool cross, std::size_t limit) {
  std::size_t count = 1;
  for (const Knob& knob : knobs) {
    count = cross ? times(count, knob.values.size(), limit) : std::min(count + knob.values.size(), limit + 1);
  }
  const Knob *grid = find(knobs, "grid"), *map = find(knobs, "map");
  if (cross || !grid || !map) return count;
  return std::min(count + times(grid->values.size(), map->values.size(), limit), limit + 1);
}

std::vector<Point> expand(const std::vector<Knob>& knobs, bool cross) {
  if (cross) return product(knobs);
  std::vector<Point> points{{base_of(knobs), "base"}};
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    for (const std::string& value : knobs[k].values) {
      Point point{base_of(knobs), knobs[k].key};
      point.values[k] = value;
      add(points, std::move(point));
    }
  }
  add_grid_and_map(knobs, points);
  return points;
}

namespace {

// What the other knobs stand at while one is told about.
Values standpoint(const std::vector<Knob>& knobs, const std::vector<Point>& points) {
  Values values;
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    const bool ran = std::any_of(points.begin(), points.end(),
                                 [&](const Point& point) { return point.values[k] == knobs[k].base; });
    values.push_back(ran || knobs[k].values.empty() ? knobs[k].base : knobs[k].values.back());
  }
  return values;
}

// The values of a knob that are told about: an ordered one's from small to large, another's from
// its base on.
Values told(const Knob& knob) {
  Values values = knob.values;
  if (!has_value(values, knob.base)) values.insert(values.begin(), knob.base);
  if (knob.ordered) {
    std::stable_sort(values.begin(), values.end(),
                     [](const std::string& a, const std::string& b) { return std::stod(a) < std::stod(b); });
  } else {
    std::stable_partition(values.begin(), values.end(),
                          [&](const std::string& value) { return value == knob.base; });
  }
  return values;
}

}  // namespace

std::vector<Step> steps(const std::vector<Knob>& knobs, const std::vector<Point>& points) {
  std::vector<Step> result;
  const Values stand = standpoint(knobs, points);
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    std::vector<std::size_t> line;  // points along this knob
    for (const std::string& value : told(knobs[k])) {
      Values wanted = stand;
      wanted[k] = value;
      const auto found = std::find_if(points.begin(), points.end(),
                                      [&](const Point& point) { return point.values == wanted; });
      if (found != points.end()) line.push_back(static_cast<std::size_t>(found - points.begin()));
    }
    for (std::size_t i = 1; i < line.size(); ++i)
      result.push_back({k, knobs[k].ordered ? line[i - 1] : line[0], line[i]});
  }
  return result;
}

}  // namespace caustics::study
