#include "app/compare/folder_difference.hpp"

#include <algorithm>
#include <array>
#include <fstream>

#include "app/compare/likeness.hpp"
#include "app/json.hpp"
#include "app/shell/interrupt.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

namespace fs = std::filesystem;
[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Error(ExitCode::BadInput, path.string() + ": " + why);
}

std::string text_of(const fs::path& manifest, const Json& entry, const char* key) {
  const auto found = entry.find(key);
  if (found == entry.end() || !found->is_string()) {
    refuse(manifest, std::string("an attachment has no text '") + key + "'");
  }
  return found->get<std::string>();
}

DumpedAttachment attachment_of(const fs::path& manifest, const Json& entry) {
  if (!entry.is_object()) refuse(manifest, "an attachment is no object");
  const fs::path file = text_of(manifest, entry, "file");
  if (file.empty() || file != file.filename()) {
    refuse(manifest, "'" + file.string() + "' is no file of this folder");
  }
  return {text_of(manifest, entry, "pass") + "/" + text_of(manifest, entry, "attachment"),
          entry.contains("format") ? text_of(manifest, entry, "format") : "", manifest.parent_path() / file};
}

const DumpedAttachment* find(const std::vector<DumpedAttachment>& list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const DumpedAttachment& each) { return each.name == name; });
  return found == list.end() ? nullptr : &*found;
}

std::string mismatch_of(const DumpedAttachment* a, const DumpedAttachment* b) {
  if (b == nullptr) return "only in A";
  if (a == nullptr) return "only in B";
  if (a->format.empty() || b->format.empty() || a->format == b->format) return "";
  return "A is " + a->format + ", B is " + b->format;
}

AttachmentDifference compare_attachment(const DumpedAttachment* a, const DumpedAttachment* b,
                                        const Tolerance& tolerance, const LookAtDifferent& look) {
  AttachmentDifference result;
  result.name = (a != nullptr ? a : b)->name;
  result.mismatch = mismatch_of(a, b);
  if (!result.mismatch.empty()) return result;
  const ImagePlanes planes_a = read_planes(a->file), planes_b = read_planes(b->file);
  result.planes = compare_planes(planes_a, planes_b, tolerance);
  if (result.verdict() == Verdict::Different) {
    result.looks_like = likenesses(result.planes);
    if (look) look(a->file, result);
  }
  for (ChannelDifference& channel : result.planes.channels) channel.a = channel.b = nullptr;
  return result;
}

// What the order of a FolderDifference goes by; larger is worse.
std::array<double, 3> badness(const AttachmentDifference& attachment) {
  bool mismatch = !attachment.mismatch.empty();
  double relative = 0.0;
  for (const ChannelDifference& channel : attachment.planes.channels) {
    mismatch = mismatch || !channel.mismatch.empty();
    relative = std::max(relative, channel.values.relative.largest);
  }
  const auto values = static_cast<double>(std::max<std::size_t>(attachment.planes.values(), 1));
  const auto failing = static_cast<double>(attachment.planes.failing_values());
  return {mismatch ? 1.0 : 0.0, failing / values, relative};
}

}  // namespace

std::vector<DumpedAttachment> read_manifest(const fs::path& folder) {
  const fs::path manifest = folder / "manifest.json";
  std::error_code error;
  if (!fs::is_regular_file(manifest, error)) {
    refuse(folder, "has no manifest.json, which 'caustics render --dump' writes");
  }
  std::ifstream stream(manifest, std::ios::binary);
  const Json document = Json::parse(stream, nullptr, false);
  if (!document.is_object() || !document.contains("attachments") || !document["attachments"].is_array()) {
    refuse(manifest, "is no JSON with a list 'attachments'");
  }
  std::vector<DumpedAttachment> attachments;
  for (const Json& entry : document["attachments"]) {
    DumpedAttachment attachment = attachment_of(manifest, entry);
    if (find(attachments, attachment.name) != nullptr) {
      refuse(manifest, "'" + attachment.name + "' stands there twice");
    }
    attachments.push_back(std::move(attachment));
  }
  return attachments;
}

Verdict AttachmentDifference::verdict() const {
  return mismatch.empty() ? planes.verdict() : Verdict::Different;
}

Verdict FolderDifference::verdict() const {
  Verdict worst = Verdict::Equal;
  for (const AttachmentDifference& each : attachments) worst = std::max(worst, each.verdict());
  return worst;
}

FolderDifference compare_folders(const fs::path& a, const fs::path& b, const Tolerance& tolerance,
                                 const LookAtDifferent& look) {
  const std::vector<DumpedAttachment> list_a = read_manifest(a), list_b = read_manifest(b);
  FolderDifference result;
  for (const DumpedAttachment& each : list_a) {
    result.attachments.push_back(compare_attachment(&each, find(list_b, each.name), tolerance, look));
    stop_if_interrupted();
  }
  for (const DumpedAttachment& each : list_b) {
    if (find(list_a, each.name) == nullptr) {
      result.attachments.push_back(compare_attachment(nullptr, &each, tolerance, look));
    }
  }
  for (const AttachmentDifference& each : result.attachments) {
    if (result.first_different.empty() && each.verdict() == Verdict::Different) {
      result.first_different = each.name;
    }
  }
  std::stable_sort(result.attachments.begin(), result.attachments.end(),
                   [](const AttachmentDifference& left, const AttachmentDifference& right) {
                     return badness(left) > badness(right);
                   });
  return result;
}

}  // namespace caustics::app
