#include "pipeline/gpu/process_memory.hpp"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

namespace caustics {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kKilobyte = 1024;  // what /proc calls kB

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool holds(std::string_view list, std::string_view word) {
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    if (list.substr(at, end - at) == word) return true;
    at = end + 1;
  }
  return false;
}

std::optional<std::uint64_t> parsed(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end == text.data()) return std::nullopt;  // "max", "unlimited"
  return number;
}

std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::string word;
  if (!(std::ifstream(file) >> word)) return std::nullopt;
  return parsed(word);
}

// The number behind a label such as "MemTotal:" at the head of a line, in kB.
std::optional<std::uint64_t> kilobytes_at(const fs::path& file, std::string_view label) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> words = words_of(line);
    if (words.size() >= 2 && words.front() == label) return parsed(words[1]);
  }
  return std::nullopt;
}

// proc(5): spaces and the like stand as \040 in mountinfo.
std::string unescaped(const std::string& text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '7'; };
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '\\' && i + 3 < text.size() && is_digit(text[i + 1]) &&
                        is_digit(text[i + 2]) && is_digit(text[i + 3]);
    if (!escape) {
      plain += text[i];
      continue;
    }
    plain += static_cast<char>((text[i + 1] - '0') * 64 + (text[i + 2] - '0') * 8 + (text[i + 3] - '0'));
    i += 3;
  }
  return plain;
}

// A mounted hierarchy that has the memory controller, or may have it.
struct Hierarchy {
  bool is_version_2 = false;
  fs::path shown;  // which of its groups is mounted, "/" for all
  fs::path where;  // the mount point
};

// Lines such as "35 31 0:32 / /sys/fs/cgroup/memory rw - cgroup cgroup rw,memory": the group and the mount
// point are the fourth and fifth word; behind a lone "-" stand the file system, its source and its options.
std::vector<Hierarchy> hierarchies(const fs::path& root) {
  std::vector<Hierarchy> found;
  std::ifstream stream(root / "proc/self/mountinfo");
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> words = words_of(line);
    const auto dash = std::find(words.begin(), words.end(), "-");
    if (words.size() < 5 || words.end() - dash < 2) continue;
    const bool version_2 = dash[1] == "cgroup2";
    const bool version_1 = dash[1] == "cgroup" && words.end() - dash > 3 && holds(dash[3], "memory");
    if (version_1 || version_2) found.push_back({version_2, unescaped(words[3]), unescaped(words[4])});
  }
  return found;
}

// The process's group: of version 2 in the line "0::PATH", of version 1 in "N:...,memory,...:PATH".
std::optional<fs::path> group_of_process(const fs::path& root, bool version_2) {
  std::ifstream stream(root / "proc/self/cgroup");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find(':');
    if (first == std::string::npos) continue;
    const std::size_t second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool is_it =
        version_2 ? line.substr(0, first) == "0" && controllers.empty() : holds(controllers, "memory");
    if (is_it) return fs::path(line.substr(second + 1));
  }
  return std::nullopt;
}

// A path such as /slice/job below the group that is mounted; the mount point itself for a group that lies
// outside of what is mounted, as in a container that has the host's names of groups.
fs::path below(const fs::path& group, const fs::path& shown) {
  fs::path relative = group.lexically_normal().lexically_relative(shown);
  if (relative.empty() || *relative.begin() == ".." || relative == ".") return {};
  return relative;
}

void lower(MemoryLimit& limit, const std::optional<std::uint64_t>& bytes, const std::string& whose) {
  if (bytes && *bytes < limit.bytes) limit = {*bytes, whose};
}

void lower_by_groups(MemoryLimit& limit, const fs::path& root, const Hierarchy& hierarchy) {
  const std::optional<fs::path> group = group_of_process(root, hierarchy.is_version_2);
  if (!group) return;
  const fs::path mounted = root / hierarchy.where.relative_path();
  fs::path part = below(*group, hierarchy.shown);
  while (true) {
    const fs::path name = part.empty() ? hierarchy.shown : hierarchy.shown / part;
    const std::string whose = "the control group " + name.lexically_normal().generic_string();
    // Only one version's files are there.
    for (const char* file : {"memory.max", "memory.high", "memory.limit_in_bytes"})
      lower(limit, number_in(mounted / part / file), whose);
    if (part.empty()) return;
    part = part.parent_path();
  }
}

// Lines such as "Max address space         unlimited            unlimited            bytes".
void lower_by_process(MemoryLimit& limit, const fs::path& root) {
  constexpr std::pair<std::string_view, const char*> kLimits[] = {{"Max address space", "ulimit -v"},
                                                                  {"Max data size", "ulimit -d"}};
  std::ifstream stream(root / "proc/self/limits");
  for (std::string line; std::getline(stream, line);) {
    for (const auto& [label, whose] : kLimits) {
      if (!line.starts_with(label)) continue;
      const std::vector<std::string> words = words_of(line.substr(label.size()));
      if (!words.empty()) lower(limit, parsed(words.front()), whose);
    }
  }
}

}  // namespace

MemoryLimit memory_limit(const fs::path& root) {
  MemoryLimit limit{std::uint64_t{8} << 30, "this machine"};
  if (const auto total = kilobytes_at(root / "proc/meminfo", "MemTotal:")) limit.bytes = *total * kKilobyte;
  for (const Hierarchy& hierarchy : hierarchies(root)) lower_by_groups(limit, root, hierarchy);
  lower_by_process(limit, root);
  return limit;
}

MemoryBudget memory_budget(const std::optional<std::uint64_t>& stated, const fs::path& root) {
  if (stated) return {*stated, "of --memory"};
  const MemoryLimit limit = memory_limit(root);
  return {limit.bytes / 4 * 3, "that " + limit.whose + " can spare"};
}

void return_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

ResidentMemory resident_memory(const fs::path& root) {
  const fs::path status = root / "proc/self/status";
  return {kilobytes_at(status, "VmRSS:").value_or(0) * kKilobyte,
          kilobytes_at(status, "VmHWM:").value_or(0) * kKilobyte};
}

}  // namespace caustics
