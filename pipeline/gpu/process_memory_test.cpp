#include "pipeline/gpu/process_memory.hpp"

#include <unistd.h>

#include <fstream>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// A made-up root folder, which goes when the test ends. Its machine has 1,000,000 kB.
struct MadeUpRoot {
  std::filesystem::path path;

  MadeUpRoot() {
    static int count = 0;
    path = std::filesystem::temp_directory_path() /
           ("caustics_root_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    write("proc/meminfo", "MemTotal:        1000000 kB\nMemFree: 5 kB\n");
  }
  MadeUpRoot(const MadeUpRoot&) = delete;
  MadeUpRoot& operator=(const MadeUpRoot&) = delete;
  ~MadeUpRoot() { std::filesystem::remove_all(path); }

  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((path / file).parent_path());
    std::ofstream(path / file) << text;
  }
  MemoryLimit limit() const { return memory_limit(path); }
};

constexpr char kVersion2[] = "30 23 0:26 / /sys/fs/cgroup rw,nosuid - cgroup2 cgroup2 rw,nsdelegate\n";
constexpr char kVersion1[] =
    "31 27 0:28 / /sys/fs/cgroup rw - tmpfs tmpfs rw\n"
    "32 31 0:29 / /sys/fs/cgroup/cpu rw shared:9 - cgroup cgroup rw,cpu\n"
    "35 31 0:32 / /sys/fs/cgroup/memory rw shared:10 - cgroup cgroup rw,memory\n";

}  // namespace

TEST_CASE("Without control groups the limit of memory is the machine's") {
  const MadeUpRoot root;
  CHECK(root.limit().bytes == 1'024'000'000);
  CHECK(root.limit().whose == "this machine");
  std::filesystem::remove(root.path / "proc/meminfo");
  CHECK(root.limit().bytes == std::uint64_t{8} << 30);
}

TEST_CASE("Of control groups of version 2 every level's memory.max and memory.high hold") {
  const MadeUpRoot root;
  root.write("proc/self/cgroup", "0::/system.slice/job.scope\n");
  root.write("proc/self/mountinfo", kVersion2);
  root.write("sys/fs/cgroup/system.slice/job.scope/memory.max", "max\n");
  root.write("sys/fs/cgroup/system.slice/job.scope/memory.high", "max\n");
  CHECK(root.limit().bytes == 1'024'000'000);
  root.write("sys/fs/cgroup/system.slice/memory.max", "300000000\n");
  CHECK(root.limit().bytes == 300'000'000);
  CHECK(root.limit().whose == "the control group /system.slice");
  root.write("sys/fs/cgroup/system.slice/job.scope/memory.high", "200000000\n");
  CHECK(root.limit().bytes == 200'000'000);
  CHECK(root.limit().whose == "the control group /system.slice/job.scope");
  root.write("sys/fs/cgroup/system.slice/job.scope/memory.max", "100000000\n");
  CHECK(root.limit().bytes == 100'000'000);
  root.write("sys/fs/cgroup/other.slice/memory.max", "5\n");  // the process is not in it
  CHECK(root.limit().bytes == 100'000'000);
}

TEST_CASE("Of control groups of version 1 the memory controller's hierarchy holds") {
  const MadeUpRoot root;
  root.write("proc/self/cgroup", "4:cpu:/elsewhere\n3:cpuset,memory:/slurm/job 7/step\n0::/\n");
  root.write("proc/self/mountinfo", kVersion1);
  root.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  root.write("sys/fs/cgroup/cpu/elsewhere/memory.limit_in_bytes", "5\n");
  CHECK(root.limit().bytes == 1'024'000'000);
  root.write("sys/fs/cgroup/memory/slurm/job 7/memory.limit_in_bytes", "400000000\n");
  CHECK(root.limit().bytes == 400'000'000);
  CHECK(root.limit().whose == "the control group /slurm/job 7");
}

TEST_CASE("Where both versions are mounted, the lower limit holds") {
  const MadeUpRoot root;
  root.write("proc/self/cgroup", "4:memory:/a\n0::/b\n");
  root.write("proc/self/mountinfo",
             "35 31 0:32 / /sys/fs/cgroup/memory rw - cgroup cgroup rw,memory\n"
             "41 31 0:38 / /sys/fs/cgroup/unified rw - cgroup2 cgroup2 rw\n");
  root.write("sys/fs/cgroup/memory/a/memory.limit_in_bytes", "400000000\n");
  root.write("sys/fs/cgroup/unified/b/memory.max", "500000000\n");
  CHECK(root.limit().whose == "the control group /a");
  root.write("sys/fs/cgroup/unified/b/memory.high", "300000000\n");
  CHECK(root.limit().whose == "the control group /b");
}

TEST_CASE("A container that has the host's names of groups finds its own") {
  const MadeUpRoot root;
  root.write("proc/self/cgroup", "0::/docker/abc/inner\n");
  root.write("proc/self/mountinfo", "30 23 0:26 /docker/abc /mnt/my\\040groups ro - cgroup2 cgroup2 rw\n");
  root.write("mnt/my groups/memory.max", "700000000\n");
  CHECK(root.limit().bytes == 700'000'000);
  CHECK(root.limit().whose == "the control group /docker/abc");
  root.write("mnt/my groups/inner/memory.max", "600000000\n");
  CHECK(root.limit().bytes == 600'000'000);
  // A group outside of what is mounted: only what is mounted can be read.
  root.write("proc/self/cgroup", "0::/../other\n");
  CHECK(root.limit().bytes == 700'000'000);
}

TEST_CASE("The process's own limits of address space and of data hold") {
  const MadeUpRoot root;
  root.write("proc/self/limits",
             "Limit                     Soft Limit           Hard Limit           Units     \n"
             "Max data size             unlimited            unlimited            bytes     \n"
             "Max address space         unlimited            unlimited            bytes     \n");
  CHECK(root.limit().bytes == 1'024'000'000);
  root.write("proc/self/limits",
             "Max data size             200000000            unlimited            bytes     \n"
             "Max address space         unlimited            unlimited            bytes     \n");
  CHECK(root.limit().bytes == 200'000'000);
  CHECK(root.limit().whose == "ulimit -d");
  root.write("proc/self/limits",
             "Max address space         100000000            unlimited            bytes     \n");
  CHECK(root.limit().whose == "ulimit -v");
}

TEST_CASE("The budget of memory is what the user states, else three quarters of the limit") {
  const MadeUpRoot root;
  CHECK(memory_budget({}, root.path).bytes == 768'000'000);
  CHECK(memory_budget({}, root.path).whose == "that this machine can spare");
  CHECK(memory_budget(123, root.path).bytes == 123);
  CHECK(memory_budget(123, root.path).whose == "of --memory");
}

TEST_CASE("Resident memory is what the system says") {
  const MadeUpRoot root;
  root.write("proc/self/status", "Name:\tx\nVmHWM:\t    3000 kB\nVmRSS:\t    2000 kB\n");
  CHECK(resident_memory(root.path).now == 2'048'000);
  CHECK(resident_memory(root.path).peak == 3'072'000);
  std::filesystem::remove(root.path / "proc/self/status");
  CHECK(resident_memory(root.path).peak == 0);
}
