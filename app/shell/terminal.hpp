// Talk: everything that is not data goes to stderr through here.
#pragma once
#include <cstdio>
#include <string_view>

#include "pipeline/gpu/text.hpp"

namespace caustics::app {

// Is this stream a terminal that a person watches?
bool is_terminal(std::FILE* stream);
// Colours only there, and not under NO_COLOR or TERM=dumb.
bool has_colour(std::FILE* stream);

// "caustics: LINE" on stderr.
void complain(std::string_view line);

}  // namespace caustics::app
