// What a study says on stdout: the front, the sentences, and what the truth is worth.
#pragma once
#include <string>

#include "app/study/study.hpp"

namespace caustics::app {

std::string report_text(const Study& study);

}  // namespace caustics::app
