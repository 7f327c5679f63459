// Two folders of `render --dump`, compared attachment by attachment.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/compare/image_difference.hpp"

namespace caustics::app {

// What a folder's manifest.json says about one file.
struct DumpedAttachment {
  std::string name;    // "pass/attachment", which lines two folders up
  std::string format;  // as the manifest has it; "" where it leaves it out
  std::filesystem::path file;
};

// In the order of the passes. Throws Error (BadInput) where there is no manifest, it is none of a
// dump, a name stands twice, or a file lies outside of the folder.
std::vector<DumpedAttachment> read_manifest(const std::filesystem::path& folder);

// One attachment of both folders.
struct AttachmentDifference {
  std::string name;
  std::string mismatch;  // only in one folder, or of another format
  PlanesDifference planes;
  std::vector<std::string> looks_like;  // likenesses() of what is different

  Verdict verdict() const;
};

struct FolderDifference {
  // Worst first: those that cannot be compared, then by the share of values that fail, then by the
  // largest relative difference; ties in the order of the passes.
  std::vector<AttachmentDifference> attachments;
  // The first one that is different in the order of the passes: where a fault began. "" if none is.
  std::string first_different;

  Verdict verdict() const;
};

// Sees an attachment that is different while its planes are in memory. `in_a`: its file in the first folder.
using LookAtDifferent =
    std::function<void(const std::filesystem::path& in_a, const AttachmentDifference& attachment)>;

// Throws Error (BadInput) where an image cannot be read. Two images are in memory at a time, so the
// planes of the result are null.
FolderDifference compare_folders(const std::filesystem::path& a, const std::filesystem::path& b,
                                 const Tolerance& tolerance, const LookAtDifferent& look = {});

}  // namespace caustics::app
