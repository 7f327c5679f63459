// Which settings a study runs: the product of all knobs, or one knob at a time. No rendering here.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace caustics::study {

// A `-D` key that is varied. Texts are as the program writes them ("0.7", not "0.70"), each once.
struct Knob {
  std::string key;
  std::vector<std::string> values;
  std::string base;      // of the frame's own options; need not be among the values
  bool ordered = false;  // all of them are numbers
};

// The key of a knob that is no setting: which effect is left out. Its base leaves out none.
inline constexpr char kWithout[] = "without";
inline constexpr char kNothing[] = "nothing";

// One setting to run: a value for each knob.
struct Point {
  std::vector<std::string> values;  // by the knobs
  std::string group;                // why it is there: "base", a key, "grid, map", or "all" of a product
  bool operator==(const Point&) const = default;
};

// Two points that differ in one knob.
struct Step {
  std::size_t knob = 0;
  std::size_t from = 0, to = 0;  // indices of points
  bool operator==(const Step&) const = default;
};

// How many points expand() makes at most; never wraps round, `limit` + 1 stands for all beyond it.
std::size_t count_points(const std::vector<Knob>& knobs, bool cross, std::size_t limit);

// `cross`: the product of all values, the last knob changing fastest. Otherwise the base, then each
// knob's values beside the others' base, and the product of the knobs `grid` and `map` where there
// are both. No point twice.
std::vector<Point> expand(const std::vector<Knob>& knobs, bool cross);

// What is told in sentences: of an ordered knob each value and the next, of another its base (where
// there is none, its first value) and each other value; all other knobs at their base, or where
// that was not run, at their last value.
std::vector<Step> steps(const std::vector<Knob>& knobs, const std::vector<Point>& points);

}  // namespace caustics::study
