#include "pipeline/gpu/fault.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

int caustics_fault = 0;

namespace {

unsigned char reached_here[kFaultPlaces];

// FNV-1a without the sign bit, as in faults.py. Before anything else is initialised.
[[gnu::constructor(101)]] void choose_fault() {
  // A file of kFaultPlaces bytes that processes share: what ends by a signal has left its marks, too.
  if (const char* file = std::getenv("CAUSTICS_REACHED"); file != nullptr && *file != '\0') {
    const int marks = open(file, O_RDWR | O_CLOEXEC);
    void* memory =
        marks < 0 ? MAP_FAILED : mmap(nullptr, kFaultPlaces, PROT_READ | PROT_WRITE, MAP_SHARED, marks, 0);
    if (memory != MAP_FAILED) caustics_reached = static_cast<unsigned char*>(memory);
    if (marks >= 0) close(marks);
  }
  const char* name = std::getenv("CAUSTICS_FAULT");
  if (name == nullptr || *name == '\0') return;
  std::uint32_t hash = 2166136261u;
  for (; *name != '\0'; ++name) hash = (hash ^ static_cast<unsigned char>(*name)) * 16777619u;
  caustics_fault = static_cast<int>(hash & 0x7fffffffu);
}

}  // namespace

unsigned char* caustics_reached = reached_here;

// fault_script.py says the same.
std::string fault_script() {
  return "const caustics_reached = new Set();\n"
         "const FAULT = (number) => { caustics_reached.add(number); return number === " +
         std::to_string(caustics_fault) +
         "; };\n"
         "const altered = (value) => /[0-9]/.test(`${value}`) ? `${value}`.replace(/[0-9]/, (digit) => "
         "(+digit + "
         "1) % 10)\n"
         "  : `?${[...`${value}`].reverse().join(\"\")}`;\n";
}
