// --pictures: what a dump holds, to look at: a picture of each attachment with a line that says what its
// colours mean, all of them small on one sheet, and a page that shows them in turn.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/output/attachments.hpp"
#include "app/output/contact_sheet.hpp"
#include "app/output/dump_folder.hpp"

namespace caustics::app {

class DumpPictures {
 public:
  // Writes into the folder, which must live longer.
  explicit DumpPictures(DumpFolder& folder) : folder_(folder) {}
  // Writes STEM.png, and STEM.status.png where there are statuses. Returns a list of files and captions for
  // the manifest. `pass`: its label.
  nlohmann::ordered_json add(const std::string& pass, const Attachment& attachment, const std::string& stem);
  // Writes the sheet and the page.
  void finish();

 private:
  DumpFolder& folder_;
  ContactSheet sheet_;
  std::string figures_;  // of the page
};

}  // namespace caustics::app
