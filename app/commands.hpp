// The list of sub-commands, and the help that names them.
#pragma once
#include <span>

#include "app/shell/command.hpp"
#include "app/shell/help_page.hpp"

namespace caustics::app {

std::span<const Command> all_commands();
// What `caustics --help` says.
HelpPage program_help();

}  // namespace caustics::app
