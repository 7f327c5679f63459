#include "app/output/report_folder.hpp"

#include <fstream>

#include "app/json.hpp"
#include "app/shell/version.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

namespace fs = std::filesystem;

namespace {

// Did this program write it, in whatever version?
bool is_mark(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const Json document = Json::parse(in, nullptr, false);
  if (!document.is_object() || !document.contains("program") || !document["program"].is_string())
    return false;
  const std::string ours = version_line();
  return document["program"].get<std::string>().starts_with(ours.substr(0, ours.find(' ') + 1));
}

}  // namespace

bool make_report_folder(const fs::path& folder, const std::string& mark,
                        const std::function<bool(const fs::path&)>& replaces) {
  std::error_code error;
  const bool made = fs::create_directories(folder, error);
  if (error) throw Error(ExitCode::CannotWrite, one_line(folder.string()) + ": " + error.message());
  if (is_mark(folder / mark)) return made;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (replaces(entry.path()))
      throw Error(ExitCode::CannotWrite, one_line(entry.path().string()) +
                                             ": is not of an earlier report, which " + mark +
                                             " would show; name another folder, or move the file away");
  return made;
}

}  // namespace caustics::app
