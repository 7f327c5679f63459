// How much memory this process may take, and how much it takes: what Linux says of the machine, of the
// control groups that the process is in, and of the process's own limits.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace caustics {

struct MemoryLimit {
  std::uint64_t bytes = 0;
  std::string whose;  // "this machine", "the control group /system.slice", "ulimit -v"
};

// The lowest limit that holds for the process:
// - the machine's memory (MemTotal of /proc/meminfo; 8 GiB where that cannot be read);
// - memory.max and memory.high (version 2) or memory.limit_in_bytes (version 1) of the process's own control
//   group and of every group above it, as far up as the hierarchy is mounted. Sources: cgroups(7); proc(5)
//   for /proc/self/cgroup and /proc/self/mountinfo;
// - its soft limits of address space and of data (setrlimit(2), as /proc/self/limits has them).
// `root`: the folder in which `proc` and the mounted hierarchies lie.
MemoryLimit memory_limit(const std::filesystem::path& root = "/");

// What a run may take at its most.
struct MemoryBudget {
  std::uint64_t bytes = 0;
  std::string whose;  // goes on after a size: "that this machine can spare", "of --memory"
};

// As much as the user has stated; else three quarters of the limit, because other programs, the system and
// what no estimate foresees need some.
MemoryBudget memory_budget(const std::optional<std::uint64_t>& stated,
                           const std::filesystem::path& root = "/");

// Resident memory of this process, bytes (VmRSS and VmHWM of /proc/self/status); 0 where the system does not
// say.
struct ResidentMemory {
  std::uint64_t now = 0, peak = 0;
};
ResidentMemory resident_memory(const std::filesystem::path& root = "/");

// Gives what the heap keeps of freed memory back to the system, so that resident memory is what is in use.
// Takes milliseconds; does nothing where the C library is not glibc.
void return_freed_memory();

}  // namespace caustics
