// A study's results in words: one sentence for each step of a knob.
#pragma once
#include <string>
#include <vector>

#include "lab/study/row.hpp"

namespace caustics::study {

// "-12 %", "+70 %", "+0 %"; "x 3.4" from twice as much on; "" where `from` is not above 0.
std::string change_text(double from, double to);

// "grid from 256 to 512: error -12 % (0.0038 to 0.0033), time +70 % (22 to 38 ms)". The error is
// relative L1, the time that of the caustic passes. Times whose frames overlap are said to be alike.
std::string step_sentence(const Knob& knob, std::size_t knob_index, const StudyRow& from, const StudyRow& to);

// "grid 256, map 128": the knobs that differ from their base, or "base".
std::string point_text(const std::vector<Knob>& knobs, const Point& point);
// The same for a file's name: "grid256_map128".
std::string point_file(const std::vector<Knob>& knobs, const Point& point);

// Three significant digits, whole numbers from 100 on: "0.00332", "22.1", "1840".
std::string short_number(double value);
// Of what is about 1: "0.9987", "1.0012".
std::string ratio_text(const std::optional<double>& value);
// Like short_number, "n/a" for none.
std::string figure_text(const std::optional<double>& value);

}  // namespace caustics::study
