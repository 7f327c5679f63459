#include "app/output/dump_pictures.hpp"

#include "app/json.hpp"
#include "app/output/attachment_picture.hpp"
#include "app/output/image_file.hpp"
#include "app/shell/atomic_file.hpp"
#include "lab/study/html.hpp"

namespace caustics::app {

namespace {

constexpr char kPageHead[] =
    "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Passes</title>\n"
    "<style>body{background:#1a1a1a;color:#ddd;font:15px sans-serif;margin:1em}figure{margin:0 0 2em}"
    "img{max-width:100%;min-width:min(256px,100%);image-rendering:pixelated}"
    "figcaption{margin-top:.4em}</style>\n"
    "<p>Every attachment right after its pass, in turn; contact_sheet.png has the first 300 of them small. "
    "Chequered: nothing was drawn. Magenta: NaN or infinite.</p>\n";
static_assert(ContactSheet::kMost == 300);

// A line of the page: what, by which pass, and how it is shown.
std::string figure(const std::string& file, const std::string& title, std::string_view meaning,
                   const std::string& caption) {
  using study::escaped;
  return "<figure><img src=\"" + escaped(file) + "\" alt=\"\"><figcaption><b>" + escaped(title) + "</b> " +
         escaped(meaning) + "<br>" + escaped(caption) + "</figcaption></figure>\n";
}

}  // namespace

Json DumpPictures::add(const std::string& pass, const Attachment& attachment, const std::string& stem) {
  Json list = Json::array();
  for (const AttachmentPicture& each : pictures_of(attachment)) {
    const std::string file = stem + (each.part.empty() ? "" : "." + each.part) + ".png";
    write_png(folder_.file(file), each.picture);
    sheet_.add(each.picture, pass, attachment.texture.name + (each.part.empty() ? "" : " " + each.part));
    figures_ += figure(file, pass + " / " + attachment.texture.name, attachment.meaning, each.caption);
    list.push_back({{"file", file}, {"caption", each.caption}});
  }
  return list;
}

void DumpPictures::finish() {
  if (!sheet_.empty()) write_png(folder_.file(kSheetFile), sheet_.picture());
  write_atomically(folder_.file(kPageFile), kPageHead + figures_ + "</html>\n");
}

}  // namespace caustics::app
