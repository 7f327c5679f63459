#include <set>

#include "app/commands.hpp"
#include "app/completion/completed.hpp"
#include "app/shell/version.hpp"

namespace caustics::app {

namespace {

// As roff prints it: dashes stay dashes, and no line is taken for a request.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) result += "\\&";
    if (c == '-' || c == '\\') result += c == '-' ? "\\" : "\\e";
    if (c != '\\') result += c;
  }
  return result;
}

std::string entry(const HelpEntry& each) {
  std::string about = each.about.meaning;
  if (!each.about.range.empty()) about += (about.empty() ? "" : "; ") + each.about.range;
  if (!each.about.by_default.empty()) about += " (default " + each.about.by_default + ")";
  std::string names = each.names;
  if (const std::size_t comma = names.find(','); comma != std::string::npos) names.insert(comma + 1, " ");
  const std::string value = each.value.empty() ? "" : " \\fI" + plain(each.value) + "\\fR";
  return ".TP\n\\fB" + plain(names) + "\\fR" + value + "\n" + plain(about) + "\n";
}

// Rows that an earlier command has are left out.
std::string group(const HelpGroup& group, std::set<std::string>& said) {
  std::string text;
  for (const HelpEntry& each : group.entries)
    if (std::string row = entry(each); said.insert(row).second) text += row;
  return text.empty() ? text : ".SS " + plain(group.heading) + "\n" + text;
}

std::string literal(const std::string& lines) { return ".nf\n" + plain(lines) + ".fi\n"; }

}  // namespace

std::string man_page(const std::vector<CompletedCommand>& commands) {
  const HelpPage program = program_help();
  std::string text = ".TH CAUSTICS 1 \"\" \"caustics " + version() + "\"\n.SH NAME\ncaustics \\- " +
                     plain(program.purpose.substr(program.purpose.find(' ') + 1)) +
                     "\n.SH SYNOPSIS\n.B caustics\n[\\fICOMMAND\\fR] [\\fIOPTIONS\\fR] \\fISCENE\\fR\n"
                     ".SH EXAMPLES\n" +
                     literal(program.examples);
  std::set<std::string> said;
  for (const std::vector<HelpGroup>* groups : {&program.groups, &program.lists})
    for (const HelpGroup& each : *groups) text += group(each, said);
  text += ".PP\nAn option of an earlier command is not repeated.\n";
  for (const CompletedCommand& command : commands) {
    text += ".SH caustics " + plain(command.name) + "\n" + plain(command.page.purpose) + "\n" +
            literal(command.page.examples);
    for (const HelpEntry& each : command.page.positionals) text += entry(each);
    for (const std::vector<HelpGroup>* groups : {&command.page.groups, &command.page.lists})
      for (const HelpGroup& each : *groups) text += group(each, said);
  }
  return text;
}

}  // namespace caustics::app
