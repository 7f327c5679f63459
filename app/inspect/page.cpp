#include "app/inspect/page.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "app/json.hpp"
#include "app/output/stats.hpp"
#include "lab/study/html.hpp"

namespace caustics::app {

namespace {

// In a script element "</script" and "<!--" would end it or change what follows; in JSON every < may be
// written as an escape.
std::string inside_script(const Json& json) {
  const std::string text = json_text(json, -1);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

std::string blob_elements(const Blobs& blobs) {
  std::string elements;
  for (std::size_t i = 0; i < blobs.texts().size(); ++i)
    elements += "<script type=\"text/plain\" id=\"blob-" + std::to_string(i) + "\">" + blobs.texts()[i] +
                "</script>\n";
  return elements;
}

}  // namespace

std::string inspect_page(const std::string& title, const Json& recording, const Blobs& blobs) {
  const std::array<std::pair<std::string_view, std::string>, 5> parts = {
      {{"@TITLE@", study::escaped(title)},
       {"@STYLE@", kPageStyle},
       {"@RECORDING@", inside_script(recording)},
       {"@BLOBS@", blob_elements(blobs)},
       {"@SCRIPT@", kPageScript}}};
  std::string page;
  std::string_view frame = kPageFrame;
  // One after the other through the frame: a part may hold what looks like a place for another.
  while (!frame.empty()) {
    std::size_t nearest = std::string_view::npos, which = 0;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (const std::size_t at = frame.find(parts[i].first); at < nearest) nearest = at, which = i;
    page += frame.substr(0, nearest);
    if (nearest == std::string_view::npos) break;
    page += parts[which].second;
    frame.remove_prefix(nearest + parts[which].first.size());
  }
  return page;
}

}  // namespace caustics::app
