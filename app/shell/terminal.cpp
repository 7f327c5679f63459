#include "app/shell/terminal.hpp"

#include <unistd.h>

#include <cstdlib>

namespace caustics::app {

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) != 0; }

bool has_colour(std::FILE* stream) {
  if (!is_terminal(stream) || std::getenv("NO_COLOR") != nullptr) return false;
  const char* term = std::getenv("TERM");
  return term == nullptr || std::string_view(term) != "dumb";
}

void complain(std::string_view line) { std::fprintf(stderr, "caustics: %s\n", one_line(line).c_str()); }

}  // namespace caustics::app
