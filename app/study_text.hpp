// What a study says on stdout: the front, the sentences, and what the truth is worth.
#pragma once
#include <string>

#include "lab/study/study.hpp"

namespace caustics::app {

std::string report_text(const study::Study& study);

}  // namespace caustics::app
