// An attachment as a person can look at it: colours by what kind of thing it holds, and a line that says what
// they mean.
#pragma once
#include <string>
#include <vector>

#include "app/output/attachments.hpp"

namespace caustics::app {

struct AttachmentPicture {
  std::string part;     // of the attachment: "status", or "" for the first
  Image picture;        // the first three channels are display values; as large as the attachment
  std::string caption;  // one line: what the colours mean, their range, and what is not finite
};

// One, and a second one of the statuses where a channel holds such. Texels that are as they were cleared,
// where nothing was drawn, are chequered; what is not finite is magenta.
std::vector<AttachmentPicture> pictures_of(const Attachment& attachment);

}  // namespace caustics::app
