// A study's rows as points of the error-time plot.
#pragma once
#include "lab/study/plot.hpp"
#include "lab/study/study.hpp"

namespace caustics::study {

// Relative L1 over the milliseconds of the caustic passes, a group a knob; rows without either, or with
// one of 0, are left out.
Plot plot_of(const Study& study);

// The plot as an SVG file of its own, dark on white; empty where there is nothing to plot.
std::string plot_file(const Study& study);

}  // namespace caustics::study
