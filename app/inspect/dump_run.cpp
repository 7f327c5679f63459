#include "app/inspect/dump_run.hpp"

#include <string_view>

#include "app/compare/folder_difference.hpp"
#include "app/json.hpp"
#include "app/output/image_planes.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

namespace {

// The channel that a plane of a dump holds, as channels_of names them; -1: none.
int channel_of(const std::string& plane) {
  if (plane == "Z") return 0;
  const auto at = std::string_view("RGBA").find(plane);
  return plane.size() == 1 && at != std::string_view::npos ? static_cast<int>(at) : -1;
}

Format format_of(const std::string& name, int channels) {
  for (const Format format : kAllFormats)
    if (format_name(format) == name) return format;
  return channels == 1 ? Format::R32F : channels == 2 ? Format::RG32F : Format::RGBA32F;
}

Image read_attachment(const DumpedAttachment& attachment, const std::string& format) {
  const ImagePlanes planes = read_planes(attachment.file);
  if (planes.planes.empty()) throw Error(ExitCode::BadInput, attachment.file.string() + ": has no channels");
  const ChannelView& first = planes.planes.front().view;
  Image image(format_of(format, static_cast<int>(planes.planes.size())), first.width, first.height);
  for (const Plane& plane : planes.planes) {
    const int channel = channel_of(plane.name);
    if (channel < 0 || channel >= image.channels()) continue;
    for (int y = 0; y < image.height(); ++y)  // files begin at the top
      for (int x = 0; x < image.width(); ++x)
        image.at(x, image.height() - 1 - y, channel) = plane.view.at(x, y);
  }
  return image;
}

// Its attachment of this name, as "pass/attachment".
const Json* find(const Json& run, const std::string& name) {
  for (const Json& attachment : run["attachments"]) {
    const Json& pass = run["passes"][attachment["pass"].get<std::size_t>()];
    if (pass["label"].get<std::string>() + "/" + attachment["texture"].get<std::string>() == name)
      return &attachment;
  }
  return nullptr;
}

std::string pass_label(const std::string& name) { return name.substr(0, name.rfind('/')); }

// The place of a pass in the run; a new one where it is not there yet.
std::size_t pass_in(Json& run, const Json& beside, const std::string& label) {
  for (std::size_t i = 0; i < run["passes"].size(); ++i)
    if (run["passes"][i]["label"] == label) return i;
  Json pass = {{"label", label}, {"name", label}, {"purpose", ""}, {"reason", ""}, {"light", Json()}};
  for (const Json& known : beside["passes"])
    if (known["label"] == label) pass = known;
  for (const char* unknown :
       {"milliseconds", "processor_milliseconds", "vertices", "primitives", "fragments", "samples_passed"})
    pass[unknown] = Json();
  pass["writes"] = Json::array();
  run["passes"].push_back(std::move(pass));
  return run["passes"].size() - 1;
}

}  // namespace

Json dump_run(const std::filesystem::path& folder, const Json& beside, Blobs& blobs) {
  Json run = beside;
  run["device"] = "a dump";
  for (const char* list : {"passes", "attachments", "histories", "lights", "meshes", "sweeps", "left_out"})
    run[list] = Json::array();
  for (const DumpedAttachment& dumped : read_manifest(folder)) {
    const Json* known = find(beside, dumped.name);
    const std::string format =
        !dumped.format.empty() || !known ? dumped.format : (*known)["format"].get<std::string>();
    const Image image = read_attachment(dumped, format);
    Json attachment = {{"kind", "scalar"}, {"meaning", ""}, {"channels", Json::array()}, {"codes", Json()}};
    if (known) attachment = *known;
    if (!known)
      for (int c = 0; c < image.channels(); ++c)
        attachment["channels"].push_back(
            {{"name", "RGBA"[c] + std::string()}, {"meaning", ""}, {"unit", ""}});
    const std::string name = one_line(dumped.name), label = pass_label(name);
    const std::size_t pass = pass_in(run, beside, label);
    attachment["id"] = run["attachments"].size();
    attachment["pass"] = pass;
    attachment["texture"] = name.substr(label.size() + 1);
    if (!known) attachment["label"] = attachment["texture"];
    attachment["name"] = known ? (*known)["name"] : attachment["texture"];
    attachment["format"] = format_name(image.shape.format);
    attachment["width"] = image.width();
    attachment["height"] = image.height();
    attachment["sha256"] = sha256(image);
    attachment["left_out"] = Json();
    const bool equal = known && (*known)["sha256"] == attachment["sha256"];
    if (!equal) attachment["data"] = blobs.add_floats(image.values, image.channels());
    run["passes"][pass]["writes"].push_back(attachment["id"]);
    run["attachments"].push_back(std::move(attachment));
  }
  return run;
}

}  // namespace caustics::app
